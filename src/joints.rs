//! Where the sweep is cut.

pub(crate) mod adaptive;
pub(crate) mod cutting;

use core::str::FromStr;

use kurbo::Vec2;

use crate::angle::Angle;
use crate::error::{Error, JointsError, MethodError, Remedy, Result, finite};
use crate::method::{Rule, Span};
use crate::shape::UnitArc;

use cutting::{Cutting, EqualPieces};

/// The largest number of segments that anything is cut into.
pub const MOST_SEGMENTS: usize = 1_000_000;

/// The most segments that all subpaths of a path become, unless it has as many before.
pub const MOST_IN_ALL: usize = 5 * MOST_SEGMENTS;

/// Refuses a count of 0 or beyond [`MOST_SEGMENTS`].
pub(crate) const fn check_count(count: usize) -> Result<()> {
    let most = MOST_SEGMENTS;
    if count == 0 || count > most {
        return Err(Error::Count { count, most });
    }
    Ok(())
}

/// How much of a quarter turn may exceed the quarters before it needs a segment of its own: float noise and the near-quarter
/// arcs that drawing programs write do not add one.
const QUARTER_SLACK: f64 = 0.05;

/// How to cut.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub enum Cut {
    /// One segment for every quarter turn, an excess of up to 5 % of a quarter not counted.
    #[default]
    Quarters,
    /// This many segments of equal parametric angle.
    Count(usize),
    /// This many segments whose joints equalise the error: on an ellipse they crowd where it is curved least, on a circle, and for
    /// methods that need equal pieces, they lie at equal angles.
    Adaptive(usize),
    /// The fewest segments within this distance of the true shape: at equal angles on a circle, adaptive on an ellipse.
    Tolerance(Tolerance),
    /// Joints at these angles: all of a closed shape's, the inner ones of an arc.
    At(Vec<Angle>),
}

/// A largest distance from the true shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// In user units.
    Absolute(f64),
    /// As a part of the larger radius: 0.0001 for 0.01 %.
    Relative(f64),
}

impl Tolerance {
    /// The distance in user units for a shape of this larger radius, where it is one that can be met.
    ///
    /// # Errors
    ///
    /// Where it is not positive and finite, or beyond 1e150.
    pub fn checked(self, radius: f64) -> Result<f64> {
        let (what, value) = ("tolerance", self.for_radius(radius));
        if value > 0.0 && value.is_finite() {
            return finite(what, value);
        }
        Err(Error::NotPositive { what, value })
    }

    /// The distance in user units for a shape of this larger radius.
    #[must_use]
    pub fn for_radius(self, radius: f64) -> f64 {
        match self {
            Self::Absolute(distance) => distance,
            Self::Relative(part) => part * radius,
        }
    }
}

impl FromStr for Tolerance {
    type Err = Error;

    /// Reads a positive distance in user units, or a percentage of the larger radius like `0.01%`.
    fn from_str(text: &str) -> Result<Self> {
        let wrong = || {
            Error::Syntax {
            what: "the tolerance",
            text: text.to_owned(),
            column: 1,
            why: "a tolerance is a positive, finite distance in user units, or a percentage of the larger radius like 0.01%".to_owned(),
        }
        };
        let (number, percent) = match text.trim().strip_suffix('%') {
            Some(number) => (number, true),
            None => (text, false),
        };
        let number: f64 = number.trim().parse().map_err(|_| wrong())?;
        // A hundredth of the least numbers is 0.
        let size = if percent { number / 100.0 } else { number };
        if !(size.is_finite() && size > 0.0) {
            return Err(wrong());
        }
        Ok(if percent {
            Self::Relative(size)
        } else {
            Self::Absolute(size)
        })
    }
}

/// The joints of a piece of the unit circle, both its ends included.
#[derive(Debug, Clone, PartialEq)]
pub struct Joints {
    /// The angle of each joint in degrees, one more than there are segments.
    pub angles: Vec<f64>,
    /// The point of the unit circle at each joint; the last of a closed shape is the first.
    pub directions: Vec<Vec2>,
    /// The angle of each segment.
    pub spans: Vec<Span>,
    /// Whether the last joint is the first.
    pub closed: bool,
    /// 1 where angles grow along the segments, else -1.
    pub sign: f64,
}

/// One segment for every quarter turn, an excess of up to 5 % of a quarter not counted.
#[must_use]
pub fn quarters(sweep: Angle) -> usize {
    let quarters = (sweep.degrees().abs() - 90.0 * QUARTER_SLACK) / 90.0;
    (quarters.ceil() as usize).max(1)
}

