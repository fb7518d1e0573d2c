//! The frame in which a true shape is the unit circle, in twice the digits of `f64`: what was given is taken as exact, by its decimals, and
//! what was computed from it, as centres, sweeps and the images of a map, is computed anew.

mod conic;
mod inscribed;
mod inverse;

pub(crate) use conic::placement as conic_placement;

use kurbo::{Affine, Point, Vec2};

use super::Given;
use crate::angle::Angle;
use crate::number::as_decimal;
use crate::numeric::double::{Double, Twice, cross};
pub(super) use inscribed::{circle_between, cotangent_between, products_about};
use inverse::Inverse;

/// The sweep in degrees up to which a sweep and a chord tell more than the centre: towards a whole turn the chord shrinks to nothing.
const WIDEST: f64 = 270.0;

/// How far 1 - h², h half the chord over the radii, is off at most, times the largest coordinate of the ends over the chord. What is no larger is what
/// rounding leaves of half a turn: decimals of fewer than 15 digits come no nearer to one.
const HALF_TURN: f64 = f64::EPSILON * f64::EPSILON * 16.0;

/// What was given of a true shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    center: Point,
    radii: Vec2,
    /// How many times the radii are as large in truth: those of an arc may be too small for its chord.
    enlarged: f64,
    axis: FirstRadius,
    arc: Option<Inscribed>,
    /// What was applied after that.
    map: Option<Affine>,
}

/// The direction of the first radius.
#[derive(Debug, Clone, Copy, PartialEq)]
enum FirstRadius {
    Vector(Vec2),
    Angle(Angle),
}

/// An arc between two ends.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Inscribed {
    ends: [Point; 2],
    sweep: Angle,
    given: Given,
}

impl Frame {
    /// An ellipse by its centre, radii and the direction of the first.
    #[inline(always)]
    pub(super) const fn new(center: Point, radii: Vec2, axis: Vec2) -> Self {
        Self {
            center,
            radii,
            enlarged: 1.0,
            axis: FirstRadius::Vector(axis),
            arc: None,
            map: None,
        }
    }

    /// The same with the angle of the first radius.
    pub(super) const fn turned(self, rotation: Angle) -> Self {
        Self {
            axis: FirstRadius::Angle(rotation),
            ..self
        }
    }

    /// The same ellipse by an arc of it.
    pub(super) fn through(self, ends: [Point; 2], sweep: Angle, given: Given) -> Self {
        let arc = Inscribed { ends, sweep, given };
        let (radii, enlarged) = match given {
            Given::Enlarged(radii) => (radii, self.radii.x / radii.x),
            _ => (self.radii, self.enlarged),
        };
        Self {
            radii,
            enlarged,
            arc: Some(arc),
            ..self
        }
    }

    /// The image under a further map.
    pub(super) fn mapped(self, map: Affine) -> Self {
        Self {
            map: Some(self.map.map_or(map, |own| map * own)),
            ..self
        }
    }

    /// The same with all lengths multiplied by a power of two, which is exact.
    pub(super) fn scaled(self, factor: f64) -> Self {
        if let Some(map) = self.map {
            return Self {
                map: Some(Affine::new(map.as_coeffs().map(|c| c * factor))),
                ..self
            };
        }
        let point = |p: Point| (p.to_vec2() * factor).to_point();
        Self {
            center: point(self.center),
            radii: self.radii * factor,
            arc: self.arc.map(|arc| Inscribed {
                ends: arc.ends.map(point),
                given: match arc.given {
                    Given::Through(on) => Given::Through(point(on)),
                    Given::Center(center) => Given::Center(point(center)),
                    Given::Conic { control, weight } => Given::Conic {
                        control: point(control),
                        weight,
                    },
                    given => given,
                },
                ..arc
            }),
            ..self
        }
    }

