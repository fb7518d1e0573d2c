//! Words that people bring from other tools, and what serves instead.

/// Flags that people try, the commands that they try them on (all where there is none), and what serves instead.
pub(super) const FLAGS: [(&[&str], &[&str], &str); 33] = [
    (
        &[
            "--clockwise",
            "--cw",
            "--ccw",
            "--counterclockwise",
            "--counter-clockwise",
            "--anticlockwise",
            "--anti-clockwise",
        ],
        &[],
        "--reverse runs the other way round; positive angles turn from +x towards +y, clockwise on an SVG canvas",
    ),
    (
        &["--radius", "-r", "--r"],
        &["circle", "sphere"],
        "the radius stands alone: curveto circle 50",
    ),
    (
        &["--radius", "--radii", "--rx", "--ry", "-r"],
        &["ellipse"],
        "the radii stand alone: curveto ellipse 30 20",
    ),
    (
        &["-j", "--jobs"],
        &[],
        "one shape takes one thread; batch and convert take -j",
    ),
    (
        &["-i", "--inplace"],
        &["convert"],
        "--in-place replaces each file",
    ),
    (
        &["--dry-run", "-d", "--dryrun"],
        &["convert"],
        "--check writes nothing and lists the files with something to do",
    ),
    (
        &["--stdout", "-c"],
        &["convert"],
        "the result of one file goes to standard output by itself; --in-place and --out-dir DIR take several",
    ),
    (
        &["-f", "--format"],
        &["procset"],
        "it prints PostScript and nothing else",
    ),
    (
        &["--cx", "--cy", "-c", "--x", "--y"],
        &[],
        "--center X,Y says where the centre lies",
    ),
    (
        &["--width", "--height", "-w", "-h"],
        &[],
        "--size WxH sets the size of a picture, --stroke-width that of its lines",
    ),
    (
        &["--color", "--colour"],
        &[],
        "--stroke colours the line, --fill the inside",
    ),
    (
        &["--decimals", "--digits", "--round"],
        &[],
        "-p sets the decimals",
    ),
    (
        &[
            "--circle",
            "--ellipse",
            "--arc",
            "--path",
            "--batch",
            "--convert",
        ],
        &[],
        "commands have no dashes: curveto circle 50",
    ),
    (
        &["--kappa", "--magic", "--k", "-k"],
        &[],
        "--handle K is the length of the handles on the unit circle; -m names a method",
    ),
    (
        &["--flatness", "--error", "--epsilon", "--accuracy", "--tol"],
        &[],
        "-t sets the tolerance, how far a curve may stray",
    ),
    (
        &["--steps", "--count", "--points", "--pieces", "--parts"],
        &[],
        "-n sets the number of segments",
    ),
    (
        &[
            "--svg", "--json", "--png", "--ps", "--eps", "--pdf", "--dxf", "--tikz", "--type",
        ],
        &[],
        "-f names the format, or the extension of -o does: -f svg, -o circle.svg",
    ),
    (
        &[
            "--end",
            "--sweep",
            "--from",
            "--to",
            "--angle",
            "--start-angle",
            "--end-angle",
        ],
        &["circle", "ellipse"],
        "a part of one is an arc: curveto arc 50 --start 0 --end 90",
    ),
    (
        &["--start-angle", "--end-angle", "--angle"],
        &["arc"],
        "angles have flags: curveto arc 50 --start 0 --end 90",
    ),
    (
        &["--rotation", "--rotate", "--angle"],
        &["circle", "sphere"],
        "--start says where the first joint of a circle lies, --view how a sphere is seen",
    ),
    (
        &["--phi", "--tilt"],
        &["ellipse", "arc"],
        "--rotation turns an ellipse",
    ),
    (
        &["--closed", "--close", "--cyclic"],
        &["spline"],
        "--ends cyclic closes it",
    ),
    (
        &["--closed", "--close"],
        &[],
        "whole turns are closed by themselves; --open leaves the closing operator out",
    ),
    (&["--silent"], &[], "-q silences notes"),
    (
        &["--file", "--out", "--outfile", "--save"],
        &[
            "circle", "ellipse", "arc", "conic", "path", "sphere", "spline",
        ],
        "-o FILE says where the output goes",
    ),
    (
        &["-m", "--method", "--id"],
        &["methods"],
        "the id stands alone: curveto methods minimax",
    ),
    (
        &["--quadratic", "--quadratics", "--cubic"],
        &[],
        "-m names a method: quadratic-minimax draws quadratics; 'curveto methods' lists them",
    ),
    (
        &["--radians", "--degrees", "--rad", "--deg"],
        &[],
        "angles take units: 90, 90deg, 1.57rad, 100grad, 0.25turn",
    ),
    (
        &["--scale", "--translate"],
        &[],
        "--transform 'scale(2) translate(5,0)' takes an SVG transform list",
    ),
    (
        &["-r", "-R", "--recursive"],
        &["convert"],
        "folders are walked by themselves",
    ),
    (
        &["--threads"],
        &["batch", "convert"],
        "-j sets the number of threads",
    ),
    (
        &["--input", "-i"],
        &["batch"],
        "the file stands alone: curveto batch shapes.txt",
    ),
    (
        &["--algorithm", "--list-methods", "--methods"],
        &[],
        "-m names a method; 'curveto methods' lists them",
    ),
];

/// Words that people try as commands.
pub(super) const COMMANDS: [(&[&str], &str); 6] = [
    (
        &["list", "ls", "method"],
        "'curveto methods' lists the methods",
    ),
    (
        &[
            "line",
            "polygon",
            "polyline",
            "rect",
            "rectangle",
            "curve",
            "bezier",
            "pie",
            "sector",
            "square",
            "ring",
            "star",
        ],
        "'curveto path' draws any path data: curveto path 'M0 0L10 10'",
    ),
    (
        &["plot", "error"],
        "'curveto measure' and 'curveto compare' state and plot errors",
    ),
    (&["oval"], "an ellipse it is: curveto ellipse 30 20"),
    (&["draw", "shape"], "name the shape: curveto circle 50"),
    (&["version"], "'curveto --version' tells it"),
];
