//! What a document says from elsewhere, by the rules of CSS, SMIL, XML and SVG: each row is a file that changed its meaning once,
//! or one that was left without need.

#![allow(clippy::format_collect)]

use std::fmt::Write as _;
use std::process::Command;

use curveto::document::{self, Options};

use crate::judges::program::run_in;

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

/// Holds that the bytes of a file stay as they are, with these notes.
fn bytes_are_left(bytes: &[u8], codes: &[&str]) {
    let shown = bytes.escape_ascii();
    let out = document::convert_bytes(bytes, &Options::default()).unwrap();
    let found: Vec<&str> = out.notes.iter().map(|note| note.reason.code()).collect();
    assert_eq!(found, codes, "{shown}");
    assert_eq!(&*out.bytes, bytes, "{shown}");
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

/// Comments stand between any two tokens.
#[test]
fn comments_do_not_part_a_selector() {
    for (sheet, code) in [
        ("./**/a{r:40px}", "style-geometry"),
        (".a/**/{r:40px}", "style-geometry"),
        ("g>:/**/first-of-type{fill:red}", "style-selector"),
        (":/**/is(circle){fill:red}", "style-selector"),
    ] {
        let circle = r#"<circle class="a" r="20"/>"#;
        is_left(&format!("<style>{sheet}</style><g>{circle}</g>"), &[code]);
    }
    is_replaced(
        r#"<style>./**/b{r:40px} .b /**/{r:1px}</style><circle class="a" r="20"/>"#,
        1,
    );
}

/// Browsers read what stands in the element itself.
#[test]
fn text_of_elements_in_a_style_is_not_its_own() {
    for inner in [
        "<desc>/*</desc>.a{r:40px}",
        "<g>\"</g>.a{r:40px}",
        "<desc>&#34;</desc>.a{r:40px}",
        "<style>b{fill:red}</style>.a{r:40px}",
        "<style>.a{r:40px}</style>",
    ] {
        is_left(
            &format!(r#"<style>{inner}</style><circle class="a" r="20"/>"#),
            &["style-geometry"],
        );
    }
    is_replaced(
        r#"<style><desc>.a{r:40px}</desc></style><circle class="a" r="20"/>"#,
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
    for attribute in [
        r#"stroke-width="attr(r px)""#,
        r#"clip-path="ATTR(r type(*))""#,
        r#"fill-opacity="calc(attr(r type(&lt;number>))/100)""#,
        r#"transform="scale(&#97;ttr(r))""#,
        r#"filter="\61ttr(r)""#,
    ] {
        is_left(
            &format!(r#"<circle {attribute} r="40"/>"#),
            &["style-geometry"],
        );
    }
    for values in [
        r#"to="attr(r px)""#,
        r#"from="0" by="&#97;ttr(r px)""#,
        r#"values="1;attr(r px)""#,
    ] {
        let set = format!(r#"<set attributeName="stroke-width" {values}/>"#);
        is_left(
            &format!(r#"<circle r="40">{set}</circle>"#),
            &["style-geometry"],
        );
    }
    is_replaced(
        r#"<circle stroke-width="attr(rx px)" transform="scale(2)" clip-path="url(#a)" r="40"/>"#,
        1,
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
    let mut rules = String::new();
    for i in 0..200_000 {
        write!(rules, ".a.b{i}:not(path),circle.c{i}{{r:{i}px}}").unwrap();
    }
    let shapes = r#"<circle class="a b c7" r="1"/>"#.repeat(20_000);
    let text = svg(&format!("<style>{rules}</style>{shapes}"));
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.svg"), &text).unwrap();
    // Seconds of a processor, not of the clock: the machine may be busy.
    let output = Command::new("sh")
        .args([
            "-c",
            "ulimit -t 40; exec \"$CURVETO\" convert --report json a.svg",
        ])
        .env("CURVETO", env!("CARGO_BIN_EXE_curveto"))
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert!(output.status.success(), "{:?}", output.status);
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("\"notes\": 20000"));
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
    // Browsers differ about an empty link.
    for links in [
        r#"href="""#,
        r#"xlink:href="""#,
        r##"href=" " xlink:href="#x""##,
    ] {
        is_left(
            &format!(r#"<circle r="20"><set {links} attributeName="r" to="90"/></circle>"#),
            &["animation"],
        );
    }
    is_left(
        r##"<circle r="20"><animate x:href="#none" xmlns:x="urn:other" attributeName="r" to="90"/></circle>"##,
        &["animation"],
    );
}

const MARKER: &str = r#"<defs><marker id="m" markerWidth="8" markerHeight="8" orient="auto"><path d="M0 0L8 4L0 8z"/></marker></defs>"#;

#[test]
fn markers_flow_through_use() {
    const PATH: &str = r#"<path id="p" d="M20 100A80 80 0 1 1 100 180L150 180"/>"#;
    const CIRCLE: &str = r#"<circle id="p" cx="100" cy="100" r="60"/>"#;
    let uses = [
        r##"SHAPE<use href="#p" marker-mid="url(#m)"/>"##,
        r##"<use href="#p" marker-mid="url(#m)"/>SHAPE"##,
        r##"<symbol id="s">SHAPE</symbol><g marker-mid="url(#m)"><use xlink:href="#s"/></g>"##,
        r##"<g id="s">SHAPE</g><use id="t" href="#s"/><use href="#t" style="marker:url(#m)"/>"##,
        r##"<style>use{marker-mid:url(#m)}</style>SHAPE<use href="#p"/>"##,
        r##"<style>.u{marker:url(#m)}</style>SHAPE<g class="u"><use href="#p"/></g>"##,
        r#"<style>#s{marker-mid:url(#m)}</style>SHAPE<g id="s"><use href="icon.svg#p"/></g>"#,
        r##"SHAPE<use xmlns:x="http://www.w3.org/1999/xlink" x:href="#p" marker-mid="url(#m)"/>"##,
        r##"SHAPE<use marker-mid="url(#m)" href="#q"><set attributeName="href" to="#p"/></use>"##,
    ];
    for inner in uses {
        let with = |shape: &str| format!("{MARKER}{}", inner.replace("SHAPE", shape));
        is_left(&with(PATH), &["marker-mid"]);
        is_left(&with(CIRCLE), &["marker"]);
    }
    for inner in [
        r##"SHAPE<use href="#q" marker-mid="url(#m)"/>"##,
        r##"SHAPE<use xmlns:x="urn:x" x:href="#p" marker-mid="url(#m)"/>"##,
        r##"SHAPE<use href="#p" marker-mid="none"/>"##,
        r##"SHAPE<g marker-mid="url(#m)"><use href="#p" style="marker:none"/></g>"##,
    ] {
        let with = |shape: &str| format!("{MARKER}{}", inner.replace("SHAPE", shape));
        is_replaced(&with(PATH), 1);
        is_replaced(&with(CIRCLE), 1);
    }
}

#[test]
fn a_chain_of_uses_ends() {
    let mut inner = format!(r#"{MARKER}<circle id="u0" r="5"/>"#);
    for i in 1..100 {
        let before = i - 1;
        write!(inner, r##"<use id="u{i}" href="#u{before}"/>"##).unwrap();
    }
    inner += r##"<use href="#u99" marker-start="url(#m)"/>"##;
    is_left(&inner, &["marker"]);
    let round = format!(
        r##"{MARKER}<g id="a"><use href="#a" marker-start="url(#m)"/><circle r="5"/></g>"##
    );
    is_left(&round, &["marker"]);
}

#[test]
fn a_style_wins_over_marker_attributes() {
    for attributes in [
        r#"style="marker-mid:url(#m)" marker-mid="none""#,
        r#"marker-mid="none" style="marker-mid:url(#m)""#,
        r#"marker-mid="url(#m)" marker="none""#,
    ] {
        let path = format!(r#"{MARKER}<path {attributes} d="M0 0A80 80 0 1 1 80 80"/>"#);
        is_left(&path, &["marker-mid"]);
    }
}

/// Many files use the prefix `xlink` without having declared it; another one says nothing then.
#[test]
fn a_prefix_that_is_not_declared_is_known_by_its_name() {
    let text = |prefix: &str| {
        format!(
            r##"<svg xmlns="http://www.w3.org/2000/svg"><path id="p" d="M0 0A80 80 0 1 1 80 80"/><use {prefix}:href="#p" marker-mid="url(#m)"/></svg>"##
        )
    };
    is_left_whole(&text("xlink"), &["marker-mid"]);
    let other = text("x");
    let out = document::convert(&other, &Options::default()).unwrap();
    assert_eq!(out.replaced.total(), 1);
}

/// What a style says of markers, on a path whose attribute has one and which is more than one curve.
#[test]
fn the_last_word_on_markers_counts() {
    let with = |style: &str| {
        format!(
            r#"{MARKER}<path marker-mid="url(#m)" style="{style}" d="M0 0A80 80 0 1 1 80 80"/>"#
        )
    };
    for style in [
        "marker:inherit",
        "marker:var(--m)",
        // No value of CSS, so that it says nothing.
        "marker:none none",
        "marker:none;marker:url(#n)",
        "fill:none",
        // Nor are these.
        "marker:",
        "marker:none!;",
        "marker:none !x",
        "marker:none !important x",
        "marker:none !important !important",
        "@media all{marker:none}",
        "}marker:none",
        "marker:none}",
        "fill:red}marker:none",
        "g{}marker:none",
    ] {
        is_left(&with(style), &["marker-mid"]);
    }
    for style in [
        "marker:none",
        "MARKER : NONE !important",
        "marker:initial",
        "marker:none!/**/IMPORTANT;;",
        "@media all{fill:red};marker:none",
        "m\\61rker:none",
    ] {
        is_replaced(&with(style), 1);
    }
    for value in ["none !important", "none none", "none;", ""] {
        let inner = format!(r#"<path marker-mid="{value}" d="M0 0A80 80 0 1 1 80 80"/>"#);
        is_left(
            &format!(r#"{MARKER}<g marker-mid="url(#m)">{inner}</g>"#),
            &["marker-mid"],
        );
    }
    for off in [
        r#"style="marker:none;all:inherit""#,
        r#"marker-mid="none" style="ALL:inherit""#,
        r#"class="a" marker-mid="none""#,
    ] {
        let plain = r#"<path d="M0 0A80 80 0 1 1 80 80"/>"#;
        let inner = format!(r#"<g marker-mid="url(#m)"><g {off}>{plain}</g></g>"#);
        is_left(
            &format!("<style>.a{{all:inherit}}</style>{MARKER}{inner}"),
            &["marker-mid"],
        );
    }
    is_left(
        r#"<circle style="all:initial" r="5"/>"#,
        &["style-geometry"],
    );
    is_replaced(r#"<path marker-mid="" d="M0 0A80 80 0 1 1 80 80"/>"#, 1);
    let path = r#"<path marker="url(#m)" d="M0 0A80 80 0 1 1 80 80"/>"#;
    is_left(&format!("{MARKER}{path}"), &["marker-mid"]);
    let plain = r#"<path d="M0 0A80 80 0 1 1 80 80"/>"#;
    for change in [
        "<style>@keyframes k{to{marker-mid:url(#m)}}</style>",
        r#"<set attributeName="marker-mid" to="url(#m)"/>"#,
    ] {
        is_left(&format!("{MARKER}{change}{plain}"), &["marker-mid"]);
    }
    // What has ended passes nothing on, and only a `use` passes on to what it refers to.
    let reference = r##"<use href="#a"/><path id="a" d="M0 0A80 80 0 1 1 80 80"/>"##;
    for before in [
        r#"<g marker-mid="url(#m)"><g></g></g>"#,
        r##"<a marker-mid="url(#m)" href="#a"/>"##,
        r##"<g marker-mid="url(#m)"><set href="#a" attributeName="opacity" to="1"/></g>"##,
    ] {
        let sheet = "<style>.z{fill:red}</style>";
        is_replaced(&format!("{sheet}{MARKER}{before}{reference}"), 1);
    }
}

#[test]
fn style_sheets_are_read_as_they_stand() {
    let circle = r#"<circle class="a" r="5"/>"#;
    for sheet in [
        "@font-face{font-family:x;src:url(a)}",
        "@page{margin:1px}",
        "@property --x{syntax:'*';inherits:false}",
        "@counter-style x{system:cyclic}",
        "@font-feature-values x{@swash{a:1}}",
        "@font-palette-values --x{font-family:y}",
        ".a{stroke-width:calc(r * 2)}",
        "@media print{g{fill:red}}",
    ] {
        is_replaced(&format!("<style>{sheet}</style>{circle}"), 1);
    }
    for (sheet, code) in [
        ("<![CDATA[<!-- @import url(a.css); -->]]>", "external-style"),
        (".&#97;{r:9px}", "style-geometry"),
        // All text in it counts, that after an element too.
        ("g{}<b></b>.a{r:1px}", "style-geometry"),
        ("@scope (g){circle{fill:red}}", "style-selector"),
    ] {
        is_left(&format!("<style>{sheet}</style>{circle}"), &[code]);
    }
    let scope = svg(&format!(
        "<style>@scope (g){{b{{fill:red}}}}</style>{circle}"
    ));
    let out = document::convert(&scope, &Options::default()).unwrap();
    assert!(
        out.notes[0]
            .reason
            .to_string()
            .contains("a rule that could not be read")
    );
    // A text that is not in the file may set anything.
    let text = format!(
        "<!DOCTYPE svg [<!ENTITY e SYSTEM 'x'>]>{}",
        svg(r#"<circle style="&e;" r="5"/>"#)
    );
    let out = document::convert(&text, &Options::default()).unwrap();
    assert_eq!(out.replaced.total(), 0);
    let reads = svg("<style>.a{stroke-width:attr(r px)}</style><circle class='a' r='5'/>");
    let out = document::convert(&reads, &Options::default()).unwrap();
    assert_eq!(out.notes[0].reason.to_string(), "a style reads `attr(r)`");
}

/// Counting by type looks at elements of any class.
#[test]
fn selectors_by_type_hold_back_what_they_count() {
    for selector in [
        ".x:first-of-type",
        "#x:nth-of-type(2)",
        "g > .x:last-of-type",
    ] {
        is_left(
            &format!(
                "<style>{selector}{{fill:red}}</style><circle r='5'/><path class='x' id='x' d='M0 0L1 1'/>"
            ),
            &["style-selector"],
        );
    }
}

#[test]
fn whatever_runs_a_script_holds_back() {
    let xhtml = r#"xmlns="http://www.w3.org/1999/xhtml""#;
    for before in [
        r#"<iframe XHTML src="javascript:f()"/>"#,
        r#"<iframe XHTML srcdoc="a"/>"#,
        r#"<iframe XHTML src="inner.html"/>"#,
        r#"<object XHTML data="inner.html"/>"#,
        r#"<embed XHTML src="inner.svg"/>"#,
        r#"<form XHTML action="javascript:f()"/>"#,
        r#"<a href=" &#9;java&#10;script:f()"/>"#,
        r#"<a href="&#106;avascript:f()"/>"#,
        r#"<a><set attributeName="href" to="JavaScript:f()"/></a>"#,
        r#"<a><animate attributeName="href" values="a;javascript:f()"/></a>"#,
    ] {
        let before = before.replace("XHTML", xhtml);
        is_left(
            &format!(r#"<foreignObject>{before}</foreignObject><circle r="5"/>"#),
            &["script"],
        );
    }
    for before in [
        "<iframe XHTML/>",
        r#"<img XHTML src="a.png"/>"#,
        r#"<x:iframe xmlns:x="urn:x" src="a"/>"#,
        r#"<a href="java.svg"/>"#,
    ] {
        let before = before.replace("XHTML", xhtml);
        is_replaced(&format!(r#"{before}<circle r="5"/>"#), 1);
    }
}

#[test]
fn names_that_only_look_alike_say_nothing() {
    for before in [
        "<g on='x'/>",
        "<x:script xmlns:x='urn:x'/>",
        "<x:style xmlns:x='urn:x'>circle{r:1px}</x:style>",
        "<glyph unicode='a' d='M0 0L1 1'/>",
        "<glyph d='M0 0L1 1' style='fill:azure'/>",
    ] {
        is_replaced(&format!("{before}<circle r='5'/>"), 1);
        is_replaced(&format!("<style>.z{{}}</style>{before}<circle r='5'/>"), 1);
    }
    is_left("<glyph d='M0 0A1 1 0 0 1 1 1'/>", &["elsewhere"]);
}

/// What was worked out for one element or one file is not taken for another that only looks alike.
#[test]
fn elements_that_are_spelled_alike_are_told_apart() {
    let out = |text: &str| {
        document::convert(text, &Options::default())
            .unwrap()
            .text
            .into_owned()
    };
    // Where each begins.
    for (one, other, starts) in [
        (
            "<circle r='1' cx='2'/>",
            "<circle r='1' cy='2'/>",
            ["M3 0", "M1 2"],
        ),
        (
            "<circle r='12' cx='1'/>",
            "<circle r='1' cx='21'/>",
            ["M13 0", "M22 0"],
        ),
        (
            "<ellipse rx='5' cx='3'/>",
            "<ellipse rx='5' cy='3'/>",
            ["M8 0", "M5 3"],
        ),
    ] {
        let text = out(&svg(&format!("{one}{other}")));
        let found: Vec<&str> = text.split(" d='").skip(1).collect();
        let begin = |i: usize| {
            found[i].starts_with(&format!("{}c", starts[i]))
                || found[i].starts_with(&format!("{}C", starts[i]))
        };
        assert!(begin(0) && begin(1), "{one}{other}: {text}");
    }
    for (radius, start) in [("5", "M5 0"), ("7", "M7 0")] {
        let text = format!(
            "<!DOCTYPE svg [<!ENTITY r '{radius}'>]>{}",
            svg("<circle r='&r;'/>")
        );
        assert!(out(&text).contains(start), "{radius}");
    }
}

#[test]
fn an_arc_without_an_extent_stays_beside_markers() {
    for marker in ["marker-start", "marker-end"] {
        is_left(
            &format!(
                r#"{MARKER}<path d="M20 100L100 140A50 50 0 0 1 100 140" {marker}="url(#m)"/>"#
            ),
            &["empty-arc"],
        );
    }
}

#[test]
fn ends_that_coincide_in_single_precision_stay() {
    for d in [
        "M160.77181 100A60 60 0 1 1 160.771811 100",
        "M160.77181 100a60 60 0 1 1 .000001 0",
        "M100 50l60.77181 50A60 60 0 1 1 160.771811 100",
        "m1000 1000a6 6 0 1 0 0 .00001z",
    ] {
        is_left(&format!(r#"<path d="{d}"/>"#), &["nearly-whole"]);
    }
    for d in [
        "M160.77181 100A60 60 0 1 1 160.7719 100",
        "M0 0a60 60 0 1 1 .000001 0",
        "M1000 1000a60 60 0 0 1 .00001 0",
    ] {
        is_replaced(&format!(r#"<path d="{d}"/>"#), 1);
    }
}

#[test]
fn defaults_of_a_dtd_count_for_every_element() {
    let whole = |subset: &str, inner: &str| format!("<!DOCTYPE svg [{subset}]>{}", svg(inner));
    let animate = r#"<circle r="20"><animate to="90" dur="4s"/></circle>"#;
    for subset in [
        r#"<!ATTLIST animate attributeName CDATA "r">"#,
        r#"<!ENTITY % x '<!ATTLIST animate attributeName CDATA "r">'>%x;"#,
        r#"<!ENTITY % x "&#60;!ATTLIST animate attributeName CDATA 'r'>"><!ENTITY % y "%x;">%y;"#,
        r#"<!ATTLIST g class CDATA "a">"#,
        "<!ATTLIST use xlink:href CDATA #FIXED '#a'>",
        r#"<!ATTLIST path fill CDATA "red">"#,
    ] {
        is_left_whole(&whole(subset, animate), &["attribute-defaults"]);
    }
    let harmless = r#"<!ATTLIST svg xmlns:xlink CDATA #FIXED "http://www.w3.org/1999/xlink" version CDATA "1.1"><!ATTLIST circle r CDATA #IMPLIED>"#;
    let text = whole(harmless, animate);
    let out = document::convert(&text, &Options::default()).unwrap();
    assert_eq!((out.replaced.circle, out.notes.len()), (1, 0));
}

#[test]
fn dots_of_arcs_do_not_vanish_in_a_coarse_precision() {
    let options = Options {
        precision: Some(0),
        ..Options::default()
    };
    let code = |inner: &str| {
        let text = svg(inner);
        let out = document::convert(&text, &options).unwrap();
        out.notes.first().map(|note| note.reason.code())
    };
    assert_eq!(
        code(r#"<circle cx="2" cy="4" r="0.3"/>"#),
        Some("precision")
    );
    for d in [
        "M6.3 4a.3 .3 0 1 1-.6 0 .3 .3 0 1 1 .6 0z",
        "M6.3 4A.3 .3 0 1 1 5.7 4 .3 .3 0 1 1 6.3 4",
        "M0 0L9 9M6 4a.3.3 0 01.3.3.3.3 0 01-.3.3.3.3 0 01-.3-.3.3.3 0 01.3-.3",
        "M6 4a.1 .1 0 1 1-.6 0 .1 .1 0 1 1 .6 0m2 2L3 3",
    ] {
        assert_eq!(
            code(&format!(r#"<path d="{d}"/>"#)),
            Some("precision"),
            "{d}"
        );
    }
    for d in [
        "M6 4a3 3 0 1 1-6 0 3 3 0 1 1 6 0z",
        "M0 0h10a.3.3 0 0 1 0 .6H0a.3.3 0 0 1 0-.6z",
        "M6 4a.3.3 0 1 1-.6 0L9 9",
    ] {
        assert_eq!(code(&format!(r#"<path d="{d}"/>"#)), None, "{d}");
    }
}

#[test]
fn negative_radii_are_those_of_the_other_axis() {
    let text = svg(
        r#"<rect width="4" height="2" rx="-1"/><rect x="5" width="4" height="2" rx="-1" ry=".5"/><ellipse cx="2" cy="6" rx="-2" ry="2"/>"#,
    );
    let out = document::convert(&text, &Options::default()).unwrap();
    assert_eq!((out.replaced.rect, out.replaced.ellipse), (1, 1));
    assert!(out.notes.is_empty(), "{:?}", out.notes);
    let positive = text.replace(r#"rx="-1" ry=".5""#, r#"rx=".5" ry=".5""#);
    let positive = positive.replace(r#"rx="-2""#, r#"rx="2""#);
    let positive = document::convert(&positive, &Options::default()).unwrap();
    assert_eq!(out.text, positive.text);
}

#[test]
fn path_data_of_a_shape_that_has_no_use_for_them_are_overwritten() {
    let text = r#"<svg><circle d="M0 0" cx="5" id="a" r="5"/><circle r="5" d='x &amp;'/></svg>"#;
    let out = document::convert(text, &Options::default()).unwrap();
    assert_eq!(out.replaced.circle, 2);
    let plain = document::convert(
        r#"<svg><circle cx="5" r="5"/><circle r="5"/></svg>"#,
        &Options::default(),
    );
    let plain = plain.unwrap().text.into_owned();
    let data: Vec<&str> = plain.split('"').skip(1).step_by(2).collect();
    assert_eq!(
        out.text,
        format!(
            r#"<svg><path d="{}" id="a"/><path d='{}'/></svg>"#,
            data[0], data[1]
        )
    );
    is_left(
        r#"<style>[d]{fill:red}</style><circle r="5" d="M0 0"/>"#,
        &["style-selector"],
    );
}

// ---- what is trusted

#[test]
fn what_is_trusted_does_not_hold_back() {
    use curveto::document::{Doubt, Trust};
    let cases = [
        (
            "style-selector",
            r#"<style>circle{fill:red}</style><circle r="5"/>"#,
        ),
        ("style-geometry", r#"<circle style="r:5px" r="5"/>"#),
        (
            "style-geometry",
            r#"<style>.a{r:5px}</style><circle class="a" r="5"/>"#,
        ),
        (
            "external-style",
            r#"<style>@import "a.css";</style><circle r="5"/>"#,
        ),
        ("script", r#"<circle r="5"/><script>1</script>"#),
        (
            "animation",
            r#"<circle r="5"><animate attributeName="r" values="1;2"/></circle>"#,
        ),
        ("marker", r#"<circle r="5" marker-end="url(#m)"/>"#),
        (
            "marker-mid",
            r#"<path marker-mid="url(#m)" d="M0 0a5 5 0 0 1 10 0"/>"#,
        ),
        (
            "motion-path",
            r##"<mpath href="#p"/><circle id="p" r="5"/>"##,
        ),
        (
            "motion-path",
            r#"<g style="offset-path: url( '#p' )"/><circle id="p" r="5"/>"#,
        ),
        (
            "motion-path",
            r#"<style>.c{offset-path:url(#p)}</style><circle id="p" r="5"/>"#,
        ),
        (
            "motion-path",
            r#"<g style="OFFSET:URL(icon.svg#p) 10%"/><circle id="p" r="5"/>"#,
        ),
        (
            "motion-path",
            r#"<g style="--p:url(#p);offset-p&#97;th:var(--p)"/><circle id="p" r="5"/>"#,
        ),
        (
            "motion-path",
            r#"<style>.c{\6f ffset-path:u\72l('#\70')}</style><circle id="p" r="5"/>"#,
        ),
        (
            "motion-path",
            r##"<mpath href="#q"><animate attributeName="href" values="#q;#p"/></mpath><circle id="p" r="5"/>"##,
        ),
        (
            "motion-path",
            r#"<g><set attributeName="offset-path" to="url(#p)"/></g><circle id="p" r="5"/>"#,
        ),
        ("empty-arc", r#"<path d="M5 5a5 5 0 1 1 0 0"/>"#),
        (
            "nearly-whole",
            r#"<path d="M1000 1000a6 6 0 1 0 0 .00001z"/>"#,
        ),
    ];
    for (code, inner) in cases {
        is_left(inner, &[code]);
        let doubt = Doubt::coded(code).unwrap();
        let trusting = |doubts: &[Doubt]| {
            let options = Options {
                trust: Trust::of(doubts),
                ..Options::default()
            };
            let text = svg(inner);
            let out = document::convert(&text, &options).unwrap();
            (out.replaced.total(), out.notes.len())
        };
        assert_eq!(trusting(&[doubt]), (1, 0), "{inner}");
        let others: Vec<Doubt> = Doubt::ALL.into_iter().filter(|d| *d != doubt).collect();
        assert_eq!(trusting(&others), (0, 1), "{inner}");
    }
    for code in [
        "path-error",
        "precision",
        "too-large",
        "length",
        "not-drawn",
        "method",
    ] {
        assert_eq!(Doubt::coded(code), None);
    }
}

#[test]
fn several_doubts_are_told_one_after_the_other() {
    use curveto::document::{Doubt, Trust};
    let text = svg(r#"<script/><style>@import "a";circle{r:1px}</style><circle r="5"/>"#);
    let mut doubts = Vec::new();
    for code in [
        "script",
        "external-style",
        "style-selector",
        "style-geometry",
    ] {
        let options = Options {
            trust: Trust::of(&doubts),
            ..Options::default()
        };
        let out = document::convert(&text, &options).unwrap();
        assert_eq!(out.notes[0].reason.code(), code);
        doubts.push(Doubt::coded(code).unwrap());
    }
}

// ---- encodings

#[test]
fn encodings_that_hold_ascii_are_spliced_byte_for_byte() {
    for name in ["iso-8859-1", "windows-1251", "EUC-JP"] {
        let head = format!("<?xml version=\"1.0\" encoding=\"{name}\"?><svg><desc>\u{1}");
        let mut bytes = head.trim_end_matches('\u{1}').as_bytes().to_vec();
        bytes.extend(0x80..=0xff);
        bytes.extend(b"</desc><circle class='\xd7\xa0' r='5' id=\"\xe9\"/></svg>");
        let out = document::convert_bytes(&bytes, &Options::default()).unwrap();
        assert_eq!((out.replaced.circle, out.notes.len()), (1, 0));
        let at = bytes
            .windows(7)
            .position(|word| word == b"<circle")
            .unwrap();
        assert!(out.bytes.starts_with(&bytes[..at]), "{name}");
        assert!(out.bytes.ends_with(b"Z' id=\"\xe9\"/></svg>"));
        let again = document::convert_bytes(&out.bytes, &Options::default()).unwrap();
        assert_eq!(again.bytes, out.bytes);
    }
    let rule = b"<?xml version='1.0' encoding='latin1'?><svg><style>.\xe9{r:1px}</style><circle class='\xe9' r='5'/><circle class='a\xe8' r='5'/></svg>";
    let out = document::convert_bytes(rule, &Options::default()).unwrap();
    assert_eq!((out.replaced.circle, out.notes.len()), (1, 1));
    // References, escapes and links give characters where the text has bytes.
    for (encoding, inner, code) in [
        (
            "iso-8859-1",
            "<style>.\\e9{r:4px}</style><circle class='\u{e9}' r='5'/>",
            "style-geometry",
        ),
        (
            "iso-8859-1",
            "<style>.\u{e9}{r:4px}</style><circle class='a &#233;' r='5'/>",
            "style-geometry",
        ),
        (
            "windows-1251",
            "<style>.\u{e6}{r:4px}</style><circle class='&#1078;' r='5'/>",
            "style-geometry",
        ),
        (
            "koi8-r",
            "<style>#\\436 {r:4px}</style><circle id='\u{d6}' r='5'/>",
            "style-geometry",
        ),
        (
            "euc-jp",
            "<style>#\\3042 {r:4px}</style><circle id='\u{a4}\u{a2}' r='5'/>",
            "style-geometry",
        ),
        (
            "iso-8859-1",
            "<circle id='\u{e9}' r='5'/><set href='#&#233;' attributeName='r' to='9'/>",
            "animation",
        ),
        (
            "iso-8859-1",
            "<circle id='\u{e9}' r='5'/><set href='#%C3%A9' attributeName='r' to='9'/>",
            "animation",
        ),
        (
            "windows-1251",
            "<circle id='\u{e6}' r='5'/><set href='#&#1078;' attributeName='r' to='9'/>",
            "animation",
        ),
        (
            "iso-8859-1",
            "<use href='#&#233;' marker-end='url(#m)'/><circle id='\u{e9}' r='5'/>",
            "marker",
        ),
        (
            "iso-8859-1",
            "<g style='offset-path:url(#\\e9)'/><circle id='\u{e9}' r='5'/>",
            "motion-path",
        ),
    ] {
        let text = format!("<?xml version='1.0' encoding='{encoding}'?><svg>{inner}</svg>");
        // Each character is one byte.
        let bytes: Vec<u8> = text
            .chars()
            .map(|c| u8::try_from(u32::from(c)).unwrap())
            .collect();
        bytes_are_left(&bytes, &[code]);
    }
    let sjis = b"<?xml version='1.0' encoding='Shift_JIS'?><svg>\x83\x5c</svg>";
    assert!(document::convert_bytes(sjis, &Options::default()).is_err());
    assert!(document::convert_bytes(b"<svg>\xe9</svg>", &Options::default()).is_err());
}

/// As `iconv -t utf-8` leaves a file, which changes no declaration.
#[test]
fn a_declaration_that_does_not_fit_is_named() {
    let said = |bytes: &[u8]| {
        let refused = document::convert_bytes(bytes, &Options::default());
        refused.unwrap_err().to_string()
    };
    let declares = |encoding: &str| {
        format!(
            "<?xml version='1.0' encoding='{encoding}'?><svg><title>é</title><circle r='5'/></svg>"
        )
    };
    for encoding in ["UTF-16", "Shift_JIS"] {
        let why = said(declares(encoding).as_bytes());
        assert!(
            why.starts_with(&format!("1:31: the encoding is {encoding}")),
            "{why}"
        );
        assert!(
            why.ends_with("have its declaration, if there is one, say encoding=\"UTF-8\""),
            "{why}"
        );
    }
    let why = said(format!("\u{feff}{}", declares("iso-8859-1")).as_bytes());
    assert_eq!(
        why,
        "1:31: not well-formed XML: the byte order mark says UTF-8, and the declaration iso-8859-1: correct it"
    );
    let text = declares("UTF-8");
    assert!(document::convert_bytes(text.as_bytes(), &Options::default()).is_ok());
}

// ---- Android

fn drawable(inner: &str) -> String {
    format!(
        r#"<vector xmlns:android="http://schemas.android.com/apk/res/android" android:viewportWidth="24">{inner}</vector>"#
    )
}

#[test]
fn arcs_of_android_drawables_become_curves() {
    let text = drawable(
        "<group android:name=\"g\">\n<clip-path android:pathData='M0 0a5 5 0 0 1 5 5z'/>\n<path android:fillColor=\"#fff\" android:pathData=\"M0 0A5 5 0 0 1 5 5\" /></group>",
    );
    let out = document::convert(&text, &Options::default()).unwrap();
    assert_eq!((out.replaced.path, out.notes.len()), (2, 0));
    let expected = text
        .replace("a5 5 0 0 1 5 5z", "c2.7596 0 5 2.2404 5 5z")
        .replace("A5 5 0 0 1 5 5", "C2.7596 0 5 2.2404 5 5");
    assert_eq!(out.text, expected);
    let renamed = text
        .replace("android:", "a:")
        .replace("xmlns:a:=", "xmlns:a=");
    let renamed = renamed.replace("xmlns:android=", "xmlns:a=");
    let out = document::convert(&renamed, &Options::default()).unwrap();
    assert_eq!(out.replaced.path, 2);
}

#[test]
fn path_data_of_android_stay_where_they_may_not_change() {
    const ARC: &str = r#"<path android:pathData="M0 0A5 5 0 0 1 5 5"/>"#;
    let animated = format!(
        r#"{ARC}<objectAnimator android:propertyName="pathData" android:valueTo="M0 0A5 5 0 0 1 5 5"/>"#
    );
    is_left_whole(&drawable(&animated), &["animation"]);
    is_left_whole(
        &drawable(r#"<path android:pathData="@string/arc"/>"#),
        &["entity"],
    );
    is_left_whole(
        &drawable(r#"<path android:pathData="M0 0x A5 5 0 0 1 5 5"/>"#),
        &["path-error"],
    );
    is_left_whole(&drawable(r#"<path pathData="M0 0A5 5 0 0 1 5 5"/>"#), &[]);
    is_left_whole(
        &drawable(r#"<path xmlns:q="urn:q" q:pathData="M0 0A5 5 0 0 1 5 5"/>"#),
        &[],
    );
    let only = Options {
        only: document::Only::of(&[document::ElementKind::Circle]),
        ..Options::default()
    };
    let arc = drawable(ARC);
    assert_eq!(document::convert(&arc, &only).unwrap().text, arc);
    let alpha = format!(r#"{ARC}<objectAnimator android:propertyName="alpha"/>"#);
    let alpha = drawable(&alpha);
    let out = document::convert(&alpha, &Options::default()).unwrap();
    assert_eq!((out.replaced.path, out.notes.len()), (1, 0));
}

/// What is said of the first element that is left in a drawing of this content.
fn first_said(content: &str, options: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let (doctype, content) = content
        .split_once("]>")
        .map_or((String::new(), content), |(d, c)| (format!("{d}]>"), c));
    let svg = format!("{doctype}<svg xmlns='http://www.w3.org/2000/svg'>{content}</svg>");
    std::fs::write(folder.path().join("a.svg"), svg).unwrap();
    let output = run_in(folder.path(), &[&["convert", "a.svg"], options].concat());
    let said = String::from_utf8(output.stderr).unwrap();
    let first = said.lines().next().unwrap_or_default();
    first
        .split_once(" is left: ")
        .map_or("", |(_, why)| why)
        .to_owned()
}

#[test]
fn every_reason_is_said_where_it_holds() {
    let link = "<x:link xmlns:x='http://www.w3.org/1999/xhtml'";
    let full = "M10 0C10 5.5228 5.5228 10 0 10C-5.5228 10 -10 5.5228 -10 0";
    let rows: [(String, &[&str], &str); 25] = [
        (format!("{link} rel='Stylesheet' href='a.css'/><circle r='5'/>"), &[], "an external style sheet"),
        (format!("{link} href='a.css'/><circle r='5'/>"), &[], "an external style sheet"),
        (format!("{link} rel='icon' href='a.png'/><circle r='5'/>"), &[], ""),
        ("<style>@import url(a.css);</style><circle r='5'/>".into(), &[], "an external style sheet"),
        ("<script/><circle r='5'/>".into(), &[], "a script or an event handler"),
        ("<g onload='f()'/><circle r='5'/>".into(), &[], "a script or an event handler"),
        (
            "<circle r='5'><animate attributeName='r' to='9'></animate></circle>".into(),
            &[],
            "an animation changes `r`",
        ),
        (
            "<circle r='5'><animate attributeName='r' to='9'/></circle>".into(),
            &[],
            "an animation changes `r`",
        ),
        (
            "<g><circle r='5'/><animate attributeName='r' to='9'></animate></g>".into(),
            &[],
            "",
        ),
        // A class that may come holds back what has none yet.
        ("<style>.a:not(path){fill:red}</style><circle r='5'/>".into(), &[], ""),
        (
            "<style>.a:not(path){fill:red}</style><circle r='5'><set attributeName='class' to='a'/></circle>".into(),
            &[],
            "the style selector `path` may depend on its name",
        ),
        ("<circle r='0.001'/>".into(), &["--precision", "1"], "it would collapse"),
        ("<circle r='1e308' cx='1e308'/>".into(), &[], "its coordinates are too large"),
        ("<ellipse rx='1e200' ry='1' cx='3'/>".into(), &[], "its coordinates are too large"),
        ("<path d='M1e308 0a1 1 0 0 1 1e308 1'/>".into(), &[], "the end point 1e308 is too large"),
        ("<path d='M50 50A5 5 0 1 1 50.0000001 50'/>".into(), &[], "its ends are one point in single precision"),
        ("<path d='M0 0A5 5 0 0 1 5 5 S 1 2 3'/>".into(), &[], "the path data have an error between this arc"),
        ("<!DOCTYPE svg [<!ATTLIST path fill CDATA 'red'>]><circle r='5'/>".into(), &[], "the DTD declares attribute defaults"),
        ("<!DOCTYPE svg [<!ENTITY e '<style/>'>]>&e;<circle r='5'/>".into(), &[], "an entity in the content"),
        ("<!DOCTYPE svg [<!ENTITY e SYSTEM 'x.svg'>]>&e;<circle r='5'/>".into(), &[], "an entity in the content"),
        ("<!DOCTYPE svg [<!ENTITY e 'text'>]>&e;<circle r='5'/>".into(), &[], ""),
        (format!("<path marker-mid='url(#m)' d='{full}'/>"), &["--to", "arcs"], "a marker may stand on every vertex, and an arc"),
        (format!("<path d='{full}'/>"), &["--to", "arcs"], ""),
        (
            format!("<style>path{{fill:red}}</style><path d='{full}C-10 -5.5228 -5.5228 -10 0 -10C5.5228 -10 10 -5.5228 10 0Z'/>"),
            &["--to", "arcs", "--shapes"],
            "the style selector `path` may depend on its name",
        ),
        (
            format!("<path d='{full}C-10 -5.5228 -5.5228 -10 0 -10C5.5228 -10 10 -5.5228 10 0Z'/>"),
            &["--to", "arcs", "--shapes"],
            "",
        ),
    ];
    for (content, options, why) in &rows {
        let said = first_said(content, options);
        assert!(
            said.starts_with(why) && said.is_empty() == why.is_empty(),
            "{content}: {said}"
        );
    }
}
