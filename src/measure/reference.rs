//! What a curve is measured against.

use core::iter;

use kurbo::{Affine, PathSeg, Point, Vec2};

use crate::curve::control_points;
use crate::numeric::bernstein::Polynomial;
use crate::numeric::functions::angle_of;
use crate::shape::{Outline, Truth};

/// A circle or an ellipse, and the part of it that the curve stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reference {
    /// The circle or ellipse.
    pub truth: Truth,
    /// The map from the unit circle that gives points their angles; [`Truth::placement`] unless the shape was transformed.
    pub placement: Affine,
    /// The angle in degrees at which the true arc starts and how far it runs; `None` takes both from the curve.
    pub arc: Option<(f64, f64)>,
}

impl From<Truth> for Reference {
    fn from(truth: Truth) -> Self {
        Self {
            truth,
            placement: truth.placement(),
            arc: None,
        }
    }
}

impl From<&Outline> for Reference {
    fn from(outline: &Outline) -> Self {
        Self {
            truth: outline.truth,
            placement: outline.placement,
            arc: Some((outline.unit.start.degrees(), outline.unit.sweep.degrees())),
        }
    }
}

impl Reference {
    /// The reference with all lengths multiplied by a power of two, which is exact.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self {
            truth: self.truth.scaled(factor),
            placement: Affine::new(self.placement.as_coeffs().map(|c| c * factor)),
            arc: self.arc,
        }
    }

    /// 1 where growing angles turn from +x towards +y in user space, else -1.
    pub(crate) fn handedness(&self) -> f64 {
        1.0_f64.copysign(self.placement.determinant())
    }

    /// A segment seen from the frame in which the true shape is the unit circle.
    pub(crate) fn framed(&self, segment: &PathSeg) -> Framed {
        let [a, b, c, d, _, _] = self.placement.as_coeffs();
        let inverse = Affine::new([a, b, c, d, 0.0, 0.0]).inverse();
        let points: Vec<Point> = control_points(segment)
            .into_iter()
            .map(|p| inverse * (p - self.truth.center).to_point())
            .collect();
        let axis =
            |of: fn(&Point) -> f64| Polynomial::new(&points.iter().map(of).collect::<Vec<f64>>());
        Framed {
            x: axis(|p| p.x),
            y: axis(|p| p.y),
        }
    }
}

/// How many steps a segment's turn about the centre is followed in; less than half a turn may lie in each.
const STEPS: u32 = 16;

/// A segment in the frame in which the true shape is the unit circle; its angles are the shape's parametric angles.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Framed {
    x: Polynomial,
    y: Polynomial,
}

impl Framed {
    fn at(&self, t: f64) -> Vec2 {
        Vec2::new(self.x.at(t), self.y.at(t))
    }

    /// The angle of the first point, in radians between -π and π.
    pub(crate) fn first_angle(&self) -> f64 {
        angle_of(self.outset())
    }

    /// Whether the first point is the centre.
    pub(crate) fn starts_in_center(&self) -> bool {
        self.at(0.0) == Vec2::ZERO
    }

    /// The first point, or where the curve leads from the centre: the first derivative that is not 0.
    fn outset(&self) -> Vec2 {
        let derivative = |of: &Self| Self {
            x: of.x.derivative(),
            y: of.y.derivative(),
        };
        iter::successors(Some(*self), |of| Some(derivative(of)))
            .take(4)
            .map(|of| of.at(0.0))
            .find(|v| *v != Vec2::ZERO)
            .unwrap_or_default()
    }

    /// How far the curve has turned about the centre at t, in radians; whole turns count. The centre itself has no angle of its own.
    pub(crate) fn turned(&self, t: f64) -> f64 {
        let mut before = self.outset();
        (1..=STEPS)
            .map(|step| self.at(t * f64::from(step) / f64::from(STEPS)))
            .filter(|here| *here != Vec2::ZERO)
            .map(|here| {
                let turn = libm::atan2(before.cross(here), before.dot(here));
                before = here;
                turn
            })
            .sum()
    }

    /// |dθ/dt|, in radians; 0 in the centre itself.
    pub(crate) fn angular_speed(&self, t: f64) -> f64 {
        let p = self.at(t);
        let speed = Vec2::new(self.x.derivative().at(t), self.y.derivative().at(t));
        let square = p.hypot2();
        if square > 0.0 {
            (p.cross(speed) / square).abs()
        } else {
            0.0
        }
    }

    /// How far the angle at t is ahead of one that grows linearly from end to end, in radians.
    pub(crate) fn lag(&self, t: f64) -> f64 {
        self.turned(t) - t * self.turned(1.0)
    }

    /// Where [`Framed::lag`] has its extremes: x y' - y x' = Δ (x² + y²), Δ the whole turn.
    pub(crate) fn lag_extremes(&self) -> impl Iterator<Item = f64> {
        let areal = (self.x.times(&self.y.derivative())).minus(&self.y.times(&self.x.derivative()));
        let square = (self.x.times(&self.x)).minus(&self.y.times(&self.y).scaled(-1.0));
        let found = areal.minus(&square.scaled(self.turned(1.0))).sign_changes();
        found.iter().collect::<Vec<f64>>().into_iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angle_turns_by_the_part_of_the_speed_across() {
        let circle = Reference::from(Truth::circle(Point::ORIGIN, 1.0));
        let line = |from: (f64, f64), to: (f64, f64)| {
            let line = kurbo::Line::new(from, to);
            circle.framed(&PathSeg::Line(line))
        };
        // Two units in the time of one, at the distance 2 and at the distance √5.
        let across = line((2.0, 0.0), (2.0, 2.0));
        assert_eq!(across.angular_speed(0.0), 1.0);
        assert_eq!(across.angular_speed(0.5), 0.8);
        // Through the centre there is no angle there, and it stays the same elsewhere.
        let through = line((-1.0, 0.0), (1.0, 0.0));
        assert_eq!(
            [0.0, 0.25, 0.5, 1.0].map(|t| through.angular_speed(t)),
            [0.0; 4]
        );
    }
}
