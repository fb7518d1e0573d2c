//! What a person types in the first hour, and the words that tell what to do next.

use crate::judges::program::{self, printed, refused, run, words as program_words};

/// A command, and what its message has to hold.
const MISTAKES: [(&str, &str); 205] = [
    ("50", "curveto circle 50"),
    ("Circle 50", "'circle'"),
    ("list", "'curveto methods'"),
    ("line 10 10", "'curveto path'"),
    ("polygon", "'curveto path'"),
    ("plot", "'curveto measure'"),
    ("--circle 50", "commands have no dashes"),
    ("M0,0L5,5", "curveto path 'M0,0L5,5'"),
    ("circle", "for example: curveto circle 50"),
    ("ellipse", "for example: curveto ellipse 30 20"),
    ("sphere", "for example: curveto sphere 50"),
    ("measure circle", "for example: curveto measure circle 50"),
    ("circle 50px", "lengths are numbers in user units: 50"),
    ("circle 50mm", "lengths are numbers in user units: 50"),
    ("circle 3,5", "decimals come after a point: 3.5"),
    ("circle 1,000.5", "numbers have no commas: 1000.5"),
    ("circle fifty", "'fifty' is not a number"),
    ("circle 0", "must be a positive"),
    ("circle -5", "must be a positive"),
    ("circle nan", "must be a positive, finite number"),
    ("circle 1e308", "must stay below 1e150"),
    (
        "circle 5 -n 99999999999999999999999",
        "is too large a number",
    ),
    (
        "circle 5 -n 4 --joints 0,90",
        "--joints the angles where they meet",
    ),
    (
        "arc 5 --sweep 90 --reverse",
        "a negative sweep runs the other way",
    ),
    (
        "arc 5 --start 0 --end 720",
        "a whole turn is a sweep of 360",
    ),
    (
        "arc --from 0,0 --to 10,0 --radius 4",
        "the radius is at least 5\n",
    ),
    (
        "arc --from 0,0 --to 1,1 --radius 0.5",
        "the radius is at least 0.707107\n",
    ),
    (
        "conic --from 0,0 --control 1,1 --to 2,2 --weight 2",
        "move the control point off the line",
    ),
    (
        "arc 5 --sweep 60degrees",
        "without a unit it is in degrees: 60, or 60deg",
    ),
    ("circle 1e400", "but it is inf: infinite or too large"),
    (
        "arc 5 --sweep 60.00000000000001 --joints 70",
        "from 0 to 60 degrees",
    ),
    ("circle 50 60", "curveto ellipse RX RY"),
    ("circle -r 50", "the radius stands alone"),
    ("sphere --radius 5", "sphere 5"),
    (
        "measure circle --radius 5",
        "the radius stands alone: circle 5",
    ),
    (
        "measure circle 5 --size 400x300",
        "--plot error.svg --size 400x300",
    ),
    ("formats", "lists the formats"),
    ("circle 50 --radius 50", "the radius stands alone"),
    ("circle 50 --clockwise", "--reverse"),
    ("circle 50 --ccw", "--reverse"),
    ("circle 50 --center 5", "two numbers with a comma"),
    ("circle 50 --center 5,5,5", "'5,5,5' is not two numbers"),
    ("circle 50 --center 5", "both coordinates: 5,0"),
    ("circle 50 --adaptive", "-n 5 --adaptive"),
    ("circle 50 -t 1um", "lengths are numbers in user units: 1"),
    (
        "ellipse 5000 200 --rotation 7 -m apprich --extremes -n 1",
        "take more segments, at least one for every 120 degrees",
    ),
    (
        "ellipse 9 .1 --rotation 33 --center .33,.33 -t 1e-7 --extremes -p 1",
        "more decimals",
    ),
    ("circle 50 --extremes -n 0", "from 1 to 1000000"),
    ("ellipse --diameters 60x40", "--diameters 60,40"),
    ("measure circle 50 --quantity error", "--plot error.svg"),
    (
        "arc --from 0,0 --to 9,0 --bulge 1 --sweep 30",
        "cannot be used with",
    ),
    (
        "arc --svg M0,0A5,3,0,0,1,8,2 --rotation 45",
        "cannot be used with",
    ),
    (
        "arc --through 0,0 5,5 10,0 --start 5",
        "cannot be used with",
    ),
    ("path M5,0A5,5,0,0,1,-5,0 -f gcode", "--to arcs"),
    ("path M0,0L5.5,5.5 -p 0 -t 0.1", "give more decimals"),
    ("arc 10 --end 1 -p 0 -t 0.001", "give more decimals"),
    ("arc 0.4 --end 90 -p 0", "give more decimals"),
    (
        "conic --from 0.4,0 --control 5,5 --to 10.4,0 --weight 1 -p 0 -t 0.1",
        "give more decimals",
    ),
    ("circle 50 --cx 5", "--center X,Y"),
    ("circle 50 -f svg --size 50mm", "--size 50x50mm"),
    ("circle 50 -f svg --size 50*50", "width, x and height"),
    ("compare -n 2..8", "a list names each"),
    (
        "measure --path M0,0 --against circle:0,0",
        "--against circle:0,0,50",
    ),
    ("circle 50 --color red", "--stroke"),
    ("circle 50 --width 5", "--size WxH"),
    ("circle 50 --digits 3", "-p sets the decimals"),
    ("circle 50 -j 4", "'curveto batch -j 4' and"),
    ("circle 50 -n 4.5", "'4.5' is not a whole number"),
    ("circle 50 -n -3", "'-3' is not a whole number"),
    ("circle 50 -n 0", "from 1 to 1000000"),
    ("circle 50 -p -1", "a precision is a number of decimals"),
    ("circle 50 -p 400", "from 0 to 30"),
    ("circle 50 -t 0.01mm", "a tolerance is a positive"),
    ("circle 50 -t 1e-30", "the finest tolerance at this size"),
    ("circle 50 -m Minimax", "did you mean minimax"),
    ("circle 50 -m quadratic", "did you mean quadratic-area"),
    ("circle 50 -o x.doc", "its formats are"),
    ("circle 50 --fill red", "a picture with -f"),
    ("circle 50 --handle 1e153", "at most 1e9"),
    (
        "arc 10 --sweep 90 -m minimax-free -t 0.01",
        "hint: take -m minimax or midpoint, whose ends",
    ),
    (
        "ellipse 100 1 -m minimax-ellipse -t 0.01",
        "hint: take -m minimax, which serves every ellipse",
    ),
    (
        "ellipse 100 3 -n 3 -m minimax-ellipse",
        "at least one for every 100 degrees",
    ),
    (
        "ellipse 10 5 -m minimax-ellipse --joints 0,90,180",
        "as --joints 0,90,180,270",
    ),
    (
        "circle 10 -m lancaster-best --joints 0,90,200",
        "take -m midpoint or minimax, which serve every angle, or for a full turn -n 2, 3, 4, 5, 6 or 8",
    ),
    (
        "circle 10 --handle 0.55 -t 1e-6",
        "no number of segments brings --handle within",
    ),
    ("ellipse 30", "the two radii stand apart"),
    ("ellipse 30x20", "the two radii stand apart"),
    ("ellipse --diameters 30x20", "such as 30,20"),
    ("ellipse 30 20 --rotate 30", "'--rotation'"),
    ("ellipse 30 20 --rx 4", "the radii stand alone"),
    ("arc 50 0 90", "angles have flags"),
    ("arc 50 --start 0", "--end"),
    ("arc --through 0,0 1,1", "three points"),
    ("arc --svg M0 0 A 25 25 0 0 1 50 50", "in quotes"),
    ("arc --from 0,0 --to 10,0", "--bulge"),
    ("batch -f gcode", "'curveto path --to arcs' write it"),
    ("convert -j 0", "there is at least 1"),
    ("convert -i x.svg", "--in-place"),
    ("convert --dry-run x.svg", "--check"),
    ("explore", "curveto explore circle 50 -o page.html"),
    ("explore circle", "curveto explore circle 50 -o page.html"),
    ("conic", "curveto conic --from 0,0"),
    ("spline", "curveto spline --points '0,0 5,8 10,0'"),
    ("diff", "curveto diff golden.svg new.svg -t 0.001"),
    ("completions", "curveto completions bash"),
    (
        "diff -t 1% M0,0L5,5 M0,0L5,5",
        "a distance is in user units",
    ),
    (
        "diff M0,0L5 M0,0L5,5",
        "it ends where a command or a number should follow",
    ),
    (
        "diff M0,0L5,5 M0,0X5,5",
        "a command or a number is expected at character 5",
    ),
    ("diff nofile.svg other.svg", "neither path data nor a file"),
    (
        "path M0,0L5",
        "it ends where a command or a number should follow",
    ),
    ("measure --path hello", "path data begins with a moveto"),
    (
        "circle 50 --transform rotate30",
        "a function such as rotate(30)",
    ),
    (
        "circle 50 --transform rotate(30",
        "a function such as rotate(30)",
    ),
    ("measure --plot x.svg circle 5", "the shape comes first"),
    ("measure --path M0 0L5 5", "put the path data in quotes"),
    ("man circle", "'curveto circle --help'"),
    (
        "circle 50 -t 0,01",
        "hint: decimals come after a point: 0.01",
    ),
    (
        "circle 50 --start 1,5",
        "hint: decimals come after a point: 1.5",
    ),
    ("circle 50 -p 3,5", "a whole number, without decimals"),
    (
        "sphere 50 --meridians 3.5",
        "a whole number, without decimals",
    ),
    ("spline --points 0,0 --closed", "--ends cyclic closes it"),
    ("circle 50 --center 1,5 2,5", "--center 1.5,2.5"),
    ("batch a.txt b.txt", "cat a.txt b.txt | curveto batch"),
    ("arc 50 --from 0 --to 90", "angles are --start and --end"),
    ("arc M0 0A5 5 0 0 1 10 0", "--svg 'M0 0A25"),
    (
        "arc --radius 50 --start 0 --end 90",
        "curveto arc 50 --start 0 --end 90",
    ),
    (
        "circle 50 --file x.svg",
        "-o FILE says where the output goes",
    ),
    ("circle 50 --x 3", "--center X,Y"),
    ("explore ellipse 50", "the two radii stand apart"),
    ("methods -m minimax", "curveto methods minimax"),
    ("measure circle 50 -f svg", "--plot error.svg"),
    ("circle 50 -n 4 -t 1", "take one of them"),
    ("square 10", "'curveto path'"),
    (
        "circle 50 --center 1,5,2,5",
        "hint: decimals come after a point: 1.5,2.5",
    ),
    ("circle 50 --start 90°", "hint: degrees need no unit: 90"),
    ("circle 50 --start 5mm", "hint: angles take the units"),
    ("circle 50 -n 4mm", "hint: numbers of things have no unit"),
    (
        "convert -t 5mm x.svg",
        "hint: lengths are numbers in user units: 5",
    ),
    ("circle 50 -m MINIMAX", "did you mean minimax"),
    ("methods minimaks", "did you mean minimax"),
    ("circle 50 --anticlockwise", "--reverse"),
    ("circle 50 --kappa 0.55", "--handle K"),
    ("circle 50 --flatness 1", "-t sets the tolerance"),
    ("circle 50 --steps 8", "-n sets the number"),
    ("circle 50 --svg", "-f names the format"),
    ("circle 50 --end 90", "curveto arc 50 --start 0 --end 90"),
    ("circle 50 --rotation 30", "--start says"),
    ("circle 50 --closed", "--open leaves"),
    ("circle 50 --radians", "1.57rad"),
    ("circle 50 --scale 2", "--transform"),
    ("convert -r icons", "folders are walked"),
    ("batch --threads 4", "-j sets"),
    ("oval 5 3", "curveto ellipse 30 20"),
    ("draw circle 5", "curveto circle 50"),
    ("measure drawing.svg", "--file drawing.svg"),
    (
        "path M0,0Q5,5,10,0 -f svg --show truth",
        "known of circles, ellipses and arcs",
    ),
    (
        "measure --path M0,0L5,5 --fit auto --against circle:0,0,5",
        "cannot be used with '--against <circle:CX,CY,R|ellipse:CX,CY,RX,RY,ROT>'\n\nUsage:",
    ),
    (
        "arc --from 0,0 --to 10,0 --bulge 1 --large",
        "cannot be used with '--large'",
    ),
    (
        "arc --from 0,0 --to 10,0 --center 5,1 --large",
        "cannot be used with '--large'",
    ),
    ("circle 50 --size 300x", "hint: --size 300x300\n"),
    ("circle 50 --size 300mm", "hint: --size 300x300mm\n"),
    ("batch -o y.foo", "canvas, glif and dxf;"),
    ("sphere 5 -o y.foo", "and dxf; -f names"),
    ("spline --points 0,0,1,1 -o y.foo", "and dxf; -f names"),
    (
        "circle 1e9 -f tikz",
        "--transform 'scale(0.000001)' makes it small enough",
    ),
    (
        "arc 5 --sweep 70 -m lancaster-drawellipse",
        "hint: take -m midpoint or minimax, which serve every angle, or for a full turn -n 4\n",
    ),
    (
        "ellipse 5 3 --adaptive -m lancaster-drawellipse",
        "this method serves quarters only",
    ),
    ("man foo", "'curveto circle --help' shows its page"),
    ("man -o x", "'curveto circle --help' shows its page"),
    (
        "circle 5 --transform scale(1e200)",
        "the transformed radius 5e200 is too large",
    ),
    ("path M0,0H1e400", "the number is too large at character 6"),
    ("path M0,0H-", "a command or a number is expected"),
    (
        "convert --stdout a.svg",
        "goes to standard output by itself",
    ),
    ("convert -c a.svg", "goes to standard output by itself"),
    ("path M0,0L5,5 --clockwise", "a path runs as its data do"),
    (
        "convert x.svg --color red",
        "colours, sizes and places stay",
    ),
    ("convert x.svg -w 24", "colours, sizes and places stay"),
    ("diff a b --json", "hint: -f names the format: -f json\n"),
    (
        "diff a b --svg",
        "hint: -f names the format: text or json\n",
    ),
    (
        "compare --error 0.1",
        "hint: it tells the error of each number",
    ),
    (
        "spline --points 0,0,1,1 --tol 1",
        "through every point, whatever",
    ),
    ("path M0,0L5,5 --reverse", "a path runs as its data do"),
    ("--json circle 5", "hint: -f names the format: -f json\n"),
    (
        "measure --path M0,0L5,5 circle 5",
        "one or the other: 'curveto measure circle ...' or 'curveto measure --path ...'",
    ),
    ("path M0,0L5,5 --close", "Z in the data closes a subpath"),
    ("circle 5 --handle 0.5 -m minimax", "take one of them"),
    (
        "measure circle 5 --handle 0.5 -m minimax",
        "take one of them",
    ),
    (
        "measure -f json circle 5",
        "hint: the shape comes first: curveto measure circle ... -f\n",
    ),
    (
        "measure circle 5 --path M0,0L1,1",
        "stands without a shape: curveto measure --path",
    ),
    ("compare minimax midpoint", "-m minimax,midpoint"),
    (
        "measure circle 5 -m minimax midpoint",
        "-m minimax,midpoint",
    ),
    (
        "circle 50 midpoint",
        "hint: -m names a method: -m midpoint\n",
    ),
    ("compare circle 5", "on the circle of radius 1"),
    ("methods minimax midpoint", "curveto methods minimax"),
    ("completions bash bash", "one shell at a time"),
    ("diff a b c", "two drawings are compared"),
    ("explore circle 50 ellipse 5 3", "one shape at a time"),
    ("sphere 50 60", "a sphere has one radius"),
    (
        "circle 50 --transform rotate(30) scale(2)",
        "put words that belong together in quotes",
    ),
    (
        "convert -dash.svg --check",
        "a name that begins with a dash is given as ./-dash.svg, or",
    ),
    (
        "convert -a.svg",
        "a name that begins with a dash is given as ./-a.svg, or",
    ),
    (
        "circle 5 -o -x.svg",
        "hint: a name that begins with a dash is given as -o ./-x.svg\n",
    ),
    (
        "arc --from 0,0 --bulge 1",
        "hint: two ends are --from and --to",
    ),
    (
        "arc 5 --large --start 0 --end 4",
        "hint: --large goes with --from, --to and --radius",
    ),
    (
        "--verbose circle 5",
        "hint: options come after the command: curveto circle ... --verbose\n",
    ),
];

