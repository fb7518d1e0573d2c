use super::super::property::ElementKind;
use super::super::rules::SelectorSubject;
use super::*;

fn sheet(text: &str) -> StyleSheets {
    let mut sheet = StyleSheets::default();
    read(text, &mut sheet);
    sheet
}

/// What the sheet does to a circle of that class.
fn effect(sheet: &StyleSheets, class: &str) -> Properties {
    let subject = SelectorSubject::new("circle", Some(class), None);
    sheet.rules.effect(subject).sets
}

#[test]
fn declarations_are_found_in_nested_blocks() {
    let s = sheet(
        "/* r:1 */ @media print { .a, .b { r: 5px; fill: red } } @font-face { r: 1 } .c { fill: url(a;r:1) }",
    );
    assert_eq!(effect(&s, "a"), Properties::named("r"));
    assert_eq!(effect(&s, "x b"), Properties::named("r"));
    assert!(effect(&s, "c").is_empty() && s.keyframes.is_empty());
}

#[test]
fn comments_do_not_begin_in_strings_and_urls() {
    for text in [
        r#".a{font-family:"/*"} .b{r:5px}"#,
        ".a{cursor:url(img/*.cur),auto} .b{r:5px}",
        "<!-- .a{fill:red} --> .b{/* ; */r/**/:5px}",
        r".a{content:'\'}/*'} .b{r:5px}",
    ] {
        assert_eq!(effect(&sheet(text), "b"), Properties::named("r"), "{text}");
    }
    let style = declarations("font-family:'/*';r:80px");
    assert_eq!(style.sets, Properties::named("r"));
}

#[test]
fn keyframes_and_imports_are_seen() {
    let s = sheet(
        "@import url(x.css); @-webkit-keyframes a { from { r: 1 } 50% { fill: red } } g { & path { d: none } }",
    );
    assert!(s.imports);
    assert_eq!(s.keyframes.sets, Properties::named("r"));
    assert!(effect(&s, "a").meets(Properties::D));
    assert!(sheet(r"@\69mport 'a.css';").imports);
}

#[test]
fn style_attributes_are_lists_of_declarations() {
    assert!(declarations("fill:red;/*r:1*/stroke:url(#a)").is_empty());
    assert_eq!(
        declarations("fill:red; R : 5px").sets,
        Properties::named("r")
    );
    assert!(declarations("--r: 5; marker: none").no_marker);
    assert!(!declarations("marker: none; marker: url(#a)").no_marker);
    assert!(declarations("--r: 5; marker-end: NONE !important").is_empty());
    assert!(declarations("\\72: 5").sets.meets(Properties::named("r")));
}

#[test]
fn attributes_that_values_read_are_found() {
    let read = |text: &str| declarations(text).reads;
    assert_eq!(read("stroke-width:attr(r px)"), Properties::named("r"));
    assert_eq!(
        read("--w: calc(2 * ATTR(cx type(<length>), 1px))"),
        Properties::named("cx")
    );
    assert!(read("content:'attr(r)';fill:url(attr(r))").is_empty());
    assert!(read("width:attr(data-r px)").is_empty());
    assert_eq!(
        read(&format!("a:{}", "f(".repeat(500))),
        Properties::ANY,
        "what is nested too deeply may read anything"
    );
}

#[test]
fn sizes_along_the_text_are_width_and_height() {
    for name in ["inline-size", "block-size", "-webkit-logical-width"] {
        let set = declarations(&format!("{name}: 5px")).sets;
        assert!(set.meets(ElementKind::Rect.sensitive()), "{name}");
    }
}

#[test]
fn broken_sheets_end() {
    for text in [
        "}}}", "a{", "{", "a{b:c", "'", "@", "a{{{{", "/*", "(;{};", "\\", "a:", "a{b:",
    ] {
        sheet(text);
        declarations(text);
    }
    let deep = sheet(&"a{".repeat(5000));
    let subject = SelectorSubject::new("rect", None, None);
    assert!(
        deep.rules
            .selected_by_name(ElementKind::Rect, subject)
            .is_some()
    );
}
