//! Joints that equalise the error of an ellipse's segments: flat ellipses need fewer of them so.
//!
//! An affine map M carries a radial error ρ at the parametric angle θ of the unit circle to the distance ρ w(θ) from the ellipse,
//! measured along its normal, with
//!
//! ```text
//! w(θ) = |det M| / |M u'(θ)|,   u(θ) = (cos θ, sin θ)
//! ```
//!
//! (rx ry / sqrt(rx² sin²θ + ry² cos²θ) for the radii rx, ry; derived). A segment errs by the largest ρ w along it, to first order.
//! Marching through the sweep with segments as long as an error T lets them be takes f(T) of them, and no cut takes fewer where
//! a longer segment errs more; f falls with T as T^(-1/order), so that the T of a whole count is found in a few steps.

mod by_lobes;
#[cfg(test)]
pub(crate) mod costs;
mod errors;
mod level;
mod lobes;
mod march;
mod paths;
mod touching;

use super::Joints;
use crate::method::{Ends, Method, Rule};
use crate::shape::{Outline, UnitArc};
pub(crate) use by_lobes::{around, nearly, roughly};
use errors::Errors;
#[cfg(test)]
pub(crate) use errors::LOOKS;
use level::Level;
use lobes::Lobes;
use paths::add_images;

/// Joints lie on multiples of this many degrees, so that their mirror images are exact.
const GRID: f64 = 1.0 / (1 << 30) as f64;

/// By how much more joints may err that mirror one another.
const BARE: f64 = 1.5;

/// The most steps for the length of one segment, and for the error that makes the count whole.
const MOST_STEPS: usize = 40;

/// Beyond this count joints stay at equal angles: the error of this many segments is below the digits of a coordinate.
const MOST: usize = 4096;

/// Whether the rule's pieces join at uneven angles, each one on its own.
pub(crate) fn serves(rule: Rule) -> bool {
    match rule.method() {
        None | Some(Method::Chen1 | Method::LancasterBest | Method::LancasterDrawellipse) => false,
        Some(method) => method.card().ends == Ends::OnCircle,
    }
}

/// An arc, and how far the method's segments stray from it.
pub(crate) struct Balance {
    arc: UnitArc,
    errors: Errors,
    lobes: Lobes,
    /// The parametric angle of an end of the short axis, in degrees.
    axis: f64,
    order: f64,
    /// How much shorter segments of one error are at the sharp ends than at the others, by the method's order.
    root: f64,
    largest_angle: f64,
}

impl Balance {
    /// `None` where equal angles are best or the rule serves no others: on circles, and for methods that lean on equal pieces.
    pub(crate) fn new(outline: &Outline, rule: Rule) -> Option<Self> {
        if outline.truth.is_circle() || !serves(rule) {
            return None;
        }
        let law = rule.method()?.card().law?;
        let axes = outline.axes();
        let order = f64::from(law.order);
        Some(Self {
            arc: outline.unit,
            errors: Errors::new(rule, law, axes.short),
            lobes: Lobes::new(rule, order, axes.short),
            axis: axes.angle,
            order,
            root: libm::pow(axes.short, 1.0 / order),
            largest_angle: rule.largest_uneven_angle(axes.short)?,
        })
    }

    /// Whether the ellipse is so flat that a longer segment may err less than a shorter one for its sharp ends.
    pub(crate) fn is_sharp(&self) -> bool {
        self.errors.is_sharp()
    }

    /// Whether fewer segments than marching takes may be within an error, over the larger radius: where the first order does not tell it.
    pub(crate) fn may_take_fewer(&self, allowed: f64) -> bool {
        !self.errors.is_quick() && self.errors.is_rough(allowed)
    }

    /// Whether fewer than `count` segments may be within an error, over the larger radius, though estimates found none: samples do not tell it
    /// where the first order is too rough. Lobes take too little for what they do not tell, so that none below their `least` count are.
    pub(crate) fn may_be_beaten(&self, allowed: f64, least: usize, count: usize) -> bool {
        let is_missed = count > least && self.lobes.is_rough(allowed);
        is_missed && self.errors.is_quick() || self.may_take_fewer(allowed)
    }

