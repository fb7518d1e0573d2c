//! Whether segments are within a tolerance of a circle, by many samples: the extremes by roots take several times as long.
//!
//! F = |q|² - 1 of a segment is not larger than its largest sample over cos(6π/(2N)), as on an ellipse, and the distance from the unit circle
//! is F/(1 + √(1 + F)): of two F of one size, the one inside is farther.

use core::f64::consts::PI;

use kurbo::PathSeg;

use super::{DEGREE, EllipseFrame, MANY, MANY_WEIGHTS, SampleWeights, larger};
use crate::numeric::functions::unit_vector;
use crate::numeric::instructions::by_the_best;
use crate::shape::Truth;

/// How many samples are looked at side by side.
const LANES: usize = 4;

/// `None` where samples do not tell.
pub(crate) fn circle_decided(segments: &[PathSeg], truth: &Truth, tolerance: f64) -> Option<bool> {
    let radius = truth.larger_radius();
    let mut frame = EllipseFrame::new(truth);
    let between = unit_vector(DEGREE * PI / (2.0 * (MANY - 1) as f64)).x;
    let weights = &*MANY_WEIGHTS;
    let mut is_within = true;
    for segment in segments {
        let cubic = segment.to_cubic();
        let sample = by_the_best(
            #[inline(always)]
            || largest_size(&frame.framed(&cubic), weights),
        );
        // What is measured is rounded outward.
        let room = tolerance * (1.0 - 1e-9) - frame.rounding();
        let least = sample / (1.0 + (1.0 + sample).sqrt()) * radius;
        if least > tolerance + frame.rounding() {
            return Some(false);
        }
        let most = sample / between;
        let inside = most / (1.0 + (1.0 - most).sqrt()) * radius;
        is_within &= inside <= room && cubic.is_finite();
    }
    is_within.then_some(true)
}

/// The largest sample of |F|, in lanes: the last sample is the end.
#[inline(always)]
fn largest_size(points: &[[f64; 2]; 4], weights: &SampleWeights<MANY>) -> f64 {
    let size = |[x, y]: [f64; 2]| (x * x + y * y - 1.0).abs();
    let [p, q, r, s] = *points;
    let mut lanes = [0.0; LANES];
    for i in 0..MANY / LANES {
        for (lane, most) in lanes.iter_mut().enumerate() {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| weights[k][LANES * i + lane]);
            let along = |axis: usize| p[axis] * a + q[axis] * b + r[axis] * c + s[axis] * d;
            *most = larger(size([along(0), along(1)]), *most);
        }
    }
    lanes.into_iter().fold(size(s), larger)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Precision;
    use crate::{Circle, Cut, Options, Shape, approximate};

    #[test]
    fn what_samples_say_of_circles_is_so() {
        for i in 0..300 {
            let radius = libm::pow(10.0, (i % 29) as f64 / 7.0);
            let center = ((i * 7 % 101) as f64, -((i * 11 % 103) as f64));
            let options = Options {
                cut: Cut::Count(3 + i % 5),
                precision: Some(Precision::Fixed(3 + (i % 4) as u8)),
                ..Options::default()
            };
            let circle = Shape::Circle(Circle::new(center, radius).unwrap());
            let drawing = approximate(&circle, &options).unwrap();
            let (segments, truth) = (drawing.curve.segments, drawing.outline.unwrap().truth);
            let peak = drawing.error.peak();
            let told = |part: f64| circle_decided(&segments, &truth, part * peak);
            for part in [0.5, 0.99] {
                assert_eq!(told(part), Some(false), "{i}");
            }
            for part in [1.008, 2.0] {
                assert_eq!(told(part), Some(true), "{i}");
            }
            for part in [0.998, 0.9999, 1.000_01, 1.001] {
                let decided = told(part);
                assert!(decided.is_none_or(|is| is == (part > 1.0)), "{i} {part}");
            }
            assert_eq!(told(1.0), None);
        }
    }

    #[test]
    fn what_is_far_off_a_circle_is_not_within() {
        let truth = Circle::new((0.0, 0.0), 1.0).unwrap();
        let truth = Shape::Circle(truth).outline().unwrap().truth;
        let line = |from: (f64, f64), to: (f64, f64)| PathSeg::Line(kurbo::Line::new(from, to));
        let through_centre = [line((1.0, 0.0), (-1.0, 0.0))];
        // Samples tell the size of F, which is 1 there, and not its sign.
        assert_eq!(circle_decided(&through_centre, &truth, 0.41), Some(false));
        for tolerance in [0.42, 1.1] {
            assert_eq!(circle_decided(&through_centre, &truth, tolerance), None);
        }
        let beyond = [line((2.0, 0.0), (3.0, 0.0))];
        assert_eq!(circle_decided(&beyond, &truth, 2.1), None);
        assert_eq!(circle_decided(&beyond, &truth, 0.5), Some(false));
        let nowhere = [line((f64::NAN, 0.0), (1.0, 0.0))];
        assert_eq!(circle_decided(&nowhere, &truth, 1.0), None);
    }
}
