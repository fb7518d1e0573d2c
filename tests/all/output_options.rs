//! Options of output: the last one counts, colours of CSS level 4, sizes with units.

use crate::judges::program::{drawn_text as printed, piped, printed as printed_by};

/// The values of these codes of all entities of a DXF file.
fn values_of_dxf(file: &str, codes: &[&str]) -> Vec<f64> {
    let (_, entities) = file.split_once("ENTITIES").unwrap();
    let lines: Vec<&str> = entities
        .split("ENDSEC")
        .next()
        .unwrap()
        .lines()
        .map(str::trim)
        .collect();
    let pairs = lines[1..].chunks_exact(2);
    let wanted = pairs.filter(|pair| codes.contains(&pair[0]));
    wanted.map(|pair| pair[1].parse().unwrap()).collect()
}

#[test]
fn dxf_has_the_decimals_that_were_asked_for_and_states_its_error() {
    let arc = ["arc", "12.34", "--sweep", "33.333", "-f", "dxf", "-v", "-p"];
    let bulge = [
        "arc", "--from", "0.3,0", "--to", "10,0.4", "--bulge", "0.25", "-f", "dxf", "-v", "-p",
    ];
    let batch = ["batch", "-f", "dxf", "-v", "-p"];
    let codes = ["10", "20", "11", "21", "40", "42", "50", "51"];
    for (words, input, decimals, values, stated) in [
        (
            &arc[..],
            "",
            "0",
            &[0.0, 0.0, 12.0, 0.0, 33.33][..],
            "within 0.341",
        ),
        (
            &arc,
            "",
            "1",
            &[0.0, 0.0, 12.3, 0.0, 33.333],
            "within 0.04\n",
        ),
        (&arc, "", "auto", &[0.0, 0.0, 12.34, 0.0, 33.333], "exact"),
        (&bulge, "", "0", &[0.0, 0.0, 0.25, 10.0, 0.0], "within 0.7"),
        (
            &batch,
            "path M0.123 0L10.456 7",
            "0",
            &[0.0, 0.0, 10.0, 7.0],
            "within 0.456 ",
        ),
        (
            &batch,
            "path M0.123 0L10.456 7",
            "3",
            &[0.123, 0.0, 10.456, 7.0],
            "exact",
        ),
        (
            &batch,
            "arc 0 0 12.34 0 33.333",
            "0",
            &[0.0, 0.0, 12.0, 0.0, 33.33],
            "within 0.341 ",
        ),
        (
            &batch,
            "arc 0 0 12.34 0 33.333",
            "auto",
            &[0.0, 0.0, 12.34, 0.0, 33.333],
            "exact",
        ),
    ] {
        let output = piped(&[words, &[decimals]].concat(), input.as_bytes());
        let file = String::from_utf8(output.stdout).unwrap();
        assert_eq!(values_of_dxf(&file, &codes), values, "{words:?} {decimals}");
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains(stated), "{words:?} {decimals}: {said}");
    }
}

#[test]
fn the_last_of_a_flag_given_twice_counts() {
    for (twice, once) in [
        ("circle 50 -f svg -f ps", "circle 50 -f ps"),
        ("circle 50 -m minimax -m midpoint", "circle 50 -m midpoint"),
        ("circle 50 -n 3 -n 5 -p 1 -p 2", "circle 50 -n 5 -p 2"),
        (
            "circle 50 --center 1,1 --center -2,0",
            "circle 50 --center -2,0",
        ),
        (
            "circle 50 --joints 0,100,200 --joints 0,180",
            "circle 50 --joints 0,180",
        ),
        (
            "circle 50 --open --open --reverse --reverse",
            "circle 50 --open --reverse",
        ),
        (
            "arc --through 0,0 1,1 2,0 --through 0,0 1,2 2,0",
            "arc --through 0,0 1,2 2,0",
        ),
        (
            "circle 5 -f svg --stroke red --stroke blue --size 9x9 --size 10x10",
            "circle 5 -f svg --stroke blue --size 10x10",
        ),
        ("sphere 5 --view 0,0 --view 1,2", "sphere 5 --view 1,2"),
        ("compare -n 4 -f json -f csv", "compare -n 4 -f csv"),
        // The last of a list is the whole list.
        (
            "measure circle 1 -m minimax,area -m midpoint -n 4 -n 5",
            "measure circle 1 -m midpoint -n 5",
        ),
        (
            "compare -m minimax -m midpoint,area -n 4 -n 5,6 --by rms --by mean",
            "compare -m midpoint,area -n 5,6 --by mean",
        ),
        (
            "compare -m minimax --spans 30,60 --spans 90",
            "compare -m minimax --spans 90",
        ),
        (
            "explore circle 5 -f json -m all -m minimax -n 4 -n 5",
            "explore circle 5 -f json -m minimax -n 5",
        ),
        (
            "circle 5 -f svg --show joints --show truth",
            "circle 5 -f svg --show truth",
        ),
        ("procset --with reporter --with trig", "procset --with trig"),
    ] {
        assert_eq!(printed(twice), printed(once), "{twice}");
    }
}

#[test]
fn colours_are_those_of_css_level_4() {
    let run =
        |color: &str, format: &str| printed_by(&["circle", "5", "--fill", color, "-f", format]);
    for (color, attributes) in [
        ("rebeccapurple", r##"fill="#639""##),
        ("rgb(255 0 0 / 50%)", r##"fill="#f00" fill-opacity="0.5""##),
        ("#00f8", r##"fill="#00f" fill-opacity="0.533""##),
        ("hsl(0.5turn 100% 50%)", r##"fill="#0ff""##),
        ("oklch(44.027% 0.1603 303.37)", r##"fill="#639""##),
        ("currentColor", r#"fill="currentColor""#),
    ] {
        let svg = run(color, "svg");
        assert!(svg.contains(attributes), "{color}: {svg}");
    }
    assert_eq!(run("currentcolor", "eps"), run("black", "eps"));
}

#[test]
fn a_size_with_a_unit_is_a_length_where_the_format_has_lengths() {
    let svg = printed("circle 5 -f svg --size 40x30mm");
    assert!(svg.contains(r#"width="40mm""#) && svg.contains(r#"height="30mm""#));
    let eps = printed("circle 5 -f eps --size 1inx2.54cm");
    assert!(eps.contains("%%HiResBoundingBox: 0 0 72 72\n"), "{eps}");
    let plain = |unit| printed(&format!("circle 5 -f eps --size 96x48{unit}"));
    assert_eq!(plain(""), plain("pt"));
    assert!(plain("px").contains("%%HiResBoundingBox: 0 0 72 36\n"));
}
