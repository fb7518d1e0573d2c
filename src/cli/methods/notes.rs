//! What a card says beyond its table: where a source printed something else, and why. Every figure is computed.

use curveto::method::{Rule, Span};
use curveto::number::{significant, text};
use curveto::{Method, Result};

/// The paragraphs for a method.
pub(super) fn notes(method: Method) -> Result<Vec<String>> {
    let quarter = Span::from_degrees(90.0);
    let error = |rule: Rule| -> Result<f64> { Ok(rule.radial_error(&quarter)?.peak()) };
    Ok(match method {
        Method::Chen1 => vec![
            "Unequal joints: a C2 spline by his system (11), so that tangent and curvature are continuous everywhere, but the tangents \
             are not the circle's and the curve bulges where short segments meet long ones. An open arc takes fixed ends with the \
             circle's own derivatives. Two segments give handles of length 0 and are refused."
                .to_owned(),
        ],
        Method::Chen2 => vec![format!(
            "Why the paper prints 0.01903: the fixed point of t = L(t/3) with exact arc length is t = {}, and errs by {}. With his \
             equation (16) integrated by two-point Gauss quadrature the fixed point is t = {}, which is sqrt(2.4), and the error is {}. \
             The first is drawn unless --quadrature gauss2 asks for the second.",
            significant(3.0 * handle(method.into(), &quarter)?, 11),
            significant(error(method.into())?, 9),
            significant(3.0 * handle(Rule::Chen2Gauss2, &quarter)?, 11),
            significant(error(Rule::Chen2Gauss2)?, 6),
        )],
        Method::Chen3 => vec![format!(
            "Unequal joints are G1, not G2 as the paper says: the curvature at the end of a segment is {} at 30 degrees and {} at 60.",
            significant(end_curvature(method, 30.0)?, 11),
            significant(end_curvature(method, 60.0)?, 11),
        )],
        Method::LancasterBest => {
            let k = handle(method.into(), &quarter)?;
            let (best, normal) = (error(method.into())?, error(Method::Midpoint.into())?);
            vec![
                format!(
                    "With four segments his number errs by {}, the normal one by {}: {} % less. The least possible is {}, at {}.",
                    significant(best, 6),
                    significant(normal, 6),
                    significant(100.0 * (1.0 - best / normal), 2),
                    significant(error(Method::Minimax.into())?, 6),
                    significant(handle(Method::Minimax.into(), &quarter)?, 10),
                ),
                format!(
                    "His quarter crosses the circle at {} and {} degrees; to cross it at 30 the number would have to be {}.",
                    significant(crossing(k), 5),
                    significant(90.0 - crossing(k), 5),
                    significant(handle_crossing_at_30(), 11),
                ),
            ]
        }
        Method::LancasterDrawellipse => vec![format!(
            "The number is {}, lower than the normal one by {}; it errs less than his best number {}, {} against {}.",
            text(handle(method.into(), &quarter)?),
            significant(
                handle(Method::Midpoint.into(), &quarter)? - handle(method.into(), &quarter)?,
                5
            ),
            text(handle(Method::LancasterBest.into(), &quarter)?),
            significant(error(method.into())?, 6),
            significant(error(Method::LancasterBest.into())?, 6),
        )],
        Method::Apprich => {
            let inward = error(method.into())?;
            vec![
                format!(
                    "The handle is longest near 130 degrees and tends to 0 at half a turn: the method ends \
                     at {} degrees. On a quarter it errs {} times as much as the standard handle: smoothness is bought with accuracy.",
                    text(method.card().largest_angle),
                    significant(inward / error(Method::Midpoint.into())?, 2),
                ),
                format!(
                    "The paper's E, the largest 1 - r², is {} on a quarter; its E*, the error of apprich-scaled, is {}.",
                    significant(inward * (2.0 - inward), 10),
                    significant(error(Method::ApprichScaled.into())?, 10),
                ),
            ]
        }
        Method::ApprichPlus => vec![
            "The paper says that delta-plus \"merely yields the standard accuracy\": its order is 2, that of the chord.".to_owned(),
        ],
        Method::Goldapp => vec![format!(
            "w0 = {}; on a quarter its peak is {} % above that of minimax.",
            significant(goldapp_zero(), 9),
            significant(
                100.0 * (error(method.into())? / error(Method::Minimax.into())? - 1.0),
                3
            ),
        )],
        _ => Vec::new(),
    })
}

fn handle(rule: Rule, span: &Span) -> Result<f64> {
    Ok(rule.piece(span)?.handle_length())
}

/// The angle in degrees at which a quarter with the handle k first crosses the circle: with u = t(1-t), where H + G u = 0.
fn crossing(k: f64) -> f64 {
    let (h, g) = (6.0 - 6.0 * k - 9.0 * k * k, 8.0 - 24.0 * k + 18.0 * k * k);
    let t = (1.0 - (1.0 + 4.0 * h / g).sqrt()) / 2.0;
    let along = |t: f64| t * t * (3.0 - 2.0 * t) + 3.0 * k * t * (1.0 - t) * (1.0 - t);
    libm::atan2(along(t), along(1.0 - t)).to_degrees()
}

/// The handle of a quarter that crosses the circle at 30 degrees; the higher the handle, the later it does.
fn handle_crossing_at_30() -> f64 {
    let (mut low, mut high) = (0.551_8, 0.552);
    for _ in 0..50 {
        let middle = f64::midpoint(low, high);
        if crossing(middle) < 30.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// (3/2)(cbrt(√2+1) - cbrt(√2-1)), from where the curve crosses the circle.
fn goldapp_zero() -> f64 {
    let root2 = core::f64::consts::SQRT_2;
    1.5 * (libm::cbrt(root2 + 1.0) - libm::cbrt(root2 - 1.0))
}

/// The curvature at the ends, (2/3) times the distance of the second inner control point from the tangent over k².
fn end_curvature(method: Method, degrees: f64) -> Result<f64> {
    let span = Span::from_degrees(degrees);
    let k = handle(method.into(), &span)?;
    Ok(2.0 * (1.0 - span.c - k * span.s) / (3.0 * k * k))
}
