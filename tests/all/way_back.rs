//! `convert --to arcs`: what was an arc is one again, nothing else changes, and nothing is lost.

use std::path::PathBuf;

use curveto::Tolerance;
use curveto::document::{self, Converted, Options, Target};
use rayon::prelude::*;

use crate::corpora::files;
use crate::judges::independent::{self, Center, P, Segment};
use crate::judges::program::{printed, run};
use crate::judges::way_back::{apart, outlines, skeleton};

fn options(tolerance: Option<Tolerance>, shapes: bool) -> Options {
    Options {
        to: Target::Arcs { tolerance, shapes },
        ..Options::default()
    }
}

fn back(text: &str) -> Converted<'_> {
    document::convert(text, &options(None, true)).unwrap()
}

fn svg(inner: &str) -> String {
    format!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24">{inner}</svg>"#)
}

/// The new path data of a path, no shapes made.
fn path(d: &str) -> String {
    let text = svg(&format!("<path d=\"{d}\"/>"));
    let new = document::convert(&text, &options(None, false))
        .unwrap()
        .text;
    let (_, rest) = new.split_once(" d=\"").unwrap();
    rest.split_once('"').unwrap().0.to_owned()
}

/// What becomes of an element.
fn element(inner: &str) -> String {
    let text = svg(inner);
    let new = back(&text).text.into_owned();
    new[svg("").len() - 6..]
        .strip_suffix("</svg>")
        .unwrap()
        .to_owned()
}

#[test]
fn runs_become_arcs_of_the_radius_that_was_meant() {
    for (before, after) in [
        // One quarter, relative and absolute; the end keeps its text.
        ("M0 0c2.7614 0 5 2.2386 5.0,5", "M0 0a5 5 0 0 1 5.0,5"),
        ("M0 0C2.7614 0 5 2.2386 +5 5.00z", "M0 0A5 5 0 0 1+5 5.00z"),
        // One cubic is half a circle, and seems to turn by a bit more.
        ("M20,9C22.7,9 22.7,13 20,13", "M20,9A2 2 0 1 1 20,13"),
        // Two quarters are one half.
        ("M0 0c2.76 0 5 2.24 5 5s-2.24 5-5 5", "M0 0a5 5 0 0 1 0 10"),
        // The exact sum of what was spelled.
        (
            "M0 0c.0276 0 .05.0224.05.05s-.0224.05-.05.05L.3 0",
            "M0 0a.05.05 0 0 1 0 .1L.3 0",
        ),
        // A whole circle is two halves.
        (
            "M22 12c0 5.523-4.477 10-10 10S2 17.523 2 12 6.477 2 12 2s10 4.477 10 10z",
            "M22 12A10 10 0 0 1 2 12 A10 10 0 0 1 22 12z",
        ),
        // Ellipses, upright ones with two decimals.
        ("M0 0c4.97 0 9 1.34 9 3", "M0 0a9 3 0 0 1 9 3"),
        // The last of several ends keeps its text, where it is absolute.
        (
            "M0 0C2.7614 0 5 2.2386 5 5C5 7.7614 2.7614 10 0.0 10.0",
            "M0 0A5 5 0 0 1 0.0 10.0",
        ),
        // Two runs with a line between them, and one behind what would not be shorter as an arc.
        (
            "M0 0c24.8528 0 45 20.1472 45 45L9 9c24.8528 0 45 20.1472 45 45",
            "M0 0a45 45 0 0 1 45 45L9 9a45 45 0 0 1 45 45",
        ),
        (
            "M0 0c2.7614 0 5 2.2386 5 5s1 2 3 4M50 50c24.8528 0 45 20.1472 45 45",
            "M0 0c2.7614 0 5 2.2386 5 5s1 2 3 4M50 50a45 45 0 0 1 45 45",
        ),
        (
            "M0 0c2.7614 0 5 2.2386 5 5s1 2 3 4c24.8528 0 45 20.1472 45 45",
            "M0 0c2.7614 0 5 2.2386 5 5s1 2 3 4a45 45 0 0 1 45 45",
        ),
        (
            "M0 0c24.8528 0 45 20.1472 45 45 1 2 3 4 5 6c24.8528 0 45 20.1472 45 45",
            "M0 0a45 45 0 0 1 45 45c1 2 3 4 5 6a45 45 0 0 1 45 45",
        ),
        (
            "M0 0c24.8528 0 45 20.1472 45 45 1 2 3 4 5 6 1 2 3 4 5 7c24.8528 0 45 20.1472 45 45",
            "M0 0a45 45 0 0 1 45 45c1 2 3 4 5 6 1 2 3 4 5 7a45 45 0 0 1 45 45",
        ),
        (
            "M100 0Q100 19.89 92.39 38.27T70.71 70.71",
            "M100 0A100 100 0 0 1 70.71 70.71",
        ),
        // Quadratics of 22.5 degrees.
        (
            "M100 0Q100 19.89 92.39 38.27Q84.78 56.65 70.71 70.71",
            "M100 0A100 100 0 0 1 70.71 70.71",
        ),
    ] {
        assert_eq!(
            path(before).replace(" A", "A"),
            after.replace(" A", "A"),
            "{before}"
        );
    }
}

