//! Where a curve on a sphere passes behind the limb.

use kurbo::{CubicBez, Line, PathSeg, Point, QuadBez};

use crate::curve::{Curve, control_points};
use crate::numeric::bernstein::Polynomial;
use crate::power;

/// A depth of less than this, in radii, is none: what is left of a curve that lies in the limb, or a joint that does.
const NO_DEPTH: f64 = 1e-12;

/// On which side of the limb.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LimbSide {
    Front,
    Back,
}

/// The curve, given in its own plane, in parts that lie on one side: `depth` is [a, b, c], the depth of (x, y) being a x + b y + c.
///
/// A closed curve that is seen whole stays closed; else the parts begin and end at the limb.
pub(super) fn cut(curve: &Curve, [a, b, c]: [f64; 3]) -> Vec<(LimbSide, Curve)> {
    let depth = |p: Point| {
        let depth = a * p.x + b * p.y + c;
        if depth.abs() < NO_DEPTH { 0.0 } else { depth }
    };
    let mut pieces = Vec::new();
    for segment in &curve.segments {
        push_pieces(&mut pieces, segment, depth);
    }
    let change = (1..pieces.len()).find(|&i| pieces[i].0 != pieces[i - 1].0);
    let Some(change) = change else {
        return pieces
            .first()
            .map_or_else(Vec::new, |&(side, _)| vec![(side, curve.clone())]);
    };
    if curve.closed {
        pieces.rotate_left(change);
    }
    let parts = pieces.chunk_by(|one, next| one.0 == next.0);
    let part = |pieces: &[(LimbSide, PathSeg)]| {
        let segments = pieces.iter().map(|&(_, segment)| segment).collect();
        (
            pieces[0].0,
            Curve {
                segments,
                closed: false,
            },
        )
    };
    parts.map(part).collect()
}

/// Appends the pieces of a segment, cut where its depth changes sign.
fn push_pieces(
    pieces: &mut Vec<(LimbSide, PathSeg)>,
    segment: &PathSeg,
    depth: impl Fn(Point) -> f64,
) {
    let depths: Vec<f64> = control_points(segment).into_iter().map(depth).collect();
    let polynomial = power::coefficients(&depths);
    let side = |from: f64, to: f64| {
        if power::value(polynomial, f64::midpoint(from, to)) < 0.0 {
            LimbSide::Back
        } else {
            LimbSide::Front
        }
    };
    let (mut rest, mut from) = (*segment, 0.0);
    for t in Polynomial::new(&depths).sign_changes().iter() {
        let (before, after) = split(&rest, (t - from) / (1.0 - from));
        pieces.push((side(from, t), before));
        (rest, from) = (after, t);
    }
    pieces.push((side(from, 1.0), rest));
}

/// The two parts of a segment before and after t, by de Casteljau's algorithm; they share their point digit for digit.
fn split(segment: &PathSeg, t: f64) -> (PathSeg, PathSeg) {
    match *segment {
        PathSeg::Line(Line { p0, p1 }) => {
            let middle = p0.lerp(p1, t);
            (Line::new(p0, middle).into(), Line::new(middle, p1).into())
        }
        PathSeg::Quad(QuadBez { p0, p1, p2 }) => {
            let (a, b) = (p0.lerp(p1, t), p1.lerp(p2, t));
            let middle = a.lerp(b, t);
            (
                QuadBez::new(p0, a, middle).into(),
                QuadBez::new(middle, b, p2).into(),
            )
        }
        PathSeg::Cubic(CubicBez { p0, p1, p2, p3 }) => {
            let (a, b, c) = (p0.lerp(p1, t), p1.lerp(p2, t), p2.lerp(p3, t));
            let (d, e) = (a.lerp(b, t), b.lerp(c, t));
            let middle = d.lerp(e, t);
            (
                CubicBez::new(p0, a, d, middle).into(),
                CubicBez::new(middle, e, c, p3).into(),
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::ParamCurve;

    #[test]
    fn parts_trace_the_curve_they_were_cut_from() {
        let cubic: PathSeg = CubicBez::new((0.0, 0.0), (1.0, 2.0), (3.0, 3.0), (4.0, -1.0)).into();
        let quad: PathSeg = QuadBez::new((0.0, 0.0), (1.0, 2.0), (3.0, 3.0)).into();
        let line: PathSeg = Line::new((0.0, 1.0), (2.0, 5.0)).into();
        for segment in [cubic, quad, line] {
            let (before, after) = split(&segment, 0.3);
            assert_eq!(before.end(), after.start());
            for i in 0..=10 {
                let t = f64::from(i) / 10.0;
                assert!(before.eval(t).distance(segment.eval(0.3 * t)) < 1e-15);
                assert!(after.eval(t).distance(segment.eval(0.3 + 0.7 * t)) < 2e-15);
            }
        }
    }
}
