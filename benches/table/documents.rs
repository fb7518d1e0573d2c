//! Documents for the table: icons as sets of them have, made up so that the row needs no download.

use std::fmt::Write as _;

use curveto::document::{self, Options};
use resvg::usvg;

use super::Numbers;

const ICONS: usize = 2000;

/// Icons of circles, ellipses, rounded rectangles, lines and a path with arcs.
pub(crate) fn icons() -> Vec<String> {
    let mut numbers = Numbers(11);
    (0..ICONS).map(|_| icon(&mut numbers)).collect()
}

fn icon(numbers: &mut Numbers) -> String {
    let mut n = |low: f64, high: f64| (numbers.uniform(low, high) * 4.0).round() / 4.0;
    let mut text = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"24\" height=\"24\" viewBox=\"0 0 24 24\" fill=\"none\" \
         stroke=\"black\" stroke-width=\"2\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
    );
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "  <circle cx=\"{}\" cy=\"{}\" r=\"{}\" />\n  <ellipse cx=\"12\" cy=\"{}\" rx=\"9\" ry=\"{}\" />\n  \
         <rect width=\"{}\" height=\"{}\" x=\"3\" y=\"2\" rx=\"2\" />\n  \
         <path d=\"M{} 12a2 2 0 0 1-2 {}h-.5a{} 2.5 0 0 0-1 1.25V20a2 2 0 0 1-4 0M4 {}l3 2.5c1 1 2 1.5 4 1\" />\n  \
         <path d=\"m{} 7 3.25-3.5 3.75 4.25\" />\n</svg>",
        n(4.0, 20.0),
        n(4.0, 20.0),
        n(1.0, 10.0),
        n(4.0, 20.0),
        n(1.0, 4.0),
        n(8.0, 18.0),
        n(8.0, 18.0),
        n(14.0, 20.0),
        n(1.0, 3.0),
        n(2.0, 3.0),
        n(3.0, 12.0),
        n(3.0, 12.0),
    );
    text
}

pub(crate) fn ours(text: &str) -> usize {
    document::convert(text, &Options::default()).map_or(0, |converted| converted.text.len())
}

pub(crate) fn usvgs(text: &str) -> usize {
    usvg::Tree::from_str(text, &usvg::Options::default()).map_or(0, |tree| {
        tree.to_string(&usvg::WriteOptions::default()).len()
    })
}