#[test]
fn what_follows_a_run_keeps_its_meaning() {
    for (before, after) in [
        // It would be longer.
        (
            "M0 0c2.7614 0 5 2.2386 5 5s1 2 3 4",
            "M0 0c2.7614 0 5 2.2386 5 5s1 2 3 4",
        ),
        (
            "M0 0c2.7614 0 5 2.2386 5 5s-2.2386 5-5 5s1 2 3 4",
            "M0 0a5 5 0 0 1 0 10c-2.7614 0 1 2 3 4",
        ),
        (
            "M0 0C2.7614 0 5 2.2386 5 5S2.7614 10 0 10S6 7 8 9",
            "M0 0A5 5 0 0 1 0 10C-2.7614 10 6 7 8 9",
        ),
        // An absolute command after relative ones: its control point is a sum, with the digits of the file's numbers.
        (
            "M0 0c2.7614 0 5 2.2386 5 5s-2.2386 5-5 5S6 7 8 9",
            "M0 0a5 5 0 0 1 0 10C-2.7614 10 6 7 8 9",
        ),
        (
            "M100.1 200.3c2.7614 0 5 2.2386 5 5s-2.2386 5-5 5S6 7 8 9",
            "M100.1 200.3a5 5 0 0 1 0 10C97.3386 210.3 6 7 8 9",
        ),
        // A smooth command that repeats another begins the next run.
        (
            "M0 0c24.8528137 0 45 20.1471863 45 45s25.1471863 70 50 70 45 20.1471863 45 45",
            "M0 0a45 45 0 0 1 45 45c0 24.8528137 25.1471863 70 50 70a45 45 0 0 1 45 45",
        ),
        // An arc that is longer where the letter after it saves as many blanks.
        (
            "M0 0c3 0 5 2 5 5   1 2 3 4 5 6",
            "M0 0a5 5 0 0 1 5 5c1 2 3 4 5 6",
        ),
        (
            "M0 0c3 0 5 2 5 5  1 2 3 4 5 6",
            "M0 0c3 0 5 2 5 5  1 2 3 4 5 6",
        ),
        (
            "M0 0c3 0 5 2 5 5   c1 2 3 4 5 6",
            "M0 0c3 0 5 2 5 5   c1 2 3 4 5 6",
        ),
        (
            "M0 0c-3 0-5 2-5 5  1 2 3 4 5 6",
            "M0 0a5 5 0 0 0-5 5c1 2 3 4 5 6",
        ),
        (
            "M0 0c-3 0-5 2-5 5 1 2 3 4 5 6",
            "M0 0c-3 0-5 2-5 5 1 2 3 4 5 6",
        ),
        (
            "M0 0c24.8528 0 45 15.1472 45 45 1 2 3 4 5 6",
            "M0 0c24.8528 0 45 15.1472 45 45 1 2 3 4 5 6",
        ),
        (
            "M0 0c24.8528 0 45 20.1472 45 45 1 2 3 4 5 6",
            "M0 0a45 45 0 0 1 45 45c1 2 3 4 5 6",
        ),
        (
            "M0 0c2.7614 0 5 2.2386 5 5s-2.2386 5-5 5 1 2 3 4 5 6 7 8",
            "M0 0a5 5 0 0 1 0 10c-2.7614 0 1 2 3 4s5 6 7 8",
        ),
        // The next run comes some curves later.
        (
            "M0 0c2.7614 0 5 2.2386 5 5c1 2 3 4 5 6c1 2-3 4 5 6c3-1 2 2 7 1c2.7614 0 5 2.2386 5 5",
            "M0 0a5 5 0 0 1 5 5c1 2 3 4 5 6c1 2-3 4 5 6c3-1 2 2 7 1a5 5 0 0 1 5 5",
        ),
    ] {
        assert_eq!(path(before), after, "{before}");
    }
}

