//! The pens of lines: a colour of the palette, and a dash that tells lines apart without any colour.

use crate::method::Method;
use crate::picture::paint::Paint;
use crate::picture::palette::{BLUE, GREEN, LINES, ORANGE, PURPLE, SKY_BLUE, VERMILION};
use crate::picture::scene::Pen;

const BLACK: Paint = Paint::BLACK;

const DASHES: [&[f64]; 6] = [
    &[],
    &[7.0, 3.0],
    &[2.0, 2.5],
    &[9.0, 3.0, 2.0, 3.0],
    &[4.0, 2.0],
    &[12.0, 4.0],
];

const WIDTH: f64 = 1.7;

/// The pen of the line of this number: first by colour, then by dash.
pub(super) fn line(number: usize) -> Pen {
    // Each line has a dash of its own too, so that two that coincide are both seen.
    let dash = (number + number / LINES.len()) % DASHES.len();
    Pen {
        dash: DASHES[dash].to_vec(),
        ..Pen::stroked(LINES[number % LINES.len()], WIDTH)
    }
}

/// The pen of a method: a colour for each family, a dash for each member.
pub(super) fn family_line(method: Method) -> Pen {
    let (colour, member) = match method {
        Method::Minimax => (BLACK, 0),
        Method::Goldapp => (BLACK, 1),
        Method::MinimaxG0 => (BLACK, 2),
        Method::Midpoint => (BLUE, 0),
        Method::Area => (BLUE, 1),
        Method::Length => (BLUE, 2),
        Method::Mean => (BLUE, 3),
        Method::MeanAngle => (BLUE, 4),
        Method::Rms => (BLUE, 5),
        Method::Curvature => (VERMILION, 3),
        Method::Apprich => (VERMILION, 0),
        Method::ApprichPlus => (VERMILION, 1),
        Method::ApprichScaled => (VERMILION, 2),
        Method::CurvatureScaled => (VERMILION, 4),
        Method::Chen1 => (GREEN, 0),
        Method::Chen2 => (GREEN, 1),
        Method::Chen3 => (GREEN, 2),
        Method::LancasterBest => (PURPLE, 0),
        Method::LancasterDrawellipse => (PURPLE, 2),
        Method::MinimaxFree => (ORANGE, 0),
        Method::MinimaxEllipse => (ORANGE, 2),
        Method::MinimaxEllipseFree => (ORANGE, 3),
        Method::MinimaxG0Free => (ORANGE, 1),
        Method::QuadraticTangent => (SKY_BLUE, 0),
        Method::QuadraticMidpoint => (SKY_BLUE, 1),
        Method::QuadraticArea => (SKY_BLUE, 2),
        Method::QuadraticMinimax => (SKY_BLUE, 3),
        Method::QuadraticMinimaxFree => (SKY_BLUE, 5),
    };
    Pen {
        dash: DASHES[member].to_vec(),
        ..Pen::stroked(colour, WIDTH)
    }
}