/// The words of the languages below, which tell a user nothing.
const FOREIGN: [&str; 9] = [
    "os error",
    "unexpected end of stream",
    "unexpected data",
    "invalid digit found in string",
    "non-zero type",
    "invalid float literal",
    "as a value, use",
    "expected struct",
    "panicked",
];

/// From an SVG file to what a machine reads.
#[test]
fn an_svg_file_becomes_gcode() {
    let folder = tempfile::tempdir().unwrap();
    let badge = r#"<svg xmlns="http://www.w3.org/2000/svg"><g transform="translate(2 3) scale(2)"><circle cx="5" cy="5" r="4"/></g>
        <path d="M1 0L3 0A2 2 0 0 1 5 2"/></svg>"#;
    std::fs::write(folder.path().join("badge.svg"), badge).unwrap();
    let said = |words: &str| {
        let output = program::run_in(folder.path(), &program_words(words));
        let text = [output.stdout, output.stderr].concat();
        (output.status.code(), String::from_utf8(text).unwrap())
    };
    let (code, gcode) = said("path badge.svg --to arcs -f gcode -p 3");
    assert_eq!(code, Some(0), "{gcode}");
    assert_eq!(gcode.lines().last(), Some("M2"));
    assert!(
        gcode.contains("G0 X20 Y13\nG3 ") && gcode.contains("G1 X3 Y0\nG3 X5 Y2 I0 J2"),
        "{gcode}"
    );
    said("path badge.svg -t 1e-6 -o badge.path");
    let (code, same) = said("diff badge.svg badge.path -t 2e-6");
    assert_eq!(code, Some(0), "{same}");
    for words in [
        "convert badge.svg -f gcode",
        "convert badge.svg --to arcs -o badge.gcode",
    ] {
        let (code, hint) = said(words);
        assert_eq!(code, Some(2), "{words}");
        assert!(
            hint.contains("curveto path FILE.svg --to arcs -f gcode"),
            "{words}: {hint}"
        );
    }
    assert!(!folder.path().join("badge.gcode").exists());
    std::fs::write(
        folder.path().join("none.svg"),
        "<svg xmlns=\"http://www.w3.org/2000/svg\"/>",
    )
    .unwrap();
    assert!(said("path none.svg").1.contains("no path and no shape"));
}