/// Extremes nearer to one another or to an end than this, in degrees, are one joint.
const NEAREST: f64 = 1e-6;

impl Joints {
    /// Joints at equal angles.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] where the count is 0 or beyond [`MOST_SEGMENTS`].
    pub fn equal(arc: &UnitArc, count: usize) -> Result<Self> {
        let equal = EqualPieces::new(*arc, count)?;
        let joints = 0..=count;
        let span = Span::from_degrees(equal.size(0));
        Ok(Self {
            angles: joints.clone().map(|i| equal.angle(i)).collect(),
            directions: joints.map(|i| equal.direction(i)).collect(),
            spans: vec![span; count],
            closed: arc.closed,
            sign: equal.sign(),
        })
    }

    /// Joints at these angles: all of a closed shape's, of which the first is where it starts; the inner ones of an arc.
    ///
    /// # Errors
    ///
    /// Where a joint is no finite number, two coincide, or one does not lie inside the arc's sweep.
    pub fn at(arc: &UnitArc, joints: &[Angle]) -> Result<Self> {
        for joint in joints {
            finite("angle of a joint", joint.degrees())?;
        }
        let sign = 1.0_f64.copysign(arc.sweep.degrees());
        let first = if arc.closed {
            joints
                .first()
                .copied()
                .ok_or(Error::Joints(JointsError::None))?
        } else {
            arc.start
        };
        let size = arc.sweep.degrees().abs();
        let mut ways = vec![0.0, size];
        for joint in joints.iter().skip(usize::from(arc.closed)) {
            let way = (sign * (joint.degrees() - first.degrees())).rem_euclid(360.0);
            if !arc.closed && (way >= size || way == 0.0) {
                return Err(Error::Joints(JointsError::Outside {
                    joint: joint.degrees(),
                    start: first.degrees(),
                    end: first.degrees() + arc.sweep.degrees(),
                }));
            }
            ways.push(way);
        }
        check_count(ways.len() - 1)?;
        ways.sort_by(f64::total_cmp);
        if let Some(pair) = ways.windows(2).find(|pair| pair[1] - pair[0] < 1e-9) {
            let at = first.degrees() + sign * pair[0];
            return Err(Error::Joints(JointsError::Twice(at)));
        }
        let from = UnitArc {
            start: first,
            ..*arc
        };
        Ok(Self::after(&from, &ways))
    }

    /// How far from the start these extremes and the ends of an arc lie, ascending, in degrees along the sweep: where the pieces
    /// between them meet. A closed shape begins and ends at the first extreme from its start on.
    pub(crate) fn pieces(arc: &UnitArc, extremes: &[Angle]) -> Vec<f64> {
        let sign = 1.0_f64.copysign(arc.sweep.degrees());
        let size = arc.sweep.degrees().abs();
        let mut ways: Vec<f64> = extremes
            .iter()
            .map(|angle| (sign * (angle.degrees() - arc.start.degrees())).rem_euclid(360.0))
            // An extreme that lies before the start by rounding alone is the start.
            .map(|way| if 360.0 - way < NEAREST { 0.0 } else { way })
            .filter(|&way| arc.closed || (NEAREST..size - NEAREST).contains(&way))
            .collect();
        if !arc.closed {
            ways.extend([0.0, size]);
        }
        ways.sort_by(f64::total_cmp);
        ways.dedup_by(|way, before| *way - *before < NEAREST);
        if let (true, Some(&first)) = (arc.closed, ways.first()) {
            ways.push(first + 360.0);
        }
        ways
    }

    /// The angles of the joints where pieces meet and where each is cut into so many parts. They are what [`Joints::at`] takes.
    pub(crate) fn of_pieces(arc: &UnitArc, pieces: &[f64], parts: &[usize]) -> Vec<Angle> {
        let sign = 1.0_f64.copysign(arc.sweep.degrees());
        let inside = |(pair, &parts): (&[f64], &usize)| {
            let (from, to) = (pair[0], pair[1]);
            (0..parts).map(move |i| from + (to - from) * (i as f64 / parts as f64))
        };
        let ways = pieces.windows(2).zip(parts).flat_map(inside);
        ways.skip(usize::from(!arc.closed))
            .map(|way| Angle::from_degrees(arc.start.degrees() + sign * way))
            .collect()
    }

