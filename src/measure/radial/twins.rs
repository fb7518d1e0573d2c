//! Segments that an axis of an ellipse or its centre mirrors onto one another: they stray alike, so that one of them is measured for all.
//!
//! The distance of a point changes by no more than the point moves. So a segment strays no farther than its mirror image and the largest
//! distance between their control points, and where that image was not measured itself but has one that was, than this and both distances.

use kurbo::{PathSeg, Vec2};

use super::NOISE;
use super::framed::{FramedPoints, SegmentDecimals, decimals_of};
use crate::numeric::double::Twice;
use crate::shape::{Exact, Truth};

/// How many segments others are compared with.
const MOST_SEEN: usize = 16;

/// How far apart control points may lie, as a part of the distances that were found: the statement grows by no more.
const APART: f64 = 4e-10;

/// Points of the frame, and of the plane over the larger radius, farther apart are no mirror images.
const FAR: f64 = 1e-9;

/// What was measured, and how far what was left out lies from its mirror images at most.
#[derive(Default)]
pub(super) struct Twins {
    measured: Vec<FramedPoints>,
    /// The control points of the first ones, measured or not, and how far they lie from images of what was.
    seen: Vec<(SegmentDecimals, f64)>,
    pub(super) apart: f64,
}

impl Twins {
    /// A segment in the frame of an ellipse; `None` where it need not be measured, since one that was is its mirror image, nearly. `found` is
    /// the smaller distance on either side so far.
    pub(super) fn without_twin(
        &mut self,
        segment: &PathSeg,
        truth: &Truth,
        exact: &Exact,
        found: f64,
    ) -> Option<FramedPoints> {
        let own = decimals_of(segment);
        let framed = || FramedPoints::of_truth(&own, truth, exact);
        if truth.is_circle() || !exact.is_about_center() {
            return Some(framed());
        }
        let limit = APART * found;
        // What the centre mirrors is seen before points are brought into the frame, which costs more.
        let in_center = (self.seen.iter())
            .map(|(other, apart)| apart + from_image_in_center(&own, other, truth, exact))
            .find(|&apart| apart <= limit);
        let (framed, apart) = if in_center.is_some() {
            (None, in_center)
        } else {
            let framed = framed();
            let mut images = (self.measured.iter()).flat_map(|one| apart(one, &framed, exact));
            let apart = images.find(|&apart| apart <= limit);
            (apart.is_none().then_some(framed), apart)
        };
        self.apart = self.apart.max(apart.unwrap_or(0.0));
        if self.seen.len() < MOST_SEEN {
            self.seen.push((own, apart.unwrap_or(0.0)));
            self.measured.extend(framed);
        }
        framed
    }
}

/// How far the control points of one segment lie from the images of another's in the centre at most; infinite where they are no such images,
/// and under a map.
fn from_image_in_center(
    (one, count): &SegmentDecimals,
    (other, as_many): &SegmentDecimals,
    truth: &Truth,
    exact: &Exact,
) -> f64 {
    if exact.is_mapped() || count != as_many {
        return f64::INFINITY;
    }
    let radius = truth.larger_radius();
    let mut most = 0.0_f64;
    for (p, q) in one.iter().zip(other) {
        let off = exact.off_image_in_center(*p, *q);
        if off.x.abs() + off.y.abs() > FAR * radius {
            return f64::INFINITY;
        }
        most = most.max(off.hypot());
    }
    with_rounding(most, exact)
}

/// How far the control points of one segment lie from the mirror images of another's in the centre and in both axes at most, in the user's
/// unit; infinite where they are no such images.
fn apart<'a>(
    one: &'a FramedPoints,
    other: &'a FramedPoints,
    exact: &'a Exact,
) -> impl Iterator<Item = f64> + 'a {
    // Under a map the axes of the frame are not those of the shape, and without one the centre was looked at.
    let images: &[[f64; 2]] = if exact.is_mapped() {
        &[[-1.0, -1.0]]
    } else {
        &[[1.0, -1.0], [-1.0, 1.0]]
    };
    images.iter().map(|&signs| {
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
    with_rounding(most, exact)
}

/// A distance with what its rounding, and that of both points, may have left out.
fn with_rounding(distance: f64, exact: &Exact) -> f64 {
    if distance == 0.0 {
        0.0
    } else {
        (1.0 + FAR) * distance + NOISE * exact.image(Vec2::new(1.0, 1.0)).hypot()
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
        let mut measured = 0;
        for segment in segments {
            let framed = twins.without_twin(segment, &truth, &exact, drawing.error.smaller());
            measured += usize::from(framed.is_some());
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
        assert!(twins.apart > 0.0 || measured == segments.len());
        measured
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
            let framed = twins.without_twin(segment, &truth, &exact, drawing.error.smaller());
            assert!(framed.is_some());
        }
    }
}
