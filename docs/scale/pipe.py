"""Pipes every line of a text file through a command by Apache Spark in local mode: pipe.py COMMAND INPUT OUTPUT."""

import sys

from pyspark import SparkContext

command, source, target = sys.argv[1:]
context = SparkContext("local[*]", "curveto batch")
context.textFile(source).pipe(command, checkCode=True).saveAsTextFile(target)
context.stop()