    /// Refuses given joints that lie farther apart than the rule serves, in degrees, and says which would do.
    pub(crate) fn check_distances(&self, rule: Rule, largest: f64) -> Result<()> {
        let Some(span) = self.spans.iter().find(|span| span.exceeds(largest)) else {
            return Ok(());
        };
        let pairs = self.angles.windows(2).zip(&self.spans);
        let with_more = pairs.flat_map(|(pair, span)| {
            let parts = (span.degrees() / largest - 1e-9).ceil().max(1.0);
            let at = move |i: u32| pair[0] + (pair[1] - pair[0]) * (f64::from(i) / parts);
            (0..parts as u32).map(at)
        });
        // An arc's own start is none of the joints that are given.
        let with_more = with_more.skip(usize::from(!self.closed));
        Err(Error::Impossible {
            method: rule.name(),
            why: MethodError::Largest {
                degrees: span.degrees(),
                largest,
            },
            remedy: Remedy::Joints(with_more.collect()),
        })
    }

    /// The same with the inner joints moved by a part of the segments before them.
    pub(crate) fn nudged(&self, arc: &UnitArc, part: f64) -> Self {
        let mut ways: Vec<f64> = self
            .angles
            .iter()
            .map(|a| (a - self.angles[0]).abs())
            .collect();
        let inner = ways[1..].iter_mut().zip(&self.spans);
        for (way, before) in inner.take(self.count() - 1) {
            *way += part * before.degrees();
        }
        Self::after(arc, &ways)
    }

    /// Joints this many degrees after the start, ascending, both ends included.
    pub(crate) fn after(arc: &UnitArc, ways: &[f64]) -> Self {
        let sign = 1.0_f64.copysign(arc.sweep.degrees());
        let angles: Vec<f64> = ways
            .iter()
            .map(|way| arc.start.degrees() + sign * way)
            .collect();
        let mut directions: Vec<Vec2> = angles
            .iter()
            .map(|&degrees| Angle::from_degrees(degrees).direction())
            .collect();
        if arc.closed {
            let last = directions.len() - 1;
            directions[last] = directions[0];
        }
        let spans = ways
            .windows(2)
            .map(|pair| Span::from_degrees(pair[1] - pair[0]))
            .collect();
        Self {
            angles,
            directions,
            spans,
            closed: arc.closed,
            sign,
        }
    }

    /// The number of segments.
    #[must_use]
    pub fn count(&self) -> usize {
        self.spans.len()
    }
}

impl Cutting for Joints {
    fn count(&self) -> usize {
        self.spans.len()
    }

    fn angle(&self, joint: usize) -> f64 {
        self.angles[joint]
    }

    fn direction(&self, joint: usize) -> Vec2 {
        self.directions[joint]
    }

    fn size(&self, piece: usize) -> f64 {
        self.spans[piece].degrees()
    }

    fn sign(&self) -> f64 {
        self.sign
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_end_where_the_arc_does() {
        let degrees = Angle::from_degrees;
        for sign in [1.0, -1.0] {
            let arc = UnitArc {
                start: degrees(20.0),
                sweep: degrees(sign * 90.0),
                closed: false,
            };
            // Beside an end there is none.
            let ways = [
                -5e-7,
                0.0,
                5e-7,
                40.0,
                40.0 + 5e-7,
                90.0 - 5e-7,
                90.0,
                90.0 + 5e-7,
                200.0,
            ];
            let extremes = ways.map(|way| degrees(20.0 + sign * way));
            let pieces = Joints::pieces(&arc, &extremes);
            assert_eq!([pieces[0], pieces[2]], [0.0, 90.0], "{pieces:?}");
            assert!(pieces.len() == 3 && (pieces[1] - 40.0).abs() < 1e-12);
        }
        let closed = UnitArc {
            start: degrees(20.0),
            sweep: degrees(360.0),
            closed: true,
        };
        let pieces = Joints::pieces(&closed, &[0.0, 90.0, 180.0].map(degrees));
        assert_eq!(pieces, [70.0, 160.0, 340.0, 430.0]);
    }

    #[test]
    fn joints_that_a_hint_asks_for_are_as_far_apart_as_may_be() {
        let arc = UnitArc {
            start: Angle::ZERO,
            sweep: Angle::from_degrees(360.0),
            closed: true,
        };
        let joints = Joints::at(&arc, &[0.0, 180.0].map(Angle::from_degrees)).unwrap();
        let refused = joints.check_distances(Rule::default(), 90.0);
        let Err(Error::Impossible { remedy, .. }) = refused else {
            panic!("{refused:?}");
        };
        assert_eq!(remedy, Remedy::Joints(vec![0.0, 90.0, 180.0, 270.0]));
    }
}