/// A circle of so many cubics, from an angle in radians on.
fn circle([x, y]: [f64; 2], radius: f64, count: u32, start: f64, decimals: usize) -> String {
    let step = std::f64::consts::TAU / f64::from(count);
    let handle = 4.0 / 3.0 * (step / 4.0).tan();
    let at = |angle: f64, along: f64| {
        let (sin, cos) = angle.sin_cos();
        let (dx, dy) = (cos - along * sin, sin + along * cos);
        format!(
            "{:.decimals$} {:.decimals$} ",
            x + radius * dx,
            y + radius * dy
        )
    };
    let curves = (0..count).map(|i| {
        let [from, to] = [i, i + 1].map(|i| start + step * f64::from(i));
        format!("C{}{}{}", at(from, handle), at(to, -handle), at(to, 0.0))
    });
    format!("M{}{}Z", at(start, 0.0), curves.collect::<String>())
}

#[test]
fn half_a_turn_has_the_radius_that_its_ends_have() {
    for radius in [2.25, 7.5, 24.0] {
        let new = path(&circle([0.0, 12.0], radius, 4, 0.0, 4));
        let half = format!("A{radius} {radius} 0 0 1");
        assert_eq!(new.matches(&half).count(), 2, "{new}");
    }
    let half =
        path("M38.47 21.1C41.51 19.7 45.1 21.03 46.5 24.07C47.9 27.11 46.57 30.7 43.53 32.1");
    assert_eq!(half, "M38.47 21.1A6.05 6.05 0 0 1 43.53 32.1");
}

/// Where rounding moved the ends of both halves too near to each other or too far apart, a whole turn is parted elsewhere.
#[test]
fn whole_turns_have_the_radius_that_was_meant_wherever_they_start() {
    for round in 0..600 {
        let (count, decimals) = (4 + round % 5, 2 + round as usize % 3);
        let radius = f64::from(5 + 37 * round % 191);
        let start = 0.7 * f64::from(round);
        let new = path(&circle([7.0, -12.5], radius, count, start, decimals));
        let arcs = new.matches(&format!("A{radius} {radius} 0 ")).count();
        assert!((2..=4).contains(&arcs), "{new}");
        assert_eq!(arcs, new.matches(['A', 'C']).count(), "{new}");
    }
}

/// One number of decimals less would be enough for each arc alone.
#[test]
fn all_arcs_of_a_turn_have_one_radius() {
    for (radius, count, start, spelled) in [
        (8.0, 4, 0.873, "8 8"),
        (12.25, 8, 0.0, "12.25 12.25"),
        (3.0, 8, 0.0, "3 3"),
        (58.62, 4, core::f64::consts::FRAC_PI_4, "58.7 58.7"),
    ] {
        let new = path(&circle([0.0; 2], radius, count, start, 1));
        let arcs = new.matches(&format!("A{spelled} 0 ")).count();
        assert!(arcs > 1 && arcs == new.matches(['A', 'C']).count(), "{new}");
    }
}

/// Their joints and their directions there say what was meant.
#[test]
fn rough_constants_do_not_change_the_radius() {
    for (before, arc, count) in [
        // 0.55 in place of 0.5523, by which the middle of each quarter lies 0.029 inside.
        (
            "M24.966 32.196C13.858 39.327-1.065 36.074-8.196 24.966C-15.327 13.858-12.074-1.065-0.966-8.196C10.142-15.327 25.065-12.074 32.196-0.966C39.327 10.142 36.074 25.065 24.966 32.196Z",
            "A24 24 0 ",
            2,
        ),
        // 0.265 in place of 0.26522.
        (
            "M28.9286 64.7814C24.4815 63.782 20.6048 61.0508 18.167 57.1995",
            "A17.2 17.2 0 ",
            1,
        ),
    ] {
        assert_eq!(path(before).matches(arc).count(), count, "{}", path(before));
    }
}