    /// This many degrees after the start, counted upwards from the short axis: that leaves every distance as it is.
    fn past_axis(&self, way: f64) -> f64 {
        let sign = 1.0_f64.copysign(self.arc.sweep.degrees());
        sign * (self.arc.start.degrees() - self.axis) + way
    }

    /// The error of a segment of `size` degrees that begins `way` degrees after the start, over the larger radius.
    fn error(&self, way: f64, size: f64) -> f64 {
        let from = self.past_axis(way);
        if self.errors.is_quick() && size > lobes::SHORTEST {
            self.lobes.size(from, size)
        } else {
            self.errors.of(from, size)
        }
    }

    /// Whether a closed shape starts on an axis, so that its halves mirror one another.
    fn mirrors(&self) -> bool {
        self.arc.closed && self.on_axis(self.arc.start.degrees())
    }

    /// Whether an angle lies on an axis of the ellipse.
    fn on_axis(&self, degrees: f64) -> bool {
        (degrees - self.axis) % 90.0 == 0.0
    }

    /// The part of the sweep that is computed: half of it where the other half is its mirror image.
    fn computed(&self, mirrored: bool) -> f64 {
        self.arc.sweep.degrees().abs() / if mirrored { 2.0 } else { 1.0 }
    }

    /// Joints that equalise the error of this many segments, from a cut of the whole sweep into as many that was begun; an even number of a
    /// closed shape's mirror in both axes. And the peak error over the larger radius, where the lobes tell it. `None` where so few segments
    /// have no room to differ or are too long for the method, or where marching takes more of them within `allowed`.
    pub(crate) fn joints_from(
        &self,
        count: usize,
        begun: Option<Level>,
        allowed: f64,
    ) -> Option<(Joints, Option<f64>)> {
        let mirrored = self.mirrors() && count.is_multiple_of(2);
        let pieces = if mirrored { count / 2 } else { count };
        let whole = self.computed(mirrored);
        if count > MOST || pieces < 2 || whole > pieces as f64 * self.largest_angle {
            return None;
        }
        let begun = begun.filter(|_| !mirrored);
        let (mut ways, peak) = self.equalised(whole, pieces, begun, allowed)?;
        let half = whole.copysign(self.arc.sweep.degrees()) / 2.0;
        let on_grid = |way: f64| (way / GRID).round() * GRID;
        ways[1..pieces]
            .iter_mut()
            .for_each(|way| *way = on_grid(*way));
        if self.on_axis(self.arc.start.degrees() + half) {
            let mut even = ways.clone();
            for i in 1..=pieces / 2 {
                even[i] = on_grid(f64::midpoint(ways[i], whole - ways[pieces - i]));
                even[pieces - i] = whole - even[i];
            }
            // A sharp end that hides behind a joint on one side is bare on the other.
            let is_bare = peak.is_none() && self.most(&even) > BARE * self.most(&ways);
            if !is_bare {
                ways = even;
            }
        }
        if mirrored {
            add_images(&mut ways, 2.0 * whole, 1);
        }
        Some((Joints::after(&self.arc, &ways), peak))
    }

    /// The errors of the segments between joints.
    fn errors_between(&self, ways: &[f64]) -> impl Iterator<Item = f64> {
        ways.windows(2)
            .map(|pair| self.error(pair[0], pair[1] - pair[0]))
    }

    /// The largest of them.
    fn most(&self, ways: &[f64]) -> f64 {
        self.errors_between(ways).fold(0.0, f64::max)
    }

    /// The error of as many equal segments.
    fn equal(&self, whole: f64, pieces: usize) -> f64 {
        let size = whole / pieces as f64;
        let errors = (0..pieces).map(|i| self.error(i as f64 * size, size));
        errors.fold(0.0, f64::max)
    }

