//! Path data are read as SVG 2 has them, and faults are found to the byte.

use super::*;

fn letters(text: &str) -> (String, Option<usize>) {
    let mut segments = Segments::new(text, 0..text.len());
    let read: String = segments.by_ref().map(|s| s.letter as char).collect();
    (read, segments.error())
}

#[test]
fn commands_repeat_implicitly() {
    assert_eq!(
        letters("M0 0 1 1l2,2-3-3zm1 1 2 2Z"),
        ("MLllzmlZ".to_owned(), None)
    );
    assert_eq!(
        letters(" m0 0h1 2v3 4q1 1 1 1t2 2c1 1 1 1 1 1s1 1 1 1"),
        ("mhhvvqtcs".to_owned(), None)
    );
    assert_eq!(letters(""), (String::new(), None));
}

#[test]
fn reading_stops_at_the_first_error() {
    assert_eq!(letters("L0 0"), (String::new(), Some(0)));
    assert_eq!(letters("M0 0 L1 x"), ("M".to_owned(), Some(5)));
    assert_eq!(letters("M0 0,,1 1"), ("M".to_owned(), Some(4)));
    assert_eq!(letters("M0 0z1 1"), ("Mz".to_owned(), Some(5)));
    assert_eq!(letters("M0 0a1 1 0 2 0 1 1"), ("M".to_owned(), Some(4)));
    assert_eq!(letters("M0 0b1"), ("M".to_owned(), Some(4)));
    assert_eq!(letters("M0 0 L1 1, L2 2"), ("ML".to_owned(), Some(9)));
    assert_eq!(letters("none"), (String::new(), Some(0)));
}

#[test]
fn compact_arcs_have_exact_spans() {
    let text = "M600,350a25,25-30 0150-25l 1,1";
    let arc = Segments::new(text, 0..text.len()).nth(1).unwrap();
    assert_eq!(&text[arc.start..arc.end], "a25,25-30 0150-25");
    assert_eq!(&text[arc.tail..arc.end], "50-25");
    assert_eq!(
        arc.arc_values(text).unwrap(),
        [25.0, 25.0, -30.0, 0.0, 1.0, 50.0, -25.0]
    );
}

#[test]
fn a_repeated_arc_begins_with_its_first_argument() {
    let text = "M0 0a1 1 0 0 1 2 2, .5.5 0 00.1.1";
    let arc = Segments::new(text, 0..text.len()).nth(2).unwrap();
    assert_eq!(&text[arc.start..arc.end], ".5.5 0 00.1.1");
    assert_eq!(
        arc.arc_values(text).unwrap(),
        [0.5, 0.5, 0.0, 0.0, 0.0, 0.1, 0.1]
    );
    assert!(!arc.explicit);
}

/// Commas aside, of which it takes too many here and too few there.
#[test]
fn svgtypes_reads_the_same_segments() {
    let tokens = ["M", "l", "z", "a5 5 0 0 1", "0", "-1", ".5", " ", "e"];
    let mut texts = vec![String::new()];
    let mut from = 0;
    for _ in 0..5 {
        let until = texts.len();
        for i in from..until {
            texts.extend(tokens.map(|token| format!("{}{token}", texts[i])));
        }
        from = until;
    }
    for text in texts {
        let text = format!("M0 0{text}");
        let theirs: Result<Vec<_>, _> = svgtypes::PathParser::from(&*text).collect();
        let mut segments = Segments::new(&text, 0..text.len()).with_ends(true);
        let ours: Vec<_> = segments.by_ref().map(|our| (our.letter, our.to)).collect();
        assert_eq!(segments.fault().is_some(), theirs.is_err(), "{text}");
        if let Ok(theirs) = theirs {
            let theirs: Vec<_> = theirs.into_iter().map(letter_and_end).collect();
            assert_eq!(ours, theirs, "{text}");
        }
    }
}

fn letter_and_end(segment: svgtypes::PathSegment) -> (u8, [f64; 2]) {
    use svgtypes::PathSegment as Theirs;
    let (letter, abs, to) = match segment {
        Theirs::MoveTo { abs, x, y } => (b'm', abs, [x, y]),
        Theirs::LineTo { abs, x, y } => (b'l', abs, [x, y]),
        Theirs::EllipticalArc { abs, x, y, .. } => (b'a', abs, [x, y]),
        Theirs::ClosePath { abs } => (b'z', abs, [0.0; 2]),
        other => panic!("{other:?}"),
    };
    let upper = letter.to_ascii_uppercase();
    (if abs { upper } else { letter }, to)
}

#[test]
fn faults_are_found_to_the_byte() {
    for (text, fault) in [
        ("M0 0L5", PathFault::Ends),
        ("M0 0L", PathFault::Ends),
        ("M0 0a5 5 0 0", PathFault::Ends),
        ("M0 0L5 5,", PathFault::Comma(8)),
        ("M0 0L5 , L5 5", PathFault::Comma(7)),
        ("M0 0,z", PathFault::Comma(4)),
        ("M0 0,,1 1", PathFault::Unexpected(5)),
        ("M,0 0", PathFault::Unexpected(1)),
        ("L5", PathFault::Unexpected(0)),
        (" none", PathFault::Unexpected(1)),
        ("M0 0X5", PathFault::Unexpected(4)),
        ("M0 0L1. 5", PathFault::Unexpected(6)),
        ("M0 0z1 1", PathFault::Unexpected(5)),
        ("M0 0A5 5 0 0 2 9 9", PathFault::Unexpected(13)),
        ("M0 0A5 5 0 01x 9", PathFault::Unexpected(13)),
        ("M0 0 1e999 x", PathFault::TooLarge(5)),
    ] {
        let mut segments = Segments::new(text, 0..text.len());
        while segments.next().is_some() {}
        assert_eq!(segments.fault(), Some(fault), "{text}");
    }
    let text = "M0 0A5 5 0 0 1 1e999 9";
    let arc = Segments::new(text, 0..text.len()).nth(1).unwrap();
    assert_eq!(
        PathFault::too_large(text, &arc),
        Some(PathFault::TooLarge(15))
    );
}
