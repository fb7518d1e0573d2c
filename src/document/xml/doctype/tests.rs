//! Entities, their depth and their budget, and the attributes that have a default.

use super::*;

fn text(resolved: Resolved) -> Option<String> {
    match resolved {
        Resolved::Text(text, _) => Some(text),
        _ => None,
    }
}

#[test]
fn entities_resolve_through_one_another() {
    let doctype = Doctype::read(
        r#" svg PUBLIC "a>[" 'b' [ <!-- <!ENTITY r "9"> --> <!ENTITY r "1&#50;"> <!ENTITY r "7"> <?x <!ENTITY y "1">?>
           <!ENTITY two '&r; &r;'> <!ENTITY ns "http://www.w3.org/2000/svg"> <!ENTITY out SYSTEM "x.svg"> ]"#,
        0,
    );
    assert_eq!(text(doctype.resolve("two")).as_deref(), Some("12 12"));
    assert_eq!(
        text(doctype.resolve("ns")).as_deref(),
        Some("http://www.w3.org/2000/svg")
    );
    assert_eq!(text(doctype.resolve("#x41")).as_deref(), Some("A"));
    assert_eq!(doctype.resolve("out"), Resolved::Unknown);
    assert_eq!(doctype.resolve("y"), Resolved::Unknown);
    assert_eq!(Doctype::default().resolve("nbsp"), Resolved::Malformed);
    assert_eq!(Doctype::default().resolve("#0"), Resolved::Malformed);
    assert!(doctype.may_hold_markup());
    assert_eq!(text(doctype.resolve("quot")).as_deref(), Some("\""));
    assert_eq!(text(doctype.resolve("apos")).as_deref(), Some("'"));
    for wrong in ["#", "#x", "#+53", "#x+41", "#5a", "#xfffe"] {
        assert_eq!(doctype.resolve(wrong), Resolved::Malformed, "{wrong}");
    }
}

