//! The methods: how one piece of the unit circle's arc becomes control points.
//!
//! A method sees an angle and nothing else: no file, no rounding, and no ellipse but for the two `minimax-ellipse`. Each family stands in a file of its own,
//! its formula and source at the head; [`Method::card`] tells what is known of each, and that one table drives help,
//! error messages, documentation and tests.

mod apprich;
mod catalogue;
mod chen;
mod conic;
pub(crate) mod ellipse;
mod equioscillating;
pub mod figures;
mod integral;
mod lancaster;
mod minimax;
pub mod nodal;
mod piece;
mod quadratic;
mod rule;
mod span;
mod tangent;

pub use catalogue::{Card, Degree, Ends, Law};
pub use chen::{Iteration, Quadrature};
pub use piece::Piece;
pub(crate) use piece::in_frame;
pub use rule::Rule;
pub use span::Span;

use core::fmt;
use core::str::FromStr;

use crate::error::{Error, MethodError, Remedy, Result, RuleName};
use crate::numeric::functions::power;
use crate::radial_error::RadialError;

/// A method of the catalogue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
#[expect(
    missing_docs,
    reason = "the catalogue says what each one is: Method::card"
)]
pub enum Method {
    Midpoint,
    Minimax,
    Goldapp,
    Curvature,
    Apprich,
    ApprichPlus,
    Area,
    Length,
    Mean,
    MeanAngle,
    Rms,
    Chen1,
    Chen2,
    Chen3,
    LancasterBest,
    LancasterDrawellipse,
    MinimaxG0,
    MinimaxEllipse,
    MinimaxFree,
    MinimaxEllipseFree,
    ApprichScaled,
    CurvatureScaled,
    MinimaxG0Free,
    QuadraticTangent,
    QuadraticMidpoint,
    QuadraticArea,
    QuadraticMinimax,
    QuadraticMinimaxFree,
}

impl Default for Method {
    /// The least peak error of all that join smoothly with both ends on the circle.
    fn default() -> Self {
        Self::Minimax
    }
}

impl Method {
    /// The piece of the unit circle's arc of angle `span`. `minimax-ellipse` and its free variant see the ellipse too, and have their
    /// own pieces there, one for each place.
    ///
    /// # Errors
    ///
    /// [`Error::Impossible`] where the method has no such piece: the angle is beyond its largest, or not one of its table.
    pub fn piece(self, span: &Span) -> Result<Piece> {
        self.check_angle(span)?;
        let (span, part) = &span.in_range();
        let piece = match self {
            Self::Midpoint => Piece::tangent(tangent::midpoint(span)),
            Self::Minimax | Self::MinimaxEllipse => Piece::tangent(minimax::handle(span)),
            Self::Goldapp => Piece::tangent(tangent::goldapp(span)),
            Self::Curvature => Piece::tangent(tangent::curvature(span)),
            Self::Apprich => Piece::tangent(apprich::minus(span)),
            Self::ApprichPlus => Piece::tangent(apprich::plus(span)),
            Self::Area => Piece::tangent(integral::area(span)),
            Self::Length => Piece::tangent(integral::length(span)),
            Self::Mean => Piece::tangent(integral::mean(span)),
            Self::MeanAngle => Piece::tangent(integral::mean_angle(span)),
            Self::Rms => Piece::tangent(integral::rms(span)),
            Self::Chen1 => Piece::tangent(chen::formulation_1(span)),
            Self::Chen2 => Piece::tangent(chen::formulation_2(span, Iteration::default())),
            Self::Chen3 => Piece::tangent(chen::formulation_3(span)),
            Self::LancasterBest => Piece::tangent(lancaster::best(span)?),
            Self::LancasterDrawellipse => Piece::tangent(lancaster::DRAWELLIPSE),
            Self::MinimaxG0 => equioscillating::on_circle(span),
            Self::MinimaxG0Free => equioscillating::free(span),
            Self::MinimaxFree | Self::MinimaxEllipseFree => tangent::minimax_free(span),
            Self::ApprichScaled => apprich::scaled(span),
            Self::CurvatureScaled => tangent::curvature_scaled(span),
            Self::QuadraticTangent => quadratic::tangent(span),
            Self::QuadraticMidpoint => quadratic::midpoint(span),
            Self::QuadraticArea => quadratic::area(span),
            Self::QuadraticMinimax => quadratic::minimax(span),
            Self::QuadraticMinimaxFree => quadratic::minimax_free(span),
        };
        Ok(piece.shortened(*part))
    }

