//! No distance depends on the unit of length: powers of two scale all of it exactly, but for the decimals of its numbers.

use kurbo::{Affine, CubicBez, PathSeg, Point, Vec2};

use super::Dice;
use crate::measure::radial::known::Known;
use crate::measure::radial::{Profile, nearly};
use crate::method::{Method, Span};
use crate::numeric::functions::power;
use crate::radial_error::RadialError;
use crate::shape::Truth;

/// Segments along an ellipse, nearer and farther, and some that pass its centre.
fn segments(truth: &Truth) -> Vec<PathSeg> {
    let mut dice = Dice(11);
    let mut all = Vec::new();
    for size in [100.0, 30.0, 8.0, 2.0] {
        let piece = Method::Minimax.piece(&Span::from_degrees(size)).unwrap();
        for from in [-10.0_f64, 50.0, 80.0, 171.0] {
            let ends = [from, from + size].map(|angle| Vec2::from_angle(angle.to_radians()));
            all.push(truth.placement() * piece.between(ends));
        }
    }
    for _ in 0..40 {
        let points = [(); 4].map(|()| {
            let [x, y] = dice.some::<2>();
            truth.placement() * Point::new(1.5 * x, 1.5 * y)
        });
        let [a, b, c, d] = points;
        all.push(PathSeg::Cubic(CubicBez::new(a, b, c, d)));
    }
    all
}

fn truths() -> [Truth; 3] {
    [(1.0, 1.0), (1.0, 0.7), (0.04, 1.0)].map(|radii| {
        let axis = Vec2::new(0.6, 0.8);
        Truth::new(Point::new(0.375, -0.25), radii.into(), axis)
    })
}

#[test]
fn distances_and_their_bounds_scale_as_lengths_do() {
    for truth in truths() {
        for segment in segments(&truth) {
            let base = Profile::new(&segment, &truth);
            for exponent in [-60, -20, 20, 60] {
                let scale = power(2.0, exponent);
                let scaled = Profile::new(&(Affine::scale(scale) * segment), &truth.scaled(scale));
                // Half a unit in the last place of each number, whose size is 4 at most.
                let near = |a: f64, b: f64| (a / scale - b).abs() < 16.0 * f64::EPSILON;
                for i in 0..=8 {
                    let t = f64::from(i) / 8.0;
                    assert!(near(scaled.at(t), base.at(t)), "{exponent} {t}");
                }
                let bounds = |profile: &Profile| {
                    let mut range = RadialError::default();
                    profile.visit_bounds(&mut Known::default(), |_, bounds| {
                        range.take_in_all(bounds);
                    });
                    range
                };
                let (a, b) = (bounds(&scaled), bounds(&base));
                assert!(near(a.outward, b.outward) && near(a.inward, b.inward));
                let mean = |profile: &Profile| profile.integral(|_, distance| distance);
                assert!(near(mean(&scaled), mean(&base)), "{exponent}");
            }
        }
    }
}

#[test]
fn what_samples_tell_scales_as_lengths_do() {
    for truth in truths() {
        for segment in segments(&truth) {
            for exponent in [-60, -20, 20, 60] {
                let scale = power(2.0, exponent);
                let (larger, wider) = (Affine::scale(scale) * segment, truth.scaled(scale));
                let told = nearly::nearly([segment], &truth);
                let expected = told.map(|between| between.map(|bound| bound * scale));
                assert_eq!(nearly::nearly([larger], &wider), expected, "{exponent}");
                let bound = nearly::bound([segment], &truth) * scale;
                assert_eq!(nearly::bound([larger], &wider), bound, "{exponent}");
            }
        }
    }
}