    /// The frame, ready for points of the plane, where the shape has become one of these radii.
    pub(crate) fn exact(&self, radii: Vec2) -> Exact {
        if let Some(Inscribed { ends, given, .. }) = self.arc
            && let Given::Conic { control, weight } = given
        {
            return self.conic(ends, control, weight);
        }
        let axis = match self.axis {
            FirstRadius::Vector(v) => [v.x, v.y].map(Double::of),
            FirstRadius::Angle(angle) => Angle::direction_of(as_decimal(angle.degrees())),
        };
        let is_circle = radii.x == radii.y;
        let own_radii = (!is_circle || self.map.is_some())
            .then(|| [self.radii.x, self.radii.y].map(as_decimal));
        let mut exact = Exact {
            back: self
                .map
                .map(|map| Inverse::new(map.as_coeffs().map(Double::of))),
            origin: decimals(self.center),
            axis: (axis != [1.0, 0.0].map(Double::of)).then_some(axis),
            radii: own_radii,
            level: DotOffset::Radius(Double::of(-1.0)),
            unit: 1.0,
            grown: 1.0,
            unsure: 0.0,
            is_conic: false,
        };
        if own_radii.is_some() {
            let unit = if is_circle { radii.x } else { 1.0 } / self.enlarged;
            exact.unit = unit * unit;
        } else {
            let radius = as_decimal(self.radii.x);
            exact.level = DotOffset::Radius(radius.times(radius).scaled(-1.0));
        }
        if let Some(arc) = self.arc {
            self.inscribe(&arc, &mut exact);
        }
        if !exact.is_about_center() {
            let own = own_radii.map_or(self.radii.x, |_| 1.0);
            exact.grown = exact.radius().value() / (own * self.enlarged);
            if !is_circle {
                exact.unit /= exact.grown * exact.grown;
            }
        }
        exact
    }

    /// Takes the frame about the start of an arc, where its chord tells more than the centre does.
    fn inscribe(&self, arc: &Inscribed, exact: &mut Exact) {
        let [from, to] = arc.ends.map(decimals);
        if from == to {
            // A whole circle from a point of it, whose radius is computed.
            if self.radii.x == self.radii.y {
                let arm = exact.unmapped(differences(from, exact.origin));
                exact.level = DotOffset::Radius(dot(arm, arm).scaled(-1.0));
            }
            return;
        }
        let chord = exact.unmapped(differences(to, from));
        if let Some((cotangent, unsure)) = self.cotangent(arc, chord, exact.radii.is_none()) {
            exact.origin = from;
            exact.level = DotOffset::Pencil { chord, cotangent };
            exact.unsure = unsure;
        }
    }

    /// The cotangent of half the sweep, and how far the centre may be off by it, as a part of the radii: next to half a turn digits cancel. `None`
    /// where the centre tells more.
    fn cotangent(&self, arc: &Inscribed, chord: Twice, is_plain: bool) -> Option<(Double, f64)> {
        let sweep = arc.sweep.degrees();
        let cotangent = match arc.given {
            Given::Sweep => {
                if sweep.abs() > WIDEST {
                    return None;
                }
                let [cos, sin] = Angle::direction_of(as_decimal(sweep).scaled(0.5));
                cos.divided(sin)
            }
            Given::Conic { .. } => return None,
            Given::Enlarged(_) => Double::of(0.0),
            Given::Bulge(_) | Given::Through(_) | Given::Center(_) => {
                cotangent_between(arc.ends, arc.given, as_decimal)?
            }
            Given::Radii { large } => {
                let mut square = dot(chord, chord).scaled(0.25);
                if is_plain {
                    let radius = as_decimal(self.radii.x);
                    square = square.divided(radius).divided(radius);
                }
                let rest = Double::of(1.0).plus(square.scaled(-1.0));
                let off = HALF_TURN * arc.cancelled();
                if rest.value() <= off {
                    return Some((Double::of(0.0), 0.0));
                }
                let size = rest.divided(square).sqrt();
                let unsure = if rest.value() < 0.25 {
                    off / size.value()
                } else {
                    0.0
                };
                let sign = if large == (sweep > 0.0) { -1.0 } else { 1.0 };
                return Some((size.scaled(sign), unsure));
            }
        };
        Some((cotangent, 0.0))
    }
}

/// A point as its decimals tell it.
#[inline(always)]
pub(crate) fn decimals(p: Point) -> Twice {
    [as_decimal(p.x), as_decimal(p.y)]
}

/// a - b.
#[inline(always)]
fn differences(a: Twice, b: Twice) -> Twice {
    [a[0].minus(b[0]), a[1].minus(b[1])]
}

#[inline(always)]
fn dot(u: Twice, v: Twice) -> Double {
    u[0].times(v[0]).plus(u[1].times(v[1]))
}

/// What is added to the dot product of two points q of the frame to make it |q|² - 1 about the centre, or |q|² - r² of a circle.
#[derive(Clone, Copy)]
enum DotOffset {
    /// Minus the square of the radius.
    Radius(Double),
    /// From an end A of an arc to the other, B, and κ, the cotangent of half the sweep: the circles through both are the pencil
    /// q·(q - B) + κ q×B = 0, and the left side is |q|² - 1 about the centre of each. Nothing of it grows with the radius.
    Pencil { chord: Twice, cotangent: Double },
}

