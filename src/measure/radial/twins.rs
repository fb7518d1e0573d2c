//! Segments that an axis of an ellipse or its centre mirrors onto one another: they stray alike, so that one of them is measured for all.
//!
//! The distance of a point changes by no more than the point moves. So a segment strays no farther than its mirror image and the largest
//! distance between their control points.

use kurbo::Vec2;

use super::NOISE;
use super::framed::FramedPoints;
use crate::numeric::double::Twice;
use crate::shape::Exact;

/// How many measured segments others are compared with.
const MOST_SEEN: usize = 16;

/// How far apart control points may lie, as a part of the distances that were found: the statement grows by no more.
const APART: f64 = 4e-10;

/// Points of the frame farther apart are no mirror images.
const FAR: f64 = 1e-9;

/// What was measured, and how far what was left out lies from its mirror images at most.
#[derive(Default)]
pub(super) struct Twins {
    seen: Vec<FramedPoints>,
    pub(super) apart: f64,
}

impl Twins {
    /// Whether a segment need not be measured, since one that was is its mirror image, nearly; `found` is the smaller distance on either
    /// side so far. Else it is kept for those to come.
    pub(super) fn spare(&mut self, segment: &FramedPoints, exact: &Exact, found: f64) -> bool {
        if !exact.is_about_center() {
            return false;
        }
        let nearest = {
            let mut images = self
                .seen
                .iter()
                .flat_map(|seen| apart(seen, segment, exact));
            images.find(|&apart| apart <= APART * found)
        };
        if let Some(apart) = nearest {
            self.apart = self.apart.max(apart);
        } else if self.seen.len() < MOST_SEEN {
            self.seen.push(*segment);
        }
        nearest.is_some()
    }
}

/// How far the control points of one segment lie from the mirror images of another's in the centre and in both axes at most, in the user's
/// unit; infinite where they are no such images.
fn apart<'a>(
    one: &'a FramedPoints,
    other: &'a FramedPoints,
    exact: &'a Exact,
) -> impl Iterator<Item = f64> + 'a {
    // Under a map the axes of the frame are not those of the shape.
    let count = if exact.is_mapped() { 1 } else { 3 };
    let images = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];
    images.into_iter().take(count).map(move |signs| {
        let is_reversed = signs != [-1.0, -1.0];
        let image = |i: usize| other.points()[if is_reversed { 3 - i } else { i }];
        between(one.points(), image, signs, exact)
    })
}

fn between(
    one: &[Twice; 4],
    image: impl Fn(usize) -> Twice,
    signs: [f64; 2],
    exact: &Exact,
) -> f64 {
    let mut most = 0.0_f64;
    for (i, p) in one.iter().enumerate() {
        let q = image(i);
        let part = |i: usize| q[i].plus(p[i].scaled(-signs[i])).value();
        let off = Vec2::new(part(0), part(1));
        if off.x.abs() + off.y.abs() > FAR {
            return f64::INFINITY;
        }
        most = most.max(exact.image(off).hypot());
    }
    if most == 0.0 {
        0.0
    } else {
        (1.0 + FAR) * most + NOISE * exact.image(Vec2::new(1.0, 1.0)).hypot()
    }
}

#[cfg(test)]
mod tests {
    use kurbo::Affine;

    use super::*;
    use crate::measure::radial::error;
    use crate::number::Precision;
    use crate::{Angle, Cut, Ellipse, Method, Options, Rule, Shape, approximate};

    /// How many segments of a turned ellipse off the origin have to be measured.
    fn measured(cut: Cut, transform: Affine) -> usize {
        let ellipse = Ellipse::new((40.3, -17.9), (31.7, 12.1), Angle::from_degrees(33.0));
        let options = Options {
            rule: Rule::Method(Method::Minimax),
            cut,
            transform,
            precision: Some(Precision::Full),
        };
        let drawing = approximate(&Shape::Ellipse(ellipse.unwrap()), &options).unwrap();
        let (truth, segments) = (drawing.outline.unwrap().truth, &drawing.curve.segments);
        let exact = truth.frame.exact(truth.radii);
        let mut twins = Twins::default();
        for segment in segments {
            let framed = FramedPoints::of_truth(segment, &truth, &exact);
            twins.spare(&framed, &exact, drawing.error.smaller());
        }
        let singly = segments.iter().map(|segment| error([segment], &truth));
        let all = singly.reduce(crate::RadialError::with).unwrap();
        for (all, stated) in [
            (all.outward, drawing.error.outward),
            (all.inward, drawing.error.inward),
        ] {
            let [least, most] = [-1e-11, 9e-10].map(|part| (1.0 + part) * all);
            assert!(stated >= least && stated <= most, "{stated} for {all}");
        }
        assert!(twins.apart > 0.0 || twins.seen.len() == segments.len());
        twins.seen.len()
    }

    #[test]
    fn the_images_in_the_axes_and_in_the_centre_are_spared() {
        let plain = Affine::IDENTITY;
        assert_eq!(measured(Cut::Count(4), plain), 1);
        assert_eq!(measured(Cut::Count(8), plain), 2);
        assert_eq!(measured(Cut::Adaptive(8), plain), 2);
        // What an odd number of segments has is one axis.
        assert_eq!(measured(Cut::Count(5), plain), 3);
        // Under a map only the centre is left.
        assert_eq!(measured(Cut::Count(4), Affine::skew(0.3, 0.1)), 2);
        let joints = [10.0, 80.0, 150.0, 290.0].map(Angle::from_degrees);
        assert_eq!(measured(Cut::At(joints.to_vec()), plain), 4);
    }

    #[test]
    fn what_rounding_moves_is_measured() {
        let ellipse = Ellipse::new((40.303, -17.907), (31.7, 12.1), Angle::from_degrees(33.0));
        let options = Options {
            precision: Some(Precision::Fixed(2)),
            ..Options::default()
        };
        let drawing = approximate(&Shape::Ellipse(ellipse.unwrap()), &options).unwrap();
        let truth = drawing.outline.unwrap().truth;
        let exact = truth.frame.exact(truth.radii);
        let mut twins = Twins::default();
        for segment in &drawing.curve.segments {
            let framed = FramedPoints::of_truth(segment, &truth, &exact);
            assert!(!twins.spare(&framed, &exact, drawing.error.smaller()));
        }
    }
}
