//! Circular arcs between two ends, from what gives them.

use kurbo::Point;

use super::{DotOffset, Exact, Inscribed, cross, differences, dot};
use crate::numeric::double::{Double, Twice};
use crate::shape::Given;

impl Exact {
    /// The length of the chord that the frame is about, in it; 0 where there is none.
    pub(crate) fn chord_size(&self) -> f64 {
        match self.level {
            DotOffset::Radius(_) => 0.0,
            DotOffset::Pencil { chord, .. } => dot(chord, chord).sqrt().value(),
        }
    }
}

impl Inscribed {
    /// How many times larger than the chord the coordinates of the ends are, and once more.
    pub(super) fn cancelled(&self) -> f64 {
        let [from, to] = self.ends;
        let sizes = [from.x, from.y, to.x, to.y].map(f64::abs);
        1.0 + sizes.into_iter().fold(0.0, f64::max) / (to - from).hypot()
    }
}

/// The cotangent of half the sweep of a circular arc between two ends, where what gives the arc says it by itself.
/// `read` takes the numbers that were given as they are, or as their decimals.
pub(in crate::shape) fn cotangent_between(
    ends: [Point; 2],
    given: Given,
    read: fn(f64) -> Double,
) -> Option<Double> {
    let point = |p: Point| [p.x, p.y].map(read);
    let [from, to] = ends.map(point);
    Some(match given {
        // tan(sweep/4) is the bulge b, and the cotangent of twice that angle (1 - b²) / (2b).
        Given::Bulge(b) => {
            let b = read(b);
            let square = b.times(b);
            Double::of(1.0).minus(square).divided(b.scaled(2.0))
        }
        // The inscribed angle is what half the sweep leaves of half a turn.
        Given::Through(on) => {
            let [cross, dot] = products_about(point(on), [from, to]);
            dot.divided(cross)
        }
        // How far the centre lies beside the chord, over half of its length.
        Given::Center(center) => {
            let (chord, arm) = (differences(to, from), differences(point(center), from));
            cross(chord, arm).scaled(2.0).divided(dot(chord, chord))
        }
        _ => return None,
    })
}

/// (from - on) × (to - on) and (from - on)·(to - on) to the last digit: they cancel for points near a line, and on a semicircle.
pub(in crate::shape) fn products_about(on: Twice, [from, to]: [Twice; 2]) -> [Double; 2] {
    let (u, v) = (differences(from, on), differences(to, on));
    [cross(u, v), dot(u, v)]
}

/// The centre and the radius of the circle through two ends by that cotangent, each rounded once.
pub(in crate::shape) fn circle_between([from, to]: [Point; 2], cotangent: Double) -> (Point, f64) {
    let half = [
        Double::difference(to.x, from.x),
        Double::difference(to.y, from.y),
    ]
    .map(|x| x.scaled(0.5));
    let beside = [half[1].scaled(-1.0), half[0]].map(|x| x.times(cotangent));
    let [x, y] = [0, 1].map(|i| half[i].plus(beside[i]));
    let center = Point::new(
        x.plus(Double::of(from.x)).value(),
        y.plus(Double::of(from.y)).value(),
    );
    // By a power of two, so that squares of no radius vanish.
    let size = x.value().abs().max(y.value().abs());
    let by = if size.is_normal() {
        libm::scalbn(1.0, -libm::ilogb(size))
    } else {
        1.0
    };
    let scaled = [x, y].map(|x| x.scaled(by));
    (center, dot(scaled, scaled).sqrt().value() / by)
}