    /// The ways to the joints of this many segments of equal error, both ends included, and that where the lobes tell it; `None` where the
    /// method's largest angle forbids it, or as in [`Self::evened`].
    fn equalised(
        &self,
        whole: f64,
        pieces: usize,
        begun: Option<Level>,
        most: f64,
    ) -> Option<(Vec<f64>, Option<f64>)> {
        if let Some(level) = self.levelled(whole, pieces, begun) {
            return Some((level.ways, Some(level.most)));
        }
        let narrowed = |equal: f64| Some((self.evened(whole, pieces, equal, most)?, None));
        if self.errors.is_quick() {
            let equal = self.equal(whole, pieces);
            if self.errors.is_worth_a_look(equal) {
                return narrowed(equal);
            }
        }
        let count = pieces as f64;
        let mut joints = Vec::with_capacity(pieces + 1);
        let mut allowed = self.error(0.0, whole / count);
        for _ in 0..MOST_STEPS {
            let taken = self.march(whole, allowed, 2 * pieces + 8, &mut joints);
            if (taken / count - 1.0).abs() <= 1e-7 {
                joints.truncate(pieces);
                joints.push(whole);
                return (joints.len() == pieces + 1).then_some((joints, None));
            }
            allowed *= libm::pow(taken / count, self.order).clamp(1e-3, 1e3);
        }
        // What samples tell of a peak may leap.
        narrowed(self.equal(whole, pieces))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Angle, Cut, Ellipse, Options, Shape, Tolerance, approximate};

    fn ellipse(flatness: f64) -> Shape {
        Shape::Ellipse(Ellipse::new((0.0, 0.0), (3.0, 3.0 * flatness), Angle::ZERO).unwrap())
    }

    fn draw(shape: &Shape, cut: Cut) -> crate::Drawing {
        let options = Options {
            cut,
            ..Options::default()
        };
        approximate(shape, &options).unwrap()
    }

    #[test]
    fn the_law_of_many_segments_is_the_mean_sixth_root_of_the_weight() {
        for (flatness, ratio) in [(0.5, 0.94), (0.2, 0.84), (0.1, 0.76), (0.01, 0.53)] {
            let outline = ellipse(flatness).outline().unwrap();
            let balance = Balance::new(&outline, Rule::default()).unwrap();
            let allowed = 1e-22;
            let equal = 360.0 / balance.settled(0.0, allowed, 0.1);
            let ours = 2.0 * balance.march(180.0, allowed, 2 * MOST, &mut Vec::new());
            assert!(
                (ours / equal - ratio).abs() < 0.006,
                "{flatness}: {ours} of {equal}"
            );
        }
    }

    #[test]
    fn flat_ellipses_need_fewer_segments_within_the_tolerance() {
        for (flatness, most) in [(0.5, 0.98), (0.2, 0.87), (0.1, 0.81), (0.01, 0.69)] {
            let shape = ellipse(flatness);
            let tolerance = 3e-10;
            let equal = (2..1000)
                .find(|&count| draw(&shape, Cut::Count(count)).error.peak() <= tolerance)
                .unwrap();
            let drawing = draw(&shape, Cut::Tolerance(Tolerance::Absolute(tolerance)));
            assert!(drawing.error.peak() <= tolerance);
            let ours = drawing.curve.segments.len() as f64;
            assert!(ours <= most * equal as f64, "{flatness}: {ours} of {equal}");
        }
    }