    /// The largest radial distances of the piece from the unit circle, outside and inside, both at least 0.
    ///
    /// These are the distances of the piece in exact arithmetic, right to at least nine digits at every angle, however small;
    /// control points in `f64` add a few 1e-16.
    ///
    /// # Errors
    ///
    /// As [`Method::piece`].
    pub fn radial_error(self, span: &Span) -> Result<RadialError> {
        self.check_angle(span)?;
        let (span, part) = &span.in_range();
        let error = match self {
            Self::Midpoint => tangent::family_error(span, 1.0),
            Self::Minimax | Self::MinimaxEllipse => minimax::error(span),
            Self::Goldapp => tangent::family_error(span, tangent::GOLDAPP_ZERO),
            Self::Curvature => tangent::family_error(span, 0.0),
            Self::Area => integral::area_error(span),
            Self::Length => tangent::family_error(span, integral::length_zero(span)),
            Self::Mean => tangent::family_error(span, integral::mean_zero(span)),
            Self::MeanAngle => tangent::family_error(span, integral::mean_angle_zero(span)),
            Self::Rms => tangent::family_error(span, integral::rms_zero(span)),
            Self::Apprich => apprich::minus_error(span),
            Self::ApprichScaled => apprich::scaled_error(span),
            Self::ApprichPlus | Self::LancasterBest | Self::LancasterDrawellipse => {
                tangent::error(span, self.piece(span)?.handle.y)
            }
            Self::Chen1 => chen::formulation_1_error(span),
            Self::Chen2 => chen::formulation_2_error(span, Iteration::default()),
            Self::Chen3 => chen::formulation_3_error(span),
            Self::CurvatureScaled => tangent::curvature_scaled_error(span),
            Self::MinimaxFree | Self::MinimaxEllipseFree => tangent::minimax_free_error(span),
            Self::MinimaxG0 => equioscillating::on_circle_error(span),
            Self::MinimaxG0Free => equioscillating::free_error(span),
            Self::QuadraticTangent => quadratic::tangent_error(span),
            Self::QuadraticMidpoint => quadratic::midpoint_error(span),
            Self::QuadraticArea => quadratic::area_error(span),
            Self::QuadraticMinimax => quadratic::minimax_error(span),
            Self::QuadraticMinimaxFree => quadratic::minimax_free_error(span),
        };
        let order = self.card().law.map_or(0, |law| law.order);
        Ok(error.times(power(*part, order.into())))
    }

    /// The handle of `minimax` and the peak of r² - 1, for angles up to half a turn: what the engine asks for, computed once.
    #[inline(always)]
    pub(crate) fn minimax_with_square(span: &Span) -> (f64, f64) {
        minimax::handle_with_square(span)
    }

