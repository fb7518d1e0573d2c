//! The frame of an ellipse that is given as a conic.
//!
//! A conic of a weight w below 1 is the unit circle's arc from -h to h, cos h = w, under the map that takes its ends and (1/w, 0), where
//! its tangents meet, to the three points.

use kurbo::{Affine, Point};

use super::{DotOffset, Exact, Frame, Inverse, decimals, differences};
use crate::number::as_decimal;
use crate::numeric::double::{Double, Twice};

/// The columns of that map, and the centre.
fn columns(ends: [Point; 2], control: Point, weight: f64) -> [Twice; 3] {
    let ([from, to], arm, w) = (ends.map(decimals), decimals(control), as_decimal(weight));
    let one = Double::of(1.0);
    let apart = one.minus(w).times(one.plus(w));
    let middle = [0, 1].map(|i| from[i].plus(to[i]).scaled(0.5));
    let x = [0, 1].map(|i| {
        let arm = arm[i].plus(middle[i].scaled(-1.0));
        arm.times(w).divided(apart)
    });
    let y = differences(to, from).map(|d| d.scaled(0.5).divided(apart.sqrt()));
    let center = [0, 1].map(|i| middle[i].plus(x[i].times(w).scaled(-1.0)));
    [x, y, center]
}

/// That map, its numbers rounded once.
pub(crate) fn placement(ends: [Point; 2], control: Point, weight: f64) -> Affine {
    let [x, y, center] = columns(ends, control, weight);
    let [x, y, center] = [x, y, center].map(|v| v.map(Double::value));
    Affine::new([x[0], x[1], y[0], y[1], center[0], center[1]])
}

impl Frame {
    /// The frame of that conic, mapped.
    pub(super) fn conic(&self, ends: [Point; 2], control: Point, weight: f64) -> Exact {
        let [x, y, center] = columns(ends, control, weight);
        let [x, y, center] = match self.map {
            None => [x, y, center],
            Some(map) => {
                let [a, b, c, d, e, f] = map.as_coeffs();
                let turned =
                    |[x, y]: Twice| [(a, c), (b, d)].map(|(a, c)| x.scaled(a).plus(y.scaled(c)));
                let center = turned(center);
                let moved = [center[0].plus(Double::of(e)), center[1].plus(Double::of(f))];
                [turned(x), turned(y), moved]
            }
        };
        Exact {
            back: Some(Inverse::new([x[0], x[1], y[0], y[1], center[0], center[1]])),
            origin: [Double::of(0.0); 2],
            axis: None,
            radii: None,
            level: DotOffset::Radius(Double::of(-1.0)),
            unit: 1.0,
            grown: 1.0,
            unsure: 0.0,
            is_conic: true,
        }
    }
}