#[test]
fn quotes_hide_what_ends_a_declaration() {
    let resolved = |text_: &str| text(Doctype::read(text_, 0).resolve("r"));
    for subset in [
        r#"svg SYSTEM "a[<!ENTITY r '9'>" [<!ENTITY r "5">]"#,
        r#"svg SYSTEM 'it"s[<!ENTITY r "9">' [<!ENTITY r "5">]"#,
        r#"svg SYSTEM "a]" [<!ENTITY r "5">"#,
        r#"svg [<!ENTITY e ""><!ENTITY r "5&e;">]"#,
        r#"svg [<!ENTITY % e ""> %e; <!ENTITY r "5">]"#,
    ] {
        assert_eq!(resolved(subset).as_deref(), Some("5"), "{subset}");
    }
    let text = resolved(r#"svg [<!ENTITY r "a>b"><!ENTITY s '">'>]"#);
    assert_eq!(text.as_deref(), Some("a>b"));
    // Nothing is declared in a comment or an instruction.
    for hidden in ["<!--%a;-->", "<?x %a;?>", "<?x %;?>"] {
        let doctype = Doctype::read(&format!("svg [<!ENTITY % a ''>{hidden}]"), 0);
        assert_eq!(doctype.resolve("r"), Resolved::Malformed, "{hidden}");
    }
}

#[test]
fn what_refers_to_itself_is_refused_where_it_stands() {
    let doctype = Doctype::read(
        r#"svg [<!ENTITY a "&b; &c;"><!ENTITY b "&amp;&c;"><!ENTITY c "1"><!ENTITY d "&e;"><!ENTITY e "x&d;"><!ENTITY f "&a;&d;"><!ENTITY g "&g"> ]"#,
        0,
    );
    for name in ["d", "e", "f"] {
        assert_eq!(doctype.resolve(name), Resolved::Malformed, "{name}");
        assert!(doctype.refuses(name).unwrap().contains("itself"));
    }
    for name in ["a", "b", "c", "g", "amp"] {
        assert_eq!(doctype.refuses(name), None, "{name}");
    }
    assert_eq!(text(doctype.resolve("a")).as_deref(), Some("&1 1"));
}

#[test]
fn entities_may_refer_to_one_another_to_a_depth() {
    let chain = |sign: &str, first: &str, reference: char, count: usize| {
        let first = format!("svg [<!ENTITY {sign}e0 '{first}'>");
        let more = (1..=count).map(|i| {
            let before = i - 1;
            format!("<!ENTITY {sign}e{i} '{reference}e{before};'>")
        });
        core::iter::once(first).chain(more).collect::<String>()
    };
    let general = |count| {
        let doctype = Doctype::read(&(chain("", "x", '&', count) + "]"), 0);
        text(doctype.resolve(&format!("e{count}")))
    };
    assert_eq!(general(MAX_DEPTH).as_deref(), Some("x"));
    assert_eq!(general(MAX_DEPTH + 1), None);
    let parameter = |count| {
        let declarations = chain("% ", "<!ENTITY r \"7\">", '%', count);
        Doctype::read(&format!("{declarations}%e{count};]"), 0)
    };
    let deep = parameter(MAX_DEPTH - 1);
    assert_eq!(text(deep.resolve("r")).as_deref(), Some("7"));
    assert!(!deep.has_defaults_for("circle", "path"));
    assert!(parameter(MAX_DEPTH).has_defaults_for("circle", "path"));
}

#[test]
fn names_with_a_default_are_found_among_types_and_values() {
    for (list, names) in [
        (
            "a CDATA \"5\" on CDATA #IMPLIED b CDATA '6'",
            &["a", "b"][..],
        ),
        ("a(x|y)'x' b (c | d) \"c\" e ID #REQUIRED", &["a", "b"]),
        (
            "a NOTATION (x) #FIXED \"x\" b CDATA \"'\"c CDATA ''",
            &["a", "b", "c"],
        ),
        ("a CDATA \"open", &["a"]),
        ("a (x", &[]),
    ] {
        assert_eq!(with_default(list), names, "{list}");
    }
}

#[test]
fn some_attributes_matter_to_other_elements() {
    for (element, attribute, matters) in [
        ("style", "type", true),
        ("svg:script", "type", true),
        ("rect", "type", false),
        ("link", "rel", true),
        ("a", "rel", false),
        ("g", "onclick", true),
        ("g", "marker-end", true),
        ("use", "xlink:href", true),
        ("g", "id", true),
        ("g", "fill", false),
    ] {
        assert_eq!(
            matters_elsewhere(element, attribute),
            matters,
            "{element} {attribute}"
        );
    }
}

#[test]
fn bombs_and_circles_end() {
    let mut bomb = String::from("svg [<!ENTITY a0 'aaaaaaaaaa'>");
    for i in 1..40 {
        let before = format!("&a{};", i - 1).repeat(10);
        bomb.extend(["<!ENTITY a", &i.to_string(), " '", &before, "'>"]);
    }
    bomb += "<!ENTITY c1 '&c2;'><!ENTITY c2 '&c1;'>]";
    let doctype = Doctype::read(&bomb, bomb.len());
    assert_eq!(doctype.resolve("c1"), Resolved::Malformed);
    assert_eq!(doctype.resolve("a39"), Resolved::Unknown);
    assert_eq!(doctype.resolve("a9"), Resolved::Unknown);
}

#[test]
fn attributes_with_a_default_are_known() {
    let has = |subset: &str, name: &str| {
        Doctype::read(&format!("svg [{subset}]"), 0).has_defaults_for(name, "path")
    };
    let circle = r#"<!ATTLIST circle r CDATA "5>" cx CDATA #IMPLIED>"#;
    assert!(has(circle, "circle") && !has(circle, "rect"));
    assert!(has(
        "<!ATTLIST path fill (red|blue) #FIXED 'red'>",
        "circle"
    ));
    assert!(has(
        r#"<!ATTLIST animate attributeName CDATA"r">"#,
        "circle"
    ));
    for harmless in [
        "<!ATTLIST circle r CDATA #IMPLIED cx CDATA #REQUIRED>",
        "<!ATTLIST svg xmlns:x CDATA #FIXED 'urn:x' version NMTOKEN '1.1'>",
        "<!ATTLIST path xmlns CDATA 'http://www.w3.org/2000/svg'>",
        "<!ATTLIST animateTransform type (a|b) 'a'>",
    ] {
        assert!(!has(harmless, "circle"), "{harmless}");
    }
}

#[test]
fn parameter_entities_stand_for_declarations() {
    let text = r#"svg [<!ENTITY % a '&#60;!ATTLIST circle r CDATA "5"><!ENTITY r "7">'> <!ENTITY % b "%a;"> %a; %none; ]"#;
    let doctype = Doctype::read(text, 0);
    assert!(doctype.has_defaults_for("circle", "path"));
    assert!(!doctype.has_defaults_for("rect", "path"));
    assert_eq!(text_of(&doctype, "r").as_deref(), Some("7"));
    let round = Doctype::read("svg [<!ENTITY % a '%b;'><!ENTITY % b '%a;'> %a;]", 0);
    assert!(
        round.has_defaults_for("rect", "path"),
        "what cannot be read may say anything"
    );
}

fn text_of(doctype: &Doctype, name: &str) -> Option<String> {
    text(doctype.resolve(name))
}

#[test]
fn what_is_no_reference_stays_or_says_nothing() {
    assert_eq!(with_characters("a&#0;b&#x42;&#"), "a&#0;bB&#");
    let doctype = Doctype::read(r#"svg SYSTEM "x.dtd" [<!ENTITY r "1 &amp 2">]"#, 0);
    assert_eq!(doctype.resolve("r"), Resolved::Unknown);
    // A bracket within quotes opens nothing.
    let doctype = Doctype::read(r#"svg "a[<!ENTITY r '5'>]""#, 0);
    assert_eq!(doctype.resolve("r"), Resolved::Malformed);
    assert!(Doctype::read(r#"svg [<!ENTITY r SYSTEM "x">]"#, 0).may_hold_markup());
    assert!(!Doctype::read(r#"svg [<!ENTITY r "x">]"#, 0).may_hold_markup());
}