#[test]
fn flags_with_nothing_to_say_are_refused() {
    for (words, said) in [
        (
            "compare -m minimax --quadrature gauss2",
            "minimax integrates no arc length",
        ),
        (
            "circle 5 --handle 0.55 --quadrature gauss2",
            "a literal handle integrates no arc length",
        ),
        (
            "circle 5 --handle 0.55 --stop 1e-3",
            "a literal handle iterates no arc length",
        ),
        (
            "ellipse 5 3 --joints 0,90,180 --adaptive",
            "cannot be used with",
        ),
        (
            "measure circle 5 --samples 3 --coordinate-tolerance 1",
            "cannot be used with",
        ),
    ] {
        let message = refused(&program_words(words));
        assert!(message.contains(said), "{words}: {message}");
    }
    printed(&program_words(
        "compare -m minimax,chen-2 --quadrature gauss2",
    ));
}

#[test]
fn a_mistake_of_the_first_hour_is_answered_by_what_to_do() {
    for (words, wished) in MISTAKES {
        let said = refused(&program::words(words));
        assert!(said.contains(wished), "{words}: {said}");
        assert!(
            FOREIGN.iter().all(|foreign| !said.contains(foreign)),
            "{words}: {said}"
        );
    }
}

#[test]
fn no_hint_asks_for_what_is_there() {
    for (words, idle) in [
        ("circle 50 -p 400", "whole number"),
        ("circle 50 -p -1", "whole number"),
        (
            "conic --from 0,0 --control 5,5 --to 9,0 --weight 2 -t 1e-20",
            "-m minimax",
        ),
        ("convert -t 5mm x.svg", "--size"),
        ("batch --scale 2", "hint:"),
        ("man --close", "--open"),
        ("completions bash -j 2", "hint:"),
        ("conic --from 0,0 --closed", "hint:"),
        ("circle 50 -n 4 rings", "in quotes"),
    ] {
        let said = refused(&program::words(words));
        assert!(!said.contains(idle), "{words}: {said}");
    }
}

