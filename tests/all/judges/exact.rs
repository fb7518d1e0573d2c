//! True shapes in the oracle's numbers.

use curveto::shape::endpoint::SvgArc;

use super::oracle::ellipse::signed_distance;
use super::oracle::real::{norm, ratio};
use super::oracle::{Point, Real, decimal, int, radians};

/// An ellipse: centre, radii and the cosine and sine of its rotation.
pub(crate) struct Exact {
    pub(crate) center: Point,
    pub(crate) radii: Point,
    pub(crate) axis: Point,
}

/// The point as its decimals tell it.
pub(crate) fn decimal_point(p: kurbo::Point) -> Point {
    [decimal(p.x), decimal(p.y)]
}

pub(crate) fn direction(degrees: f64) -> Point {
    let (sine, cosine) = radians(&decimal(degrees)).sin_cos();
    [cosine, sine]
}

impl Exact {
    /// SVG 2, appendix B.2.4.
    pub(crate) fn of_svg_arc(arc: &SvgArc) -> Self {
        let [c, s] = direction(arc.rotation.degrees());
        let [a, b] = [decimal_point(arc.from), decimal_point(arc.to)];
        let half = [0, 1].map(|i| (&a[i] - &b[i]) * ratio(1, 2));
        let (mut rx, mut ry) = (decimal(arc.radii.x.abs()), decimal(arc.radii.y.abs()));
        let x = &c * &half[0] + &s * &half[1];
        let y = &c * &half[1] - &s * &half[0];
        let lambda = (&x / &rx) * (&x / &rx) + (&y / &ry) * (&y / &ry);
        let mut depth = int(0);
        if lambda > int(1) {
            (rx, ry) = (&rx * lambda.sqrt(), &ry * lambda.sqrt());
        } else {
            depth = ((int(1) - &lambda) / &lambda).sqrt();
        }
        if arc.large_arc == arc.sweep {
            depth = -depth;
        }
        let own = [&depth * (&rx * &y / &ry), -(&depth * (&ry * &x / &rx))];
        Self {
            center: [
                &c * &own[0] - &s * &own[1] + (&a[0] + &b[0]) * ratio(1, 2),
                &s * &own[0] + &c * &own[1] + (&a[1] + &b[1]) * ratio(1, 2),
            ],
            radii: [rx, ry],
            axis: [c, s],
        }
    }

    /// The signed distance of a point, positive outside.
    pub(crate) fn distance(&self, p: &Point) -> Real {
        let (x, y) = (&p[0] - &self.center[0], &p[1] - &self.center[1]);
        let [c, s] = &self.axis;
        let own = [c * &x + s * &y, c * &y - s * &x];
        if self.radii[0] == self.radii[1] {
            return norm(&own) - &self.radii[0];
        }
        signed_distance(&own, &self.radii)
    }
}
