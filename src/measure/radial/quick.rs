//! Whether the distance has an extreme on a part, by the sizes of its derivatives alone: a tenth of the time that balls take, and mostly
//! enough. The letters are those of `slopes`.

use super::part::{CubicPart, Motion, Sizes};
use super::peaks::{NEAR, Search};
use crate::numeric::lanes::{Lanes, Real};

/// What F and G say of a part, or of several.
pub(super) struct PartBounds<S> {
    /// The largest |F|, and the least G.
    excess: S,
    gradient: S,
    /// x, and the bounds on both sides where it is near.
    nearness: S,
    bounds: [S; 2],
}

/// How the distance runs along a part that is near.
pub(super) struct DistanceRun<S> {
    /// What |N| is at least: where that is positive, the distance rises or falls all along.
    pub(super) steep: S,
    /// Bounds of N'.
    pub(super) bend: [S; 2],
}

/// What the roundings of a few sums are off at most, as a part of those of sizes.
const ROUNDING: f64 = 1e-12;

impl PartBounds<f64> {
    /// The bounds on both sides; `None` where the part is not near.
    pub(super) fn bounds(&self) -> Option<[f64; 2]> {
        (self.nearness <= NEAR).then_some(self.bounds)
    }
}

impl DistanceRun<f64> {
    /// Whether the distance rises or falls all along.
    pub(super) fn is_monotone(&self) -> bool {
        self.steep > 0.0
    }
}

impl<const N: usize> PartBounds<Lanes<N>> {
    pub(super) fn one(&self, lane: usize) -> PartBounds<f64> {
        PartBounds {
            excess: self.excess.0[lane],
            gradient: self.gradient.0[lane],
            nearness: self.nearness.0[lane],
            bounds: self.bounds.map(|lanes| lanes.0[lane]),
        }
    }
}

impl<const N: usize> DistanceRun<Lanes<N>> {
    pub(super) fn one(&self, lane: usize) -> DistanceRun<f64> {
        DistanceRun {
            steep: self.steep.0[lane],
            bend: self.bend.map(|lanes| lanes.0[lane]),
        }
    }
}

impl<F: FnMut(f64, [f64; 2])> Search<'_, F> {
    /// Whether the distance has one extreme at most on an open near part that was found, or asks for nothing more: a largest distance outside, or
    /// inside.
    pub(super) fn leads_to_extreme(
        &mut self,
        part: &CubicPart,
        course: &DistanceRun<f64>,
        bounds: [f64; 2],
        start: f64,
    ) -> bool {
        let [low, high] = course.bend;
        let (side, curving) = match () {
            () if low > 0.0 => (1, low),
            () if high < 0.0 => (0, -high),
            () => return false,
        };
        let open = self.open(part, bounds, self.last_place);
        !open[side] || self.settle(part, start, curving)
    }

    /// What the control points tell, which cost little.
    #[inline(always)]
    pub(super) fn look<S: Real>(&self, part: &CubicPart<S>) -> PartBounds<S> {
        let [p, q] = part.least_place(self.center);
        let gradient = (p * p).scaled(self.alpha[0]) + (q * q).scaled(self.alpha[1]);
        self.look_by(part.certain_excess(), gradient.scaled(1.0 - 1e-14))
    }

    /// The same where F and G are between and at least so.
    #[inline(always)]
    pub(super) fn look_by<S: Real>(&self, [low, high]: [S; 2], gradient: S) -> PartBounds<S> {
        let excess = low.abs().larger(high.abs());
        let nearness = self.nearness(excess, gradient);
        let share = S::exact(1.0 + 1e-14) + nearness.scaled(1.3);
        let weight = share / gradient.sqrt().scaled(2.0);
        PartBounds {
            excess,
            gradient,
            nearness,
            bounds: [high * weight, low * weight.scaled(-1.0)],
        }
    }

    /// x.
    #[inline(always)]
    pub(super) fn nearness<S: Real>(&self, excess: S, gradient: S) -> S {
        let flattest = self.alpha[0].max(self.alpha[1]);
        (excess.abs() / gradient.scaled(2.0)).scaled(flattest)
    }

    /// How the distance runs along a near part, where sizes tell.
    ///
    /// There |s| αᵢ is at most n, itself at most 0.13, and mᵢ lies between 1/(1 + n) and 1/(1 - n), so that U is at most 1 + 1.15 n times the
    /// sum of the sizes and 1/D at most 1 + 3.42 n times 1/G. V and W are Σ αᵢ qᵢ qᵢ', which is small along a shape and differs from that in
    /// the middle by half of its largest change, but for 2.82 n and 1.15 n times the sum of the sizes.
    #[inline(always)]
    pub(super) fn course<S: Real>(
        &self,
        part: &CubicPart<S>,
        middle: &Motion<S>,
        look: &PartBounds<S>,
    ) -> DistanceRun<S> {
        let Sizes {
            place,
            velocity,
            acceleration,
            rising,
            bending: [low, high],
        } = part.sizes(middle);
        let [mut along, mut sizes, mut turning] = [S::exact(0.0); 3];
        for (i, alpha) in self.alpha.into_iter().enumerate() {
            along = along + (middle.place[i] * middle.velocity[i]).scaled(alpha);
            sizes = sizes + (place[i] * velocity[i]).scaled(alpha);
            let turns = velocity[i] * velocity[i] + place[i] * acceleration[i];
            turning = turning + turns.scaled(alpha);
        }
        let one = S::exact(1.0 + ROUNDING);
        let over = one / look.gradient;
        let s = look.excess * over * (S::exact(0.5) + look.nearness.scaled(1.5));
        let n = s.scaled(self.alpha[0].max(self.alpha[1])) + S::exact(ROUNDING);
        let least = along.abs() + turning.scaled(0.5);
        let v = least + (n * sizes).scaled(2.82);
        let w = (least + (n * sizes).scaled(1.15)) * one;
        let steepest = rising[0].abs().larger(rising[1].abs()).scaled(0.5);
        let rate = (steepest + s * (v + w)) * over * (one + n.scaled(3.42));
        let slack = (rate * v + s * turning * (one + n.scaled(1.15))) * one;
        let flattest = rising[0].larger(rising[1].scaled(-1.0)).scaled(0.5);
        DistanceRun {
            steep: flattest - s * w,
            bend: [low.scaled(0.5) - slack, high.scaled(0.5) + slack],
        }
    }

    /// How far from a place N vanishes, by a step of Newton's method with s by its first two terms.
    #[inline(always)]
    pub(super) fn step<S: Real>(&self, motion: &Motion<S>) -> S {
        let [x, y] = motion.place;
        let [a, b] = self.alpha;
        let over = motion.gradient(self.alpha).reciprocal();
        let first = motion.excess.scaled(0.5) * over;
        let second = ((x * x).scaled(a * a) + (y * y).scaled(b * b)) * over;
        let s = first * (S::exact(1.0) + (first * second).scaled(1.5));
        let slopes = motion.slopes(self.alpha, s);
        S::exact(0.0) - slopes.slope / slopes.bend
    }
}