#[test]
fn a_remedy_is_one_of_the_command_at_hand() {
    for (line, words, lacking) in [
        ("circle 0 0 1e9", "batch -f tikz", "--transform"),
        (
            "ellipse 0 0 5 3",
            "batch -m minimax-ellipse-free -n 3",
            "--start",
        ),
    ] {
        let output = program::piped(&program::words(words), line.as_bytes());
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(
            said.starts_with("error: ") && !said.contains(lacking),
            "{said}"
        );
    }
}

#[test]
fn quarters_of_ellipses_have_a_remedy_that_each_command_has() {
    let free = "-m minimax-ellipse-free";
    for (line, words, remedy) in [
        (
            "arc 0 0 5 3 0 10 90",
            format!("batch {free}"),
            "take -m minimax-ellipse or minimax; a line 'ellipse CX CY RX RY' takes -n 4\n",
        ),
        (
            "",
            format!("ellipse 5 3 -n 3 {free}"),
            "take -m minimax-ellipse or minimax; a whole ellipse takes -n 4 and --start on an axis\n",
        ),
        (
            "M5 0A5 3 0 0 1 -5 0",
            format!("path - {free}"),
            "take -m minimax-ellipse or minimax\n",
        ),
    ] {
        let output = program::piped(&program::words(&words), line.as_bytes());
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(
            said.ends_with(&format!("hint: {remedy}")),
            "{words}: {said}"
        );
    }
}

