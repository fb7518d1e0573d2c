//! What a card says beyond its table: where a source printed something else, and why. Every figure is computed.

use curveto::method::{Rule, Span, figures};
use curveto::number::{significant, text};
use curveto::{Method, Result};

/// The paragraphs for a method.
pub(super) fn notes(method: Method) -> Result<Vec<String>> {
    Ok(match method {
        Method::Chen1 => vec![
            "Unequal joints: a C2 spline by his system (11), so that tangent and curvature are continuous everywhere, but the tangents \
             are not the circle's and the curve bulges where short segments meet long ones. An open arc takes fixed ends with the \
             circle's own derivatives. Two segments give handles of length 0 and are refused."
                .to_owned(),
        ],
        Method::Chen2 => vec![chen2()?],
        Method::Chen3 => vec![format!(
            "Unequal joints are G1, not G2 as the paper says: the curvature at the end of a segment is {} at 30 degrees and {} at 60.",
            significant(figures::end_curvature(method, 30.0)?, 11),
            significant(figures::end_curvature(method, 60.0)?, 11),
        )],
        Method::LancasterBest => lancaster_best()?,
        Method::LancasterDrawellipse => vec![lancaster_drawellipse()?],
        Method::Apprich => apprich()?,
        Method::ApprichPlus => vec![
            "The paper says that delta-plus \"merely yields the standard accuracy\": its order is 2, that of the chord.".to_owned(),
        ],
        Method::Goldapp => vec![format!(
            "w0 = {}; on a quarter its peak is {} % above that of minimax.",
            significant(figures::GOLDAPP_ZERO, 9),
            significant(100.0 * (error(method)? / error(Method::Minimax)? - 1.0), 3),
        )],
        _ => Vec::new(),
    })
}

/// The handle of a quarter.
fn handle(rule: impl Into<Rule>) -> Result<f64> {
    Ok(rule
        .into()
        .piece(&Span::from_degrees(90.0))?
        .handle_length())
}

/// The peak error of a quarter.
fn error(rule: impl Into<Rule>) -> Result<f64> {
    let quarter = Span::from_degrees(90.0);
    Ok(rule.into().radial_error(&quarter)?.peak())
}

/// Where the paper's figure comes from.
fn chen2() -> Result<String> {
    Ok(format!(
        "Why the paper prints 0.01903: the fixed point of t = L(t/3) with exact arc length is t = {}, and errs by {}. With his \
             equation (16) integrated by two-point Gauss quadrature the fixed point is t = {}, which is sqrt(2.4), and the error is {}. \
             The first is drawn unless --quadrature gauss2 asks for the second.",
        significant(3.0 * handle(Method::Chen2)?, 11),
        significant(error(Method::Chen2)?, 9),
        significant(3.0 * handle(Rule::CHEN_2_GAUSS_2)?, 11),
        significant(error(Rule::CHEN_2_GAUSS_2)?, 6),
    ))
}

fn lancaster_best() -> Result<Vec<String>> {
    let k = handle(Method::LancasterBest)?;
    let (best, normal) = (error(Method::LancasterBest)?, error(Method::Midpoint)?);
    Ok(vec![
        format!(
            "With four segments his number errs by {}, the normal one by {}: {} % less. The least possible is {}, at {}.",
            significant(best, 6),
            significant(normal, 6),
            significant(100.0 * (1.0 - best / normal), 2),
            significant(error(Method::Minimax)?, 6),
            significant(handle(Method::Minimax)?, 10),
        ),
        format!(
            "His quarter crosses the circle at {} and {} degrees; to cross it at 30 the number would have to be {}.",
            significant(figures::crossing(k), 5),
            significant(90.0 - figures::crossing(k), 5),
            significant(figures::handle_crossing_at_30(), 11),
        ),
        replays(),
    ])
}

fn lancaster_drawellipse() -> Result<String> {
    Ok(format!(
        "The number is {}, lower than the normal one by {}; it errs less than his best number {}, {} against {}.",
        text(handle(Method::LancasterDrawellipse)?),
        significant(
            handle(Method::Midpoint)? - handle(Method::LancasterDrawellipse)?,
            5
        ),
        text(handle(Method::LancasterBest)?),
        significant(error(Method::LancasterDrawellipse)?, 6),
        significant(error(Method::LancasterBest)?, 6),
    ))
}

fn apprich() -> Result<Vec<String>> {
    let inward = error(Method::Apprich)?;
    Ok(vec![
        format!(
            "The handle is longest near 130 degrees and tends to 0 at half a turn: the method ends \
                     at {} degrees. On a quarter it errs {} times as much as the standard handle: smoothness is bought with accuracy.",
            text(Method::Apprich.card().largest_angle),
            significant(inward / error(Method::Midpoint)?, 2),
        ),
        format!(
            "The paper's E, the largest 1 - r², is {} on a quarter; its E*, the error of apprich-scaled, is {}.",
            significant(inward * (2.0 - inward), 10),
            significant(error(Method::ApprichScaled)?, 10),
        ),
    ])
}

/// Why his table prints other peaks: it was made in PostScript's single precision.
fn replays() -> String {
    const UNIT: f64 = 16_777_216.0;
    const CASES: [(u8, f32); 7] = [
        (2, 1.307_103_3),
        (3, 0.767_48),
        (3, 0.769_811_2),
        (4, 0.551_784),
        (5, 0.433_072),
        (6, 0.357_204_5),
        (8, 0.265_203_1),
    ];
    let case = |&(n, k): &(u8, f32)| {
        let [peak, mean] = figures::in_single_precision(n, k).map(f64::from);
        let handle = text((f64::from(k) * 1e7).round() / 1e7);
        let units = text(peak * UNIT);
        format!(
            "{n} splines with {handle} peak {} ({units}) mean {}",
            significant(peak, 6),
            significant(mean, 6)
        )
    };
    format!(
        "His table is PostScript's single precision: near 1 its numbers are whole multiples of 2^-24 apart, and his peaks for 4, 5, 6 and \
         8 splines are 4458, 1139, 400 and 68 of them. At 91 points, t = i/90, single precision gives, the peak in 2^-24 in \
         brackets: {}. So the printed peaks and means of 2 and 3 splines are those of the first two numbers here, not of the numbers that he \
         prints. His other peaks are a few units off these, where he sampled being unknown, and his mean of 6 is unexplained.",
        CASES.iter().map(case).collect::<Vec<_>>().join("; ")
    )
}
