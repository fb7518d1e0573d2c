//! The fewest equal segments.

use core::ops::RangeInclusive;

use crate::approximate::{Request, Sketch};
use crate::joints::Joints;
use crate::joints::adaptive::Balance;

/// How many counts are tried one by one, from the least on and below the one that halving finds: on an ellipse even and odd ones differ.
const FEW: usize = 16;

/// From so many segments on halving alone decides.
const MANY: usize = 1000;

/// The part of their number to which it does: the last one of hundreds of thousands is not worth the seconds that it takes.
const FINEST: usize = 4096;

/// The first of these counts that gives something. All of them are tried where they are `uneven`, but for many; else what one of them gives, larger ones
/// give too, but for a few: they are halved, since trying one after the other would take as long as the square of their number.
pub(super) fn fewest_equal<T>(
    counts: RangeInclusive<usize>,
    uneven: bool,
    mut at: impl FnMut(usize) -> Option<T>,
) -> Option<T> {
    let (first, last) = counts.into_inner();
    let tried = match () {
        () if first > MANY => first.saturating_sub(1),
        () if uneven => last,
        () => last.min(first + FEW),
    };
    let found = (first..=tried).find_map(&mut at);
    if found.is_some() || tried >= last {
        return found;
    }
    let (mut low, mut high) = (tried + 1, last);
    let mut found = at(high)?;
    while high - low > high / FINEST {
        let middle = usize::midpoint(low, high);
        match at(middle) {
            Some(fewer) => (found, high) = (fewer, middle),
            None => low = middle + 1,
        }
    }
    let below = high.saturating_sub(FEW).max(tried + 1)..high;
    let fewer = (high <= MANY).then(|| below.into_iter().find_map(at));
    Some(fewer.flatten().unwrap_or(found))
}

impl Request<'_> {
    /// As few equal segments as the method's largest angle lets be, where they are fewer than this count and within the tolerance: a sharp end in
    /// the middle of so long a segment may be harmless, and marching, which takes the longest first, leaves it elsewhere.
    pub(super) fn least_equal(
        &self,
        balance: &Balance,
        count: usize,
        tolerance: f64,
    ) -> Option<Sketch> {
        let least = balance.least_by_angle();
        if least >= count || !balance.is_sharp() {
            return None;
        }
        let joints = Joints::equal(&self.outline.unit, least).ok()?;
        self.within(joints, None, tolerance).ok()?
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Angle, Arc, Cut, Method, Options, Shape, Tolerance, approximate};

    #[test]
    fn equal_segments_near_the_largest_angle_are_found() {
        let degrees = Angle::from_degrees;
        for (method, radii, start, sweep, tolerance) in [
            (Method::Area, (4.368, 2.663e-4), -92.14, -358.4, 4.18e-4),
            (Method::Minimax, (3.743, 2.79e-5), 111.34, 354.0, 4.4e-5),
            (Method::Chen3, (9.145, 4.133e-5), 72.56, -359.28, 1.48e-4),
            (Method::Curvature, (4.575, 4.65e-6), 41.89, 356.87, 4.37e-4),
            // A whole turn less a degree, in thirds of 120 degrees.
            (Method::Apprich, (1.5, 1.5852e-5), 89.885, 353.357, 6.67e-5),
        ] {
            let [start, sweep] = [start, sweep].map(degrees);
            let arc = Arc::new((0.0, 0.0), radii, Angle::ZERO, start, sweep);
            let shape = Shape::Arc(arc.unwrap());
            let segments = |cut| {
                let options = Options {
                    rule: method.into(),
                    cut,
                    ..Options::default()
                };
                let drawing = approximate(&shape, &options).ok()?;
                let is_within = drawing.error.peak() <= tolerance;
                is_within.then_some(drawing.curve.segments.len())
            };
            let least = (1..9).find_map(|count| segments(Cut::Count(count)));
            let found = segments(Cut::Tolerance(Tolerance::Absolute(tolerance)));
            assert_eq!(found, least, "{method:?}");
        }
    }

    /// What is found, and how many counts were tried.
    fn searched(
        counts: RangeInclusive<usize>,
        uneven: bool,
        serves: impl Fn(usize) -> bool,
    ) -> (Option<usize>, usize) {
        let mut tries = 0;
        let found = fewest_equal(counts, uneven, |count| {
            tries += 1;
            serves(count).then_some(count)
        });
        (found, tries)
    }

    #[test]
    fn the_first_count_that_serves_is_found_in_a_few_tries() {
        for least in [1, 5, 16, 17, 18, 33, 200, 399, 400] {
            let (found, tries) = searched(1..=400, false, |count| count >= least);
            assert_eq!(found, Some(least));
            assert!(tries <= 45, "{least}: {tries}");
        }
        assert_eq!(searched(3..=400, false, |_| false), (None, 18));
        let none = RangeInclusive::new(5, 4);
        assert_eq!(searched(none, false, |_| true), (None, 0));
        assert_eq!(searched(5..=5, false, |count| count == 5).0, Some(5));
    }

    #[test]
    fn even_counts_may_serve_before_odd_ones() {
        let serves = |count: usize| count >= 207 || count >= 200 && count.is_multiple_of(2);
        assert_eq!(searched(100..=264, false, serves).0, Some(200));
    }

    #[test]
    fn uneven_counts_are_tried_one_by_one() {
        let serves = |count: usize| count == 77;
        assert_eq!(searched(1..=100, true, serves), (Some(77), 77));
        assert_eq!(searched(1..=100, false, serves).0, None);
    }

    #[test]
    fn of_very_many_a_part_is_left_open() {
        let (found, tries) = searched(300_000..=1_000_000, false, |count| count >= 555_555);
        let found = found.unwrap();
        assert!((555_555..555_555 + 150).contains(&found) && tries <= 16);
    }
}