    /// The id of the catalogue.
    #[must_use]
    pub fn id(self) -> &'static str {
        self.card().id
    }

    /// Refuses an angle that the method does not serve, and says what would do.
    fn check_angle(self, span: &Span) -> Result<()> {
        span.check()?;
        let card = self.card();
        let degrees = span.degrees();
        if self == Self::LancasterDrawellipse && !span.is_about(90.0) {
            return Err(self.refuse(
                MethodError::OnlyQuarters(degrees),
                Remedy::Segments(vec![4], &["midpoint", "minimax"]),
            ));
        }
        let largest = card.largest_angle;
        if span.exceeds(largest) {
            return Err(self.refuse(
                MethodError::Largest { degrees, largest },
                Remedy::MoreSegments {
                    degrees: Some(largest),
                    methods: self.beyond_its_angle(),
                },
            ));
        }
        if self == Self::LancasterBest {
            lancaster::best(span)?;
        }
        Ok(())
    }

    /// What serves the angles beyond the method's largest, where that is less than half a turn.
    const fn beyond_its_angle(self) -> &'static [&'static str] {
        match self {
            Self::Apprich | Self::ApprichPlus => &["curvature", "minimax"],
            Self::ApprichScaled => &["curvature-scaled", "minimax-free"],
            Self::Chen1 => &["chen-3", "minimax"],
            Self::QuadraticTangent => &["quadratic-minimax"],
            _ => &[],
        }
    }

    /// The error that says why this method cannot do something.
    pub(crate) fn refuse(self, why: MethodError, remedy: Remedy) -> Error {
        Error::Impossible {
            method: RuleName::Method(self.id()),
            why,
            remedy,
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}

impl FromStr for Method {
    type Err = Error;

    /// Finds a method by its id or one of its aliases.
    fn from_str(name: &str) -> Result<Self> {
        Self::ALL
            .into_iter()
            .find(|method| method.names().any(|n| n == name))
            .ok_or_else(|| Error::UnknownMethod {
                name: name.to_owned(),
                nearest: catalogue::nearest(name),
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::angle::Angle;
    use kurbo::{ParamCurve, Vec2};

    fn degrees_from_0(size: f64) -> [Vec2; 2] {
        [0.0, size].map(|degrees| Angle::from_degrees(degrees).direction())
    }

    /// r² - 1 = -u² (H + G u) where the two numbers are given, and they are given for the cubics that touch the circle.
    #[test]
    fn the_excess_of_cubics_that_touch_the_circle_is_theirs() {
        for method in Method::ALL {
            let span = Span::from_degrees(90.0);
            let piece = method.piece(&span).unwrap();
            let card = method.card();
            let is_g0 = card.continuity_uneven == crate::continuity::Continuity::G0;
            let touches = card.degree == Degree::Cubic && card.ends == Ends::OnCircle && !is_g0;
            assert_eq!(piece.is_tangent_cubic(), touches, "{method}");
            assert_eq!(piece.excess(&span).is_some(), touches, "{method}");
            let Some([h, g]) = piece.excess(&span) else {
                continue;
            };
            let curve = piece.between(degrees_from_0(90.0));
            for t in [0.1, 0.3, 0.5] {
                let u = t * (1.0 - t);
                let excess = curve.eval(t).to_vec2().hypot2() - 1.0;
                assert!((excess + u * u * (h + g * u)).abs() < 1e-15, "{method}");
            }
        }
    }

    #[test]
    fn the_ends_of_a_piece_lie_at_their_radius() {
        for method in Method::ALL {
            let piece = method.piece(&Span::from_degrees(90.0)).unwrap();
            let curve = piece.between(degrees_from_0(90.0));
            for t in [0.0, 1.0] {
                let radius = curve.eval(t).to_vec2().hypot();
                assert!((radius - piece.end_radius).abs() < 1e-15, "{method}");
            }
        }
    }

    #[test]
    fn what_is_offered_beyond_the_largest_angle_serves_it() {
        for method in Method::ALL {
            let largest = method.card().largest_angle;
            let beyond = Span::from_degrees(largest + 1.0);
            let error = method.piece(&beyond).unwrap_err();
            let Error::Impossible { remedy, .. } = error else {
                panic!("{method}: {error}");
            };
            let Remedy::MoreSegments { degrees, methods } = remedy else {
                assert_eq!(method, Method::LancasterDrawellipse);
                continue;
            };
            assert_eq!(degrees, Some(largest), "{method}");
            assert_eq!(methods.is_empty(), largest >= 180.0, "{method}");
            for other in methods {
                let other: Method = other.parse().unwrap();
                assert!(
                    other.piece(&Span::from_degrees(180.0)).is_ok(),
                    "{method}: {other}"
                );
            }
        }
    }
}
