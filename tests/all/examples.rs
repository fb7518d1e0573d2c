//! The programs in `examples/` print what their first lines promise.

// Each has a main of its own.
#[allow(dead_code)]
#[path = "../../examples/convert.rs"]
mod convert;
#[allow(dead_code)]
#[path = "../../examples/error.rs"]
mod error;
#[allow(dead_code)]
#[path = "../../examples/points.rs"]
mod points;

#[test]
fn an_arc_is_printed_as_cubics_that_join() {
    let text = points::text().unwrap();
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(' ').collect()).collect();
    assert!(lines.len() >= 3, "{text}");
    assert_eq!(lines[0][0], "43.301,10.000");
    assert!(
        lines.windows(2).all(|pair| pair[0][3] == pair[1][0]),
        "{text}"
    );
}

#[test]
fn the_circle_of_another_program_is_measured() {
    // In the middle of a quarter its radius is sqrt(2) (4 + 3 0.55)/8, which is 0.0606 less at 50.
    assert_eq!(error::text().unwrap(), "outside 0.0007, inside 0.0606\n");
}

#[test]
fn a_document_is_converted_and_what_is_left_is_told() {
    let text = convert::text().unwrap();
    assert!(text.contains(r#"<path d="M22 12c"#), "{text}");
    assert!(text.contains(r#"<circle r="10%"/>"#), "{text}");
    assert!(text.contains("line 1: circle was left: "), "{text}");
}