#[cfg(test)]
mod tests {
    use kurbo::{Line, PathSeg, Point, Vec2};

    use super::*;
    use crate::measure::radial::checks::apart;
    use crate::measure::radial::{Known, Profile};
    use crate::shape::Truth;

    type Quiet = fn(f64, [f64; 2]);

    /// Does something with a search about a centre, from an ellipse of these radii.
    fn searched(radii: (f64, f64), center: Vec2, act: impl FnOnce(&mut Search<'_, Quiet>)) {
        let truth = Truth::new(Point::ORIGIN, radii.into(), Vec2::new(1.0, 0.0));
        let line = PathSeg::Line(Line::new((1.0, 0.0), (1.0, 0.1)));
        let profile = Profile::new(&line, &truth);
        let mut known = Known::default();
        let quiet: Quiet = |_, _| {};
        let mut search = Search::new(&profile, &mut known, quiet);
        search.center = center;
        act(&mut search);
    }

    fn assert_close(found: f64, expected: f64) {
        assert!(apart(found, expected) < 1e-9, "{found} is not {expected}");
    }

    #[test]
    fn sizes_tell_what_the_formulas_say() {
        let (x, y) = ([0.70, 0.74, 0.79, 0.83], [0.75, 0.72, 0.68, 0.66]);
        let times = |row: [f64; 4], factor: f64| row.map(|value| factor * value);
        // By the formulas in the comments, in another language.
        for (excess, points, center, nearness, bounds, steep, bend, step) in [
            (
                [0.020, 0.024, 0.03, 0.028, 0.022, 0.021, 0.025],
                [x, y],
                (0.02, -0.03),
                0.025_350_684_468_480_64,
                [0.010_071_455_891_210_295, -0.006_714_303_927_473_531],
                -0.021_323_591_127_420_05,
                [-0.129_905_387_777_309_8, 0.084_905_387_777_309_81],
                -0.125_540_336_376_643_5,
            ),
            (
                [-0.8, -0.65, -0.49, -0.35, -0.22, -0.11, 0.0],
                [times(x, 3.0), times(y, 3.0)],
                (0.06, -0.09),
                0.075_113_139_165_868_62,
                [0.0, 0.095_130_697_952_445_8],
                0.219_098_812_884_345_46,
                [-0.684_167_169_163_223_2, 0.534_167_169_163_222_3],
                2.429_502_948_969_597,
            ),
            (
                [0.21, 0.18, 0.14, 0.1, 0.07, 0.04, 0.0],
                [[-1.2, -1.25, -1.3, -1.33], times(y, 2.0)],
                (0.02, -0.03),
                0.047_844_709_742_094_226,
                [0.037_643_252_902_588_04, 0.0],
                0.060_591_847_035_666_82,
                [-0.238_862_762_349_707_57, 0.238_862_762_349_707_85],
                3.840_295_673_112_774_6,
            ),
        ] {
            // And the same with the axes exchanged.
            for (radii, points, (x, y)) in [
                ((1.0, 0.5), points, center),
                ((0.5, 1.0), [points[1], points[0]], (center.1, center.0)),
            ] {
                searched(radii, Vec2::new(x, y), |search| {
                    let part = CubicPart::new([0.0, 1.0], excess, points, false);
                    let middle = part.motion_at(0.5, search.center);
                    let look = search.look(&part);
                    assert_close(look.nearness, nearness);
                    let course = search.course(&part, &middle, &look);
                    let told = look.bounds().unwrap();
                    for i in 0..2 {
                        assert_close(told[i], bounds[i]);
                        assert_close(course.bend[i], bend[i]);
                    }
                    assert_close(course.steep, steep);
                    assert_eq!(course.is_monotone(), steep > 0.0);
                    assert_close(search.step(&middle), step);
                });
            }
        }
    }

    #[test]
    fn what_is_not_near_has_no_bounds() {
        searched((1.0, 0.5), Vec2::ZERO, |search| {
            // x = |F| / (2 G b²) with G = 1 and b² = 1/4.
            for (excess, is_near) in [(0.049, true), (-0.049, true), (0.051, false)] {
                let look = search.look_by([excess, 0.0], 1.0);
                assert_eq!(look.bounds().is_some(), is_near, "{excess}");
            }
        });
    }
}
