//! What a document says from elsewhere, by the rules of CSS, SMIL, XML and SVG: each row is a file that changed its meaning once,
//! or one that was left without need.

#![allow(clippy::format_collect)]

use std::fmt::Write as _;
use std::time::{Duration, Instant};

use curveto::document::{self, Options};

fn svg(inner: &str) -> String {
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 200 200">{inner}</svg>"#
    )
}

/// Holds that the document stays as it is, with these notes.
fn is_left(inner: &str, codes: &[&str]) {
    is_left_whole(&svg(inner), codes);
}

fn is_left_whole(text: &str, codes: &[&str]) {
    let out = document::convert(text, &Options::default()).unwrap();
    let found: Vec<&str> = out.notes.iter().map(|note| note.reason.code()).collect();
    assert_eq!(found, codes, "{text}");
    assert_eq!(out.text, text);
}

/// Holds that so many elements or arcs are replaced, without a note.
fn is_replaced(inner: &str, count: usize) {
    let text = svg(inner);
    let out = document::convert(&text, &Options::default()).unwrap();
    assert_eq!(
        (out.replaced.total(), out.notes.len()),
        (count, 0),
        "{inner}: {:?}",
        out.notes
    );
}

#[test]
fn comments_do_not_begin_in_strings_and_urls() {
    for sheet in [
        r#".a{font-family:"/*"} circle{fill:red}"#,
        ".bg{cursor:url(img/*.cur),auto} circle{fill:red}",
    ] {
        let inner = format!(r#"<style>{sheet}</style><circle cx="50" r="40"/>"#);
        is_left(&inner, &["style-selector"]);
    }
    is_left(
        r#"<circle style="font-family:'/*';r:80px" cx="100" r="40"/>"#,
        &["style-geometry"],
    );
    is_replaced(
        r#"<style>.a{font-family:"}circle{"} /* circle { r: 1 } */</style><circle r="40"/>"#,
        1,
    );
}

#[test]
fn sizes_along_the_text_move_rectangles() {
    for property in ["inline-size", "block-size", "-webkit-logical-height"] {
        is_left(
            &format!(
                r#"<style>.a{{{property}:50px}}</style><rect class="a" width="150" height="100" rx="10"/>"#
            ),
            &["style-geometry"],
        );
        is_left(
            &format!(r#"<rect style="{property}:50px" width="150" height="100" rx="10"/>"#),
            &["style-geometry"],
        );
    }
    is_replaced(r#"<circle style="inline-size:50px" r="4"/>"#, 1);
}

#[test]
fn values_that_read_an_attribute_keep_it() {
    for sheet in [
        ".a{stroke:red;stroke-width:attr(r px)}",
        ".a{--w:calc(attr(cx type(*)) * 1px)}",
        "@keyframes k{to{stroke-width:attr(r px)}}",
    ] {
        is_left(
            &format!(r#"<style>{sheet}</style><circle class="a" cx="100" r="40"/>"#),
            &["style-geometry"],
        );
    }
    is_left(
        r#"<circle style="stroke-width:attr(r px)" r="40"/>"#,
        &["style-geometry"],
    );
    is_left(
        r#"<path style="--d:attr(d)" d="M0 0a1 1 0 0 1 1 1"/>"#,
        &["style-geometry"],
    );
    is_replaced(
        r#"<style>.a{stroke-width:attr(data-w px)} .b{--w:attr(r)}</style><circle class="a" r="40"/>"#,
        1,
    );
}

#[test]
fn a_selector_holds_back_only_what_is_of_its_class() {
    is_left(
        r#"<style>.a:not(path){fill:red}</style><circle class="a" r="40"/>"#,
        &["style-selector"],
    );
    for sheet in [
        ".a:not(path){fill:red}",
        ":not(path).a{fill:red}",
        "text:not(path){fill:red}",
        "#a:is(path,.c){fill:red}",
    ] {
        is_replaced(
            &format!(r#"<style>{sheet}</style><circle class="b" r="40"/>"#),
            1,
        );
    }
}

#[test]
fn any_number_of_rules_is_kept_apart() {
    let rules: String = (0..5000).map(|i| format!(".c{i}{{r:{i}px}}")).collect();
    is_left(
        &format!(r#"<style>{rules}</style><circle class="c77" r="4"/>"#),
        &["style-geometry"],
    );
    is_replaced(
        &format!(r#"<style>{rules}</style><circle class="c5000" r="4"/>"#),
        1,
    );
}

#[test]
fn time_is_linear_in_a_style_sheet() {
    let start = Instant::now();
    let mut rules = String::new();
    for i in 0..200_000 {
        write!(rules, ".a.b{i}:not(path),circle.c{i}{{r:{i}px}}").unwrap();
    }
    let shapes = r#"<circle class="a b c7" r="1"/>"#.repeat(20_000);
    let text = svg(&format!("<style>{rules}</style>{shapes}"));
    let out = document::convert(&text, &Options::default()).unwrap();
    assert_eq!(out.notes.len(), 20_000);
    assert!(start.elapsed() < Duration::from_secs(40));
}

#[test]
fn animations_find_their_target_by_the_rules_of_links() {
    let animate = |attributes: &str| {
        format!(
            r#"<rect id="o" width="5" height="5"/><circle id="a b" r="20"/><animate {attributes} attributeName="r" to="90" dur="4s"/>"#
        )
    };
    for links in [
        r##"xlink:href="#o" href="#a b""##,
        r##"href="#a%20b""##,
        r##"href="#a b" xlink:href="#o""##,
        r#"href="icon.svg#a%20b""#,
        r#"href=" https://example.org/icon.svg?x#a b ""#,
        r##"xmlns:q="http://www.w3.org/1999/xlink" q:href="#a b""##,
    ] {
        is_left(&animate(links), &["animation"]);
    }
    for links in [
        r##"xlink:href="#a b" href="#o""##,
        r##"xmlns:x="urn:other" x:href="#a b""##,
        r#"href="icon.svg""#,
    ] {
        is_replaced(&animate(links), 1);
    }
    is_left(
        r##"<circle r="20"><animate x:href="#none" xmlns:x="urn:other" attributeName="r" to="90"/></circle>"##,
        &["animation"],
    );
}