#[test]
fn a_failure_of_the_system_is_told_without_its_number() {
    for words in [
        "circle 5 -o no/such/folder/x.svg",
        "explore circle 5 -m minimax -n 4 -o no/such/folder/x.html",
        "convert nofile.svg",
        "batch nofile",
        "diff . M0,0L5,5",
        "spline --points-file nofile",
    ] {
        let said = String::from_utf8(run(&program::words(words)).stderr).unwrap();
        assert!(said.starts_with("error: "), "{words}: {said}");
        assert!(
            FOREIGN.iter().all(|foreign| !said.contains(foreign)),
            "{words}: {said}"
        );
        assert!(said.contains("directory"), "{words}: {said}");
    }
}

#[test]
fn a_bad_line_of_json_is_answered_by_what_is_expected() {
    for (line, wished) in [
        (r#"{"circle":50}"#, r#"{"center": [0,0], "radius": 50}"#),
        (r#"{"arc":[]}"#, r#""sweep": 90"#),
        (r#"{"polyline":1}"#, "vertices"),
    ] {
        let error = curveto::batch::spec::Spec::parse(line)
            .unwrap_err()
            .to_string();
        assert!(error.contains(wished), "{line}: {error}");
        assert!(
            FOREIGN.iter().all(|foreign| !error.contains(foreign)),
            "{error}"
        );
    }
}