    #[test]
    fn equal_angles_are_never_better() {
        let draw = |shape: &Shape, method, cut| {
            let options = Options {
                rule: Rule::Method(method),
                cut,
                ..Options::default()
            };
            approximate(shape, &options).unwrap()
        };
        for method in [Method::Minimax, Method::Chen3] {
            for flatness in [0.99, 0.9, 0.6, 0.3, 0.1] {
                let shape = ellipse(flatness);
                for tolerance in [0.3, 0.1, 1e-2, 2e-3, 1e-4, 1e-6] {
                    let cut = Cut::Tolerance(Tolerance::Absolute(tolerance));
                    let ours = draw(&shape, method, cut);
                    assert!(ours.error.peak() <= tolerance);
                    for fewer in 2..ours.curve.segments.len() {
                        let equal = draw(&shape, method, Cut::Count(fewer));
                        assert!(
                            equal.error.peak() > tolerance,
                            "{method:?} {flatness} {tolerance} {fewer}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn peaks_are_equal_and_joints_mirror() {
        for (flatness, count) in [(0.5, 8), (0.1, 10), (0.03, 14), (0.1, 9)] {
            let options = Options {
                cut: Cut::Adaptive(count),
                precision: Some(crate::number::Precision::Full),
                ..Options::default()
            };
            let drawing = approximate(&ellipse(flatness), &options).unwrap();
            let truth = drawing.outline.unwrap().truth;
            let peaks: Vec<f64> = drawing
                .curve
                .segments
                .iter()
                .map(|segment| crate::measure::radial::error([segment], &truth).peak())
                .collect();
            let least = peaks.iter().copied().fold(f64::INFINITY, f64::min);
            let largest = peaks.iter().copied().fold(0.0, f64::max);
            assert!(largest / least < 1.15, "{flatness} {count}: {peaks:?}");
            let angles = &drawing.angles;
            for i in 0..=count {
                assert_eq!(angles[i] + angles[count - i], 360.0);
                if count % 2 == 0 && i <= count / 2 {
                    assert_eq!(angles[i] + angles[count / 2 - i], 180.0);
                }
            }
        }
    }

    #[test]
    fn the_lobes_tell_the_peak_of_any_joints() {
        let mut told = 0;
        for i in 0..2000 {
            let at = |k: usize| (i * k % 1009) as f64 / 1009.0;
            let radii = (100.0, 100.0 * libm::pow(0.02, at(7)));
            let degrees = Angle::from_degrees;
            let (start, sweep) = (degrees(360.0 * at(11)), degrees(720.0 * at(17) - 360.0));
            let arc = crate::Arc::new((3.0, -2.0), radii, degrees(180.0 * at(23)), start, sweep);
            let shape = Shape::Arc(arc.unwrap());
            let outline = shape.outline().unwrap();
            let count = 1 + i % 7;
            let methods = [
                Method::Midpoint,
                Method::Minimax,
                Method::Goldapp,
                Method::Area,
            ];
            let options = Options {
                rule: Rule::Method(methods[i % 4]),
                cut: Cut::Count(count),
                precision: Some(crate::number::Precision::Full),
                ..Options::default()
            };
            let Ok(drawing) = approximate(&shape, &options) else {
                continue;
            };
            let joints = Joints::equal(&outline.unit, count).unwrap();
            let (axes, sizes) = (outline.axes(), [100.0; 2]);
            if let Some([low, high]) = nearly(options.rule, axes, sizes, &joints) {
                told += 1;
                let (middle, half) = (f64::midpoint(low, high), (high - low) / 2.0);
                let off = (middle - drawing.error.peak()).abs() / half;
                assert!(off < if low > 0.0 { 0.25 } else { 1.0 }, "{i}: {off}");
            }
        }
        assert!(told > 1000, "{told}");
    }

    #[test]
    fn joints_mirror_where_an_axis_halves_the_arc() {
        for (start, sweep, symmetric) in [
            (20.0, 140.0, true),
            (160.0, -140.0, true),
            (-60.0, 121.0, false),
        ] {
            let [from, by] = [start, sweep].map(Angle::from_degrees);
            let arc = crate::Arc::new((0.0, 0.0), (3.0, 1.0), Angle::ZERO, from, by);
            let outline = Shape::Arc(arc.unwrap()).outline().unwrap();
            let balance = Balance::new(&outline, Rule::default()).unwrap();
            for count in [2, 5] {
                let angles = balance
                    .joints_from(count, None, f64::INFINITY)
                    .unwrap()
                    .0
                    .angles;
                let off = angles[1] + angles[count - 1] - (2.0 * start + sweep);
                assert_eq!(off.abs() < 1e-12, symmetric, "{start} {count}: {off}");
            }
        }
    }
}