/// The frame with what is needed for points: its unit is the user's for a circle, else it makes both radii 1.
#[derive(Clone, Copy)]
pub(crate) struct Exact {
    back: Option<Inverse>,
    /// The centre, or where an arc starts, before the map.
    origin: Twice,
    axis: Option<Twice>,
    radii: Option<Twice>,
    level: DotOffset,
    /// What the excess in this frame is multiplied by to be that of the shape that the map made.
    pub(crate) unit: f64,
    /// How many times the radii that were computed are as large by the decimals of the ends.
    pub(crate) grown: f64,
    /// How far the centre may be off, as a part of the larger radius.
    pub(crate) unsure: f64,
    /// Whether it is that of a conic: nothing but the radii, which are rounded, says that this is a circle.
    pub(crate) is_conic: bool,
}

impl Exact {
    /// A point of the plane in the frame.
    #[inline(always)]
    pub(crate) fn point(&self, p: Twice) -> Twice {
        let own = self.back.as_ref().map_or(p, |back| back.point(p));
        self.unmapped(differences(own, self.origin))
    }

    /// The same for a vector before the map.
    #[inline(always)]
    fn unmapped(&self, v: Twice) -> Twice {
        let [x, y] = match self.axis {
            Some(axis) => [dot(axis, v), cross(axis, v)],
            None => v,
        };
        match self.radii {
            Some(radii) => [x.by(radii[0]), y.by(radii[1])],
            None => [x, y],
        }
    }

    /// What is added to a dot product at a point of the frame.
    #[inline(always)]
    pub(crate) fn level(&self, q: Twice) -> Double {
        match self.level {
            DotOffset::Radius(level) => level,
            DotOffset::Pencil { chord, cotangent } => {
                let across = cross(q, chord).times(cotangent);
                across.plus(dot(q, chord).scaled(-1.0))
            }
        }
    }

    /// The centre in the frame.
    #[inline(always)]
    pub(crate) fn center(&self) -> Twice {
        match self.level {
            DotOffset::Radius(_) => [Double::of(0.0); 2],
            DotOffset::Pencil { chord, cotangent } => {
                let half = chord.map(|c| c.scaled(0.5));
                [
                    half[0].plus(half[1].times(cotangent).scaled(-1.0)),
                    half[1].plus(half[0].times(cotangent)),
                ]
            }
        }
    }

    /// The radius of the circle that the shape is in the frame.
    pub(crate) fn radius(&self) -> Double {
        match self.level {
            DotOffset::Radius(level) => level.scaled(-1.0).sqrt(),
            DotOffset::Pencil { .. } => {
                let center = self.center();
                dot(center, center).sqrt()
            }
        }
    }

    /// Whether the shape is an image under a map.
    pub(crate) const fn is_mapped(&self) -> bool {
        self.back.is_some()
    }

    /// Whether the centre is the origin of the frame.
    pub(crate) const fn is_about_center(&self) -> bool {
        matches!(self.level, DotOffset::Radius(_))
    }

    /// How far a point lies from the image of another in the centre, where the frame is about that and without a map.
    #[inline]
    pub(crate) fn off_image_in_center(&self, p: Twice, q: Twice) -> Vec2 {
        let [a, b] = [p, q].map(|point| differences(point, self.origin));
        Vec2::new(a[0].plus(b[0]).value(), a[1].plus(b[1]).value())
    }

    /// A vector of the frame in the plane, along the axes that the shape has without a map.
    pub(crate) fn image(&self, q: Vec2) -> Vec2 {
        let v = self
            .radii
            .map_or(q, |[a, b]| Vec2::new(q.x * a.value(), q.y * b.value()));
        let Some(back) = &self.back else {
            return v;
        };
        let v = self.axis.map_or(v, |[cos, sin]| {
            v.rotate_scale(Vec2::new(cos.value(), sin.value()))
        });
        let [first, second] = back.forth.map(|[x, y]| Vec2::new(x.value(), y.value()));
        first * v.x + second * v.y
    }

    /// The product of the radii of an ellipse.
    pub(crate) fn area(&self) -> f64 {
        let [a, b] = self.columns();
        cross(a, b).value().abs() / self.unit
    }

    /// What the unit vectors of the frame are there.
    pub(crate) fn columns(&self) -> [Twice; 2] {
        let [nothing, one] = [0.0, 1.0].map(Double::of);
        let [a, b] = self.radii.unwrap_or([one; 2]);
        let Some(back) = &self.back else {
            return [[a, nothing], [nothing, b]];
        };
        let [cos, sin] = self.axis.unwrap_or([one, nothing]);
        [
            [cos.times(a), sin.times(a)],
            [sin.times(b).scaled(-1.0), cos.times(b)],
        ]
        .map(|[x, y]| {
            let [first, second] = back.forth;
            [0, 1].map(|i| first[i].times(x).plus(second[i].times(y)))
        })
    }
}
