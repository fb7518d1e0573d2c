"""Asks the readers that others use what they find in our files: ezdxf for DXF, fontTools for UFO glyphs.

The first argument is the program. Ends with 1 and says why where a file is not what JSON states.
"""

import io
import json
import subprocess
import sys

import ezdxf
from fontTools.pens.recordingPen import RecordingPointPen
from fontTools.ufoLib.glifLib import readGlyphFromString

CURVETO = sys.argv[1]

SHAPES = [
    "circle 50",
    "circle 125 -n 9 --center 3,-4",
    "circle 50 -m quadratic-minimax -n 6",
    "ellipse 300 200 --rotation 15 --center 100,50 -n 7",
    "arc 40 10 --start -20 --sweep 250 --rotation 20",
    "spline --points 0,0_10,0_12,5_3,8 --ends cyclic",
]


def run(words):
    arguments = [word.replace("_", " ") for word in words.split()]
    return subprocess.run([CURVETO, *arguments], check=True, capture_output=True, text=True).stdout


def check(condition, what):
    if not condition:
        sys.exit(f"{what} is not what was stated")


def drawing(words):
    """The modelspace of a DXF file that ezdxf reads and audits without a word."""
    document = ezdxf.read(io.StringIO(run(f"{words} -f dxf")))
    audit = document.audit()
    check(document.dxfversion == "AC1015", f"the version of {words}")
    check(not audit.errors and not audit.fixes, f"{words}: {audit.errors} {audit.fixes}")
    return list(document.modelspace())


def points(words, precision):
    """The control points of JSON, shared ends once."""
    segments = json.loads(run(f"{words} -f json {precision}"))["segments"]
    chain = [segments[0]["points"][0]]
    for segment in segments:
        chain += segment["points"][1:]
    return [tuple(point) for point in chain]


def splines():
    for words in SHAPES:
        (spline,) = drawing(words)
        check(spline.dxftype() == "SPLINE", words)
        found = [(float(x), float(y)) for x, y, _ in spline.control_points]
        check(found == points(words, "-p auto"), f"the control points of {words} by ezdxf")
        # ezdxf takes the B-spline apart into Béziers by itself.
        pieces = list(spline.construction_tool().bezier_decomposition())
        check(len(pieces) == len(spline.control_points) // spline.dxf.degree, f"the segments of {words}")


def exact():
    (arc,) = drawing("arc 10 --center 1,2 --start 30 --sweep -100")
    check(arc.dxftype() == "ARC", "an arc")
    check((arc.dxf.radius, arc.dxf.start_angle, arc.dxf.end_angle) == (10, 290, 30), "an arc")
    (polyline,) = drawing("arc --from 0,0 --to 10,0 --bulge -0.4")
    check(list(polyline.get_points("xyb")) == [(0, 0, -0.4), (10, 0, 0)], "a bulge")
    (line,) = drawing("arc --from 0,0 --to 10,5 --bulge 0")
    check((line.dxf.start, line.dxf.end) == ((0, 0, 0), (10, 5, 0)), "a line")
    layers = {entity.dxf.layer for entity in drawing("sphere 100")}
    check(layers == {"outline", "back", "front"}, "the layers of a sphere")


def glyphs():
    for words in SHAPES:
        pen = RecordingPointPen()
        readGlyphFromString(run(f"{words} -f glif"), pointPen=pen, validate=True)
        found = [args for name, args, _ in pen.value if name == "addPoint"]
        stated = points(words, "-p 0")
        if stated[0] == stated[-1]:
            stated = stated[:-1]
        check([tuple(args[0]) for args in found] == stated, f"the points of {words} by fontTools")
        check(all(isinstance(x, int) for args in found for x in args[0]), f"the grid of {words}")


splines()
exact()
glyphs()
print(f"{len(SHAPES)} shapes read by ezdxf {ezdxf.__version__} and fontTools")