/// A circle of three cubics lies farther off than is allowed without a tolerance: no other one stands for it.
#[test]
fn a_circle_that_is_too_far_off_stays_as_it_is() {
    for radius in [16.0, 91.0] {
        let before = format!(r#"<path d="{}"/>"#, circle([1.0, 2.0], radius, 3, 0.5, 3));
        assert_eq!(element(&before), before);
    }
}

#[test]
fn a_shape_has_the_place_that_was_meant_however_large_it_is() {
    for (center, radius, count, tolerance) in [
        ([25.5, 12.0], 300.0, 4, Some(Tolerance::Relative(0.01))),
        ([25.5, 12.0], 100.0, 12, Some(Tolerance::Relative(0.01))),
        ([25.5, 12.0], 300.0, 4, None),
        ([100.0, 7.5], 1000.0, 8, None),
    ] {
        for start in [0.0, std::f64::consts::FRAC_PI_4, 0.3] {
            let data = circle(center, radius, count, start, 2);
            let text = svg(&format!("<path d=\"{data}\"/>"));
            let new = document::convert(&text, &options(tolerance, true)).unwrap();
            let [x, y] = center;
            let shape = format!(r#"<circle cx="{x}" cy="{y}" r="{radius}"/>"#);
            assert!(new.text.contains(&shape), "{} for {shape}", new.text);
        }
    }
}

#[test]
fn a_second_conversion_finds_nothing() {
    for (before, after) in [
        // What the arcs leave has one decimal.
        (
            "M20.5,5V3.5C20.5,2.7 19.8,2.2 19,2.2C18.31,2.2 17.69,2.58 17.54,3.2C17.5,3.29 17.5,3.39 17.5,3.5V5",
            "M20.5,5V3.5A1.4 1.4 0 0 0 19,2.2A1.6 1.3 7 0 0 17.54,3.2A1 1 0 0 0 17.5,3.5V5",
        ),
        // Each is longer than its curve, but for the smooth command that would have to be spelled out after the first one.
        (
            "M6 10C5.47 10 5 10.19 4.59 10.59S4 11.47 4 12V17",
            "M6 10A2 2 0 0 0 4 12V17",
        ),
        // Without the arc before it the last one would need no letter as a curve, and be shorter as that.
        (
            "M24 19.801c0 2.268-1.841 4.105-4.109 4.105s-4.107-1.838-4.107-4.105 1.839-4.107 4.107-4.107 4.109 1.839 4.109 4.107z",
            "M24 19.801a4.107 4.107 0 1 1-4.109-4.107a4.107 4.107 0 0 1 4.109 4.107z",
        ),
        // Beside what has four decimals, before it and behind it, an arc of none.
        (
            "M0 0c2.7614 0 5 2.2386 5 5c3 0 5 2 5 5   1 2 3 4 5 6",
            "M0 0a5 5 0 0 1 5 5a5 5 0 0 1 5 5c1 2 3 4 5 6",
        ),
        (
            "M0 0c3 0 5 2 5 5   1 2 3 4 5 6c2.7614 0 5 2.2386 5 5",
            "M0 0a5 5 0 0 1 5 5c1 2 3 4 5 6a5 5 0 0 1 5 5",
        ),
    ] {
        assert_eq!(path(before), after);
        assert_eq!(path(after), after);
    }
}

#[test]
fn what_is_no_arc_keeps_every_byte() {
    for d in [
        "M0 0c1 2 3 4 5 6s7 8 9 9",
        "M0 0C0 10 10 10 10 0",
        "M0 0L5 5H9V2z",
        "M0 0c0 0 0 0 0 0z",
        "M0 0c2.7614 0 5 2.2386 5 5x",
        "M0 0Q5 0 5 5",
        "M1 1c1e-3 0 0 0 0 0",
        "M0 0c,2.7614 0 5 2.2386 5 5",
        "M1e400 0c2.7614 0 5 2.2386 5 5",
        // Numbers with an exponent have no decimals to tell what was meant.
        "M0 0c27.614e-1 0 5 2.2386 5 5",
        "M0 0c27.614e-1 0 5 2.2386 5 5 0 2.7614-2.2386 5-5 5",
        "M0 0c2.7614 0 5 2.2386 5 5 L1 x c2.7614 0 5 2.2386 5 5",
        "",
    ] {
        assert_eq!(path(d), d);
    }
}

#[test]
fn a_flat_curve_is_no_arc_because_its_radius_would_be_huge() {
    // 24 long and 0.5 high; the circle through its ends and its middle has a radius of 144 and lies 0.1 off.
    let curve = "M0 0C5 1.1 16 .5 24 0";
    let text = svg(&format!("<path d=\"{curve}\"/>"));
    for tolerance in [None, Some(Tolerance::Relative(1e-3))] {
        let done = document::convert(&text, &options(tolerance, false)).unwrap();
        assert_eq!(done.text, text);
    }
    // One that is an arc of such a radius is.
    let arc = printed(&["arc", "144", "--start", "85", "--sweep", "10", "-p", "3"]);
    let back = path(arc.trim_end());
    assert!(back.contains("A144 144 0 0 1"), "{back}");
}

#[test]
fn a_wide_tolerance_rounds_no_radius() {
    let circle = "M19.5 12C19.5 16.14 16.14 19.5 12 19.5S4.5 16.14 4.5 12 7.86 4.5 12 4.5 19.5 7.86 19.5 12Z";
    let text = svg(&format!("<path d=\"{circle}\"/>"));
    for tolerance in [Tolerance::Absolute(0.6), Tolerance::Relative(0.08)] {
        let new = document::convert(&text, &options(Some(tolerance), true))
            .unwrap()
            .text;
        assert!(
            new.contains(r#"<circle cx="12" cy="12" r="7.5"/>"#),
            "{new}"
        );
    }
    // 23.9987, as a rough constant has it, is 24.
    assert_eq!(
        path("M24 0C24 13.252 13.252 23.9987 0 24"),
        "M24 0A24 24 0 0 1 0 24"
    );
}

/// What keeps to one side of the circle, as equal thirds and fifths with their middles on it do, is of the radius at its joints.
#[test]
fn circles_of_odd_segments_have_the_radius_that_was_meant() {
    for (segments, tolerance) in [(3, Some(Tolerance::Relative(0.005))), (5, None), (7, None)] {
        for decimals in 1..=5 {
            let words = format!("circle 16 --center 20,20 -m midpoint -n {segments} -p {decimals}");
            let data = printed(&words.split(' ').collect::<Vec<_>>());
            let drawn = svg(&format!(r#"<path d="{}"/>"#, data.trim()));
            let text = document::convert(&drawn, &options(tolerance, true))
                .unwrap()
                .text;
            assert!(
                text.contains(r#"<circle cx="20" cy="20" r="16"/>"#),
                "{segments} {decimals}: {text}"
            );
        }
    }
}

#[test]
fn whole_paths_become_shapes() {
    for shape in [
        r#"<circle cx="12" cy="12" r="7.5" id="a"/>"#,
        r#"<circle cx="0.25" cy="-3" r="1"><title>t</title></circle>"#,
        r#"<ellipse cx="12" cy="5" rx="9" ry="3"/>"#,
        r#"<rect x="3" y="3" width="18" height="18" rx="2"/>"#,
        r#"<rect x="3" y="3" width="18" height="12" rx="2" ry="3"/>"#,
        r#"<rect x="1" y="1" width="10" height="4" rx="2"/>"#,
        r#"<rect x="3" y="3" width="2" height="1" rx="0.25"/>"#,
    ] {
        let text = svg(shape);
        let drawn = document::convert(&text, &Options::default()).unwrap().text;
        assert!(drawn.contains("<path"), "{drawn}");
        assert_eq!(back(&drawn).text, text);
    }
}

#[test]
fn a_path_stays_one_where_a_shape_would_be_drawn_otherwise() {
    let start = "M12 2C17.523 2 22 6.477 22 12S17.523 22 12 22 2 17.523 2 12 6.477 2 12 2Z";
    let plain = format!("<path d=\"{start}\"/>");
    assert_eq!(element(&plain), r#"<circle cx="12" cy="12" r="10"/>"#);
    for (other, code) in [
        (
            format!("<path stroke-dasharray=\"2\" d=\"{start}\"/>"),
            "stays-path",
        ),
        (
            format!("<style>.a{{STROKE-dashoffset:1}}</style><path d=\"{start}\"/>"),
            "stays-path",
        ),
        (
            format!("<path pathLength=\"9\" d=\"{start}\"/>"),
            "stays-path",
        ),
        (format!("<path r=\"9\" d=\"{start}\"/>"), "stays-path"),
        (
            format!("<path id=\"a\" d=\"{start}\"/><text><textPath href=\"#a\"/></text>"),
            "stays-path",
        ),
        (format!("<g marker-end=\"url(#m)\">{plain}</g>"), "marker"),
        (
            format!("<style>circle{{fill:red}}</style>{plain}"),
            "style-selector",
        ),
        (
            format!("<style>path{{fill:red}}</style>{plain}"),
            "style-selector",
        ),
        (
            format!("<style>*{{r:5px}}</style>{plain}"),
            "style-geometry",
        ),
        (
            format!("<style>.a{{content:'\\\\41';stroke-dasharray:1}}</style>{plain}"),
            "stays-path",
        ),
        (
            format!("<path style=\"stroke-d&#97;sharray:30 20\" d=\"{start}\"/>"),
            "stays-path",
        ),
        (
            format!("<set attributeName=\"stroke-&#x44;asharray\" to=\"3\"/>{plain}"),
            "stays-path",
        ),
        (
            format!("<rect style=\"OFFSET:url(#c) 10%\"/><path id=\"c\" d=\"{start}\"/>"),
            "motion-path",
        ),
        (
            format!("<path stroke-width=\"attr(r px, 3px)\" d=\"{start}\"/>"),
            "style-geometry",
        ),
        (format!("<script/>{plain}"), "script"),
    ] {
        let text = svg(&other);
        let done = back(&text);
        assert!(!done.text.contains("<circle"), "{}", done.text);
        assert!(
            done.notes.iter().any(|note| note.reason.code() == code),
            "{:?}",
            done.notes
        );
    }
    // What is no arc is held back by nothing, and what is left is told why.
    let notes = |inner: &str| {
        let text = svg(inner);
        let notes = back(&text).notes.into_iter();
        notes
            .map(|note| note.reason.to_string())
            .collect::<Vec<_>>()
    };
    assert!(notes("<script/><path d=\"M0 0C1 5 9-9 20 20\"/>").is_empty());
    assert!(notes("<path d=\"M0 0C1 5 9-9 20 20 x\"/>").is_empty());
    let dashed = format!("<path stroke-dasharray=\"2\" d=\"{start}\"/>");
    assert_eq!(
        notes(&dashed)[0],
        "it stays a path: dashes would begin elsewhere"
    );
    let broken = notes("<path d=\"M0 0c2.7614 0 5 2.2386 5.0,5 L1 x\"/>");
    assert!(broken[0].contains("error"), "{broken:?}");
    // An animation of the path data needs the same commands.
    let animated = svg(&format!(
        "<path d=\"{start}\"><animate attributeName=\"d\" values=\"{start};M0 0z\"/></path>"
    ));
    assert_eq!(back(&animated).text, animated);
    // Markers on vertices keep them; a run of one cubic has none.
    let marked = svg(&format!(
        "<path marker-mid=\"url(#m)\" d=\"{start}M0 0c2.7614 0 5 2.2386 5 5h1\"/>"
    ));
    let done = back(&marked);
    assert!(
        done.text.contains(start) && done.text.contains("a5 5 0 0 1 5 5h1"),
        "{}",
        done.text
    );
    assert_eq!(done.notes[0].reason.code(), "marker-mid");
}

#[test]
fn the_program_goes_back_and_says_how_closely() {
    let folder = std::env::temp_dir().join(format!("curveto-way-back-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("a.svg");
    std::fs::write(&file, svg("<path d=\"M0 0c2.7614 0 5 2.2386 5 5\"/>")).unwrap();
    let name = file.to_str().unwrap();
    let out = run(&["convert", name, "--to", "arcs", "-v"]);
    assert!(String::from_utf8_lossy(&out.stdout).contains("a5 5 0 0 1 5 5"));
    let words = String::from_utf8_lossy(&out.stderr).into_owned();
    assert!(
        words.contains("1 arc made, within 0.00136 of the curves"),
        "{words}"
    );
    let left = printed(&["convert", name, "--to", "arcs", "-t", "0.001"]);
    assert!(left.contains("c2.7614"), "{left}");
    for words in [
        &["--to", "arcs", "-n", "3"][..],
        &["--to", "arcs", "-m", "minimax"],
        &["--to", "arcs", "-t", "0"],
        &["--shapes"],
    ] {
        let out = run(&[&["convert", name][..], words].concat());
        assert_eq!(out.status.code(), Some(2), "{words:?}");
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

// ---- the icon sets

/// What became of the arcs of a set that was drawn as Béziers and then brought back.
#[derive(Debug, Default, Clone)]
struct Tally {
    /// Arcs and shapes with the numbers that they had.
    same: usize,
    /// Arcs that are one with their neighbours, of nearly the same radius.
    joined: usize,
    /// Of another radius, all of whose digits the file does not have.
    other_radius: usize,
    /// That stay Béziers, with a sweep below 4 degrees.
    flat: usize,
    /// That stay Béziers for another reason.
    left: Vec<String>,
    /// Shapes that stay paths.
    no_shape: usize,
    complaints: Vec<String>,
}

impl Tally {
    fn with(mut self, other: Self) -> Self {
        self.same += other.same;
        self.joined += other.joined;
        self.other_radius += other.other_radius;
        self.left.extend(other.left);
        self.flat += other.flat;
        self.no_shape += other.no_shape;
        self.complaints.extend(other.complaints);
        self
    }

    /// Looks for the arcs of an outline in the one that it became, wherever that begins and whichever way it runs.
    fn hold(&mut self, old: &[Segment], new: &[Segment]) {
        let near = |a: P, b: P| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-6;
        let new = arcs_of(new);
        for ([from, to], arc) in arcs_of(old) {
            let alike = |found: &Center| {
                [0, 1].map(|i| (arc.radii[i] - found.radii[i]).abs() < 1e-6 * arc.radii[i])
                    == [true; 2]
            };
            let nearly = |found: &Center| {
                [0, 1].map(|i| (arc.radii[i] - found.radii[i]).abs() < 0.1 * arc.radii[i])
                    == [true; 2]
            };
            let between =
                |[a, b]: [P; 2]| near(a, from) && near(b, to) || near(a, to) && near(b, from);
            let through = |found: &Center| [from, to].iter().all(|p| found.off(*p) < ON_CIRCLE);
            if new
                .iter()
                .any(|(ends, found)| between(*ends) && alike(found))
            {
                self.same += 1;
            } else if new.iter().any(|(ends, _)| between(*ends)) {
                self.other_radius += 1;
            } else if new.iter().any(|(_, found)| nearly(found) && through(found)) {
                self.joined += 1;
            } else if arc.sweep.abs().to_degrees() < 4.0 {
                self.flat += 1;
            } else {
                self.left.push(format!("{from:?} {to:?} {:?}", arc.radii));
            }
        }
    }
}

/// How far the ends of an arc may lie from one that it became a part of: a thousandth of 24 units.
const ON_CIRCLE: f64 = 0.024;

/// The arcs of an outline and their ends.
fn arcs_of(path: &[Segment]) -> Vec<([P; 2], Center)> {
    let (mut at, mut start, mut arcs): (P, P, Vec<_>) = ([0.0; 2], [0.0; 2], Vec::new());
    for segment in path {
        let to = segment.end().unwrap_or(start);
        match *segment {
            Segment::Move(p) => start = p,
            Segment::Arc(r, rotation, large, sweep, _)
                if (at[0] - to[0]).hypot(at[1] - to[1]) > 1e-6 =>
            {
                arcs.push(([at, to], Center::new(at, r, rotation, large, sweep, to)));
            }
            _ => {}
        }
        at = to;
    }
    arcs
}

fn round_trip(file: &PathBuf) -> Tally {
    let mut tally = Tally::default();
    let text = std::fs::read_to_string(file).unwrap();
    let drawn = document::convert(&text, &Options::default())
        .unwrap()
        .text
        .into_owned();
    let done = back(&drawn);
    let mut complain = |why: String| tally.complaints.push(format!("{}: {why}", file.display()));
    let outlines_of = |a: &str, b: &str| outlines(a, b).unwrap();
    for (i, (a, b)) in outlines_of(&drawn, &done.text).iter().enumerate() {
        match apart(a, b) {
            Ok(off) if off <= done.strayed + chords(b) => {}
            other => complain(format!("outline {i}: {other:?}, stated {}", done.strayed)),
        }
    }
    if skeleton(&drawn) != skeleton(&done.text) {
        complain("bytes elsewhere changed".to_owned());
    }
    if done.text.len() > drawn.len() {
        complain("it grew".to_owned());
    }
    for (old, new) in outlines_of(&text, &done.text) {
        tally.hold(&old, &new);
    }
    let shapes = |text: &str| ["<circle", "<ellipse"].map(|name| text.matches(name).count());
    let (old, new) = (shapes(&text), shapes(&done.text));
    tally.no_shape += (0..2).map(|i| old[i].saturating_sub(new[i])).sum::<usize>();
    let pixels = |text: &str| independent::render(text, 256).unwrap();
    let off = independent::difference(&pixels(&drawn), &pixels(&done.text), 256, 1);
    // Below a quarter of a pixel.
    if done.strayed < 0.02 && off > 128 {
        tally
            .complaints
            .push(format!("{}: a pixel is off by {off}", file.display()));
    }
    tally
}

#[test]
#[ignore = "needs `make corpora`"]
fn icons_come_back() {
    for set in ["lucide-static-1.62.0", "bootstrap-icons-1.13.2"] {
        let tallies = files(set).par_iter().map(round_trip).collect::<Vec<_>>();
        let tally = tallies.into_iter().fold(Tally::default(), Tally::with);
        println!(
            "{set}: {} arcs as they were, {} joined to others, {} of another radius, {} below 4 degrees and still Béziers, {} others; {} shapes are paths",
            tally.same,
            tally.joined,
            tally.other_radius,
            tally.flat,
            tally.left.len(),
            tally.no_shape
        );
        println!("{}", tally.left.join("\n"));
        assert!(
            tally.complaints.is_empty(),
            "{}",
            tally.complaints.join("\n")
        );
    }
}

/// What became of the path data of files that others drew.
#[derive(Debug, Default, Clone)]
struct Shrunk {
    files: usize,
    changed: usize,
    before: usize,
    after: usize,
    /// The largest part of its tolerance that a file uses.
    used: f64,
    /// The pixel that is off the most at 256 pixels a side, of 255.
    pixel: u8,
    complaints: Vec<String>,
}

impl Shrunk {
    fn with(mut self, other: Self) -> Self {
        self.files += other.files;
        self.changed += other.changed;
        self.before += other.before;
        self.after += other.after;
        self.used = self.used.max(other.used);
        self.pixel = self.pixel.max(other.pixel);
        self.complaints.extend(other.complaints);
        self
    }
}

/// The bytes of all path data.
fn data_bytes(text: &str) -> usize {
    let document = independent::parse(text).unwrap();
    let data = document
        .descendants()
        .filter_map(|node| node.attribute("d"));
    data.map(str::len).sum()
}

/// The largest radius of the arcs of outlines.
fn largest_radius(path: &[Segment]) -> f64 {
    let radius = |segment: &Segment| match *segment {
        Segment::Arc([rx, ry], ..) => rx.max(ry),
        _ => 0.0,
    };
    path.iter().map(radius).fold(0.0, f64::max)
}

/// The side that icons are drawn at.
const PIXELS: usize = 256;

/// A quarter of a pixel, of 255.
const EDGE: u8 = 64;

/// What an edge across a pixel's diagonal does to it that moves by a thousandth of 24 units, the side of both sets.
const MOST_OFF: u8 = 93;

/// How far the chords between the judge's points are from curves, as a part of the largest radius.
const CHORDS: f64 = 6e-5;

/// How far off the judge may be.
fn chords(path: &[Segment]) -> f64 {
    CHORDS * largest_radius(path) + 1e-9
}

/// Converts a file of others at a thousandth of the radius and judges what comes out.
fn shrink(file: &PathBuf) -> Shrunk {
    const PART: f64 = 1e-3;
    let text = std::fs::read_to_string(file).unwrap();
    let done = document::convert(&text, &options(Some(Tolerance::Relative(PART)), false)).unwrap();
    let mut found = Shrunk {
        files: 1,
        changed: usize::from(done.text != text),
        before: data_bytes(&text),
        after: data_bytes(&done.text),
        ..Shrunk::default()
    };
    let mut complain = |why: String| found.complaints.push(format!("{}: {why}", file.display()));
    for (i, (a, b)) in outlines(&text, &done.text).unwrap().iter().enumerate() {
        let room = PART * largest_radius(b);
        match apart(a, b) {
            Ok(off) if off <= done.strayed.min(room) + chords(b) => {
                if room > 0.0 {
                    found.used = found.used.max((off - chords(b)) / room);
                }
            }
            other => complain(format!("outline {i}: {other:?}, within {room}")),
        }
    }
    if skeleton(&text) != skeleton(&done.text) {
        complain("bytes elsewhere changed".to_owned());
    }
    if done.text.len() > text.len() {
        complain("it grew".to_owned());
    }
    let pixels = |text: &str, size| independent::render(text, size).unwrap();
    let off = |size, block| {
        independent::difference(
            &pixels(&text, size as u32),
            &pixels(&done.text, size as u32),
            size,
            block,
        )
    };
    found.pixel = off(PIXELS, 1);
    // What a renderer rounds a thin part of a pixel to is no part of it: the mean of 64 is.
    if found.pixel > EDGE {
        found.pixel = off(8 * PIXELS, 8);
    }
    if found.pixel > MOST_OFF {
        let why = format!("{}: a pixel is off by {}", file.display(), found.pixel);
        found.complaints.push(why);
    }
    found
}

#[test]
#[ignore = "needs `make test-corpora-back`"]
fn icons_of_others_become_smaller() {
    for (set, part) in [("mdi-svg-7.4.47", 0.07), ("simple-icons-16.37.0", 0.03)] {
        let all = files(set).par_iter().map(shrink).collect::<Vec<_>>();
        let all = all.into_iter().fold(Shrunk::default(), Shrunk::with);
        let saved = 1.0 - all.after as f64 / all.before as f64;
        println!(
            "{set}: {} of {} files, path data {} -> {} bytes ({:.2} % less), at most {:.3} of the tolerance, a pixel off by {} of 255",
            all.changed,
            all.files,
            all.before,
            all.after,
            100.0 * saved,
            all.used,
            all.pixel
        );
        assert!(all.complaints.is_empty(), "{}", all.complaints.join("\n"));
        assert!(saved >= part, "{set}: {saved}");
    }
}

#[test]
fn a_dot_takes_no_part_in_a_tolerance() {
    for to in ["arcs", "lines"] {
        let path = printed(&["path", "M0 0C1 1 2 1 3 0M5 5h0", "--to", to, "-t", "1%"]);
        assert!(path.trim_end().ends_with("M5 5L5 5"), "{path}");
    }
}

#[test]
fn a_path_that_is_left_is_noted_once() {
    let circle = "M5 0C5 2.76 2.76 5 0 5C-2.76 5-5 2.76-5 0C-5-2.76-2.76-5 0-5C2.76-5 5-2.76 5 0Z";
    let text = format!("<svg><script>1</script><path d=\"{circle}\"/><path d=\"{circle}\"/></svg>");
    let converted = back(&text);
    let codes = converted.notes.iter().map(|note| note.reason.code());
    assert_eq!(codes.collect::<Vec<_>>(), ["script"; 2]);
}
