//! What gives the control points of a whole chain of pieces, and what it refuses.

use crate::error::{Error, MethodError, Remedy, Result, RuleName, ShapeError};
use crate::radial_error::RadialError;

use super::{Degree, Ends, Iteration, Method, Piece, Quadrature, Span, chen, ellipse, tangent};

/// What gives the control points: a method of the catalogue or a number of the user's own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rule {
    /// A method of the catalogue.
    Method(Method),
    /// Chen's Formulation II with its lengths found in this way.
    Chen2(Iteration),
    /// A literal handle length on the unit circle, for every segment: from -1e9 to 1e9.
    Handle(f64),
}

impl Default for Rule {
    fn default() -> Self {
        Self::Method(Method::default())
    }
}

impl From<Method> for Rule {
    fn from(method: Method) -> Self {
        Self::Method(method)
    }
}

/// Far more than any curve could use; the measure stays finite below it.
const LARGEST_HANDLE: f64 = 1e9;

impl Rule {
    /// Formulation II with arc length from Chen's two-point Gauss quadrature.
    pub const CHEN_2_GAUSS_2: Self = Self::Chen2(Iteration {
        quadrature: Quadrature::Gauss2,
        stop: 0.0,
    });

    /// How Formulation II finds its lengths, where this is that.
    #[must_use]
    pub fn iteration(self) -> Option<Iteration> {
        match self {
            Self::Chen2(iteration) => Some(iteration),
            Self::Method(Method::Chen2) => Some(Iteration::default()),
            _ => None,
        }
    }

    /// The largest angle of a piece among others of other angles, in degrees, where it serves such, on an ellipse of this ratio of
    /// the smaller to the larger radius.
    pub(crate) fn largest_uneven_angle(self, short: f64) -> Option<f64> {
        let Some(method) = self.method() else {
            return Some(180.0);
        };
        let card = method.card();
        match method {
            Method::LancasterBest | Method::LancasterDrawellipse => None,
            Method::Chen1 => Some(180.0),
            Method::MinimaxEllipse if short < 1.0 => {
                Some(ellipse::largest_angle(short).unwrap_or(card.largest_angle))
            }
            _ => (card.ends == Ends::OnCircle).then_some(card.largest_angle),
        }
    }

    /// Whether it gives quadratics.
    #[must_use]
    pub fn is_quadratic(self) -> bool {
        self.method()
            .is_some_and(|method| method.card().degree == Degree::Quadratic)
    }

    /// The name that output states: the method's id, or `handle`.
    #[must_use]
    pub fn id(self) -> &'static str {
        self.method().map_or("handle", Method::id)
    }

    /// What messages call it.
    pub(crate) fn name(self) -> RuleName {
        self.method()
            .map_or(RuleName::Handle, |method| RuleName::Method(method.id()))
    }

    /// The literal handle.
    pub(crate) const fn handle(self) -> Option<f64> {
        match self {
            Self::Handle(k) => Some(k),
            _ => None,
        }
    }

    /// The method of the catalogue that it is, if any.
    #[must_use]
    pub const fn method(self) -> Option<Method> {
        match self {
            Self::Method(method) => Some(method),
            Self::Chen2(_) => Some(Method::Chen2),
            Self::Handle(_) => None,
        }
    }

    /// The piece of the unit circle's arc of angle `span`; see [`Method::piece`].
    ///
    /// # Errors
    ///
    /// As [`Method::piece`], and [`Error::Shape`] for a literal handle that is no number or beyond 1e9.
    pub fn piece(self, span: &Span) -> Result<Piece> {
        match self {
            Self::Method(method) => method.piece(span),
            Self::Chen2(iteration) => Method::Chen2
                .check_angle(span)
                .map(|()| Piece::tangent(chen::formulation_2(span, iteration))),
            Self::Handle(k) => self.check_literal(span).map(|()| Piece::tangent(k)),
        }
    }

    /// The largest radial distances of the piece from the unit circle; see [`Method::radial_error`].
    ///
    /// # Errors
    ///
    /// As [`Rule::piece`].
    pub fn radial_error(self, span: &Span) -> Result<RadialError> {
        match self {
            Self::Method(method) => method.radial_error(span),
            Self::Chen2(iteration) => Method::Chen2
                .check_angle(span)
                .map(|()| chen::formulation_2_error(span, iteration)),
            Self::Handle(k) => self.check_literal(span).map(|()| tangent::error(span, k)),
        }
    }

    /// Refuses a literal handle that is no number, or far longer than any curve could use.
    ///
    /// # Errors
    ///
    /// [`Error::Shape`].
    pub fn check(self) -> Result<()> {
        match self {
            Self::Handle(handle) if handle.is_nan() || handle.abs() > LARGEST_HANDLE => {
                let most = LARGEST_HANDLE;
                Err(Error::Shape(ShapeError::Handle { handle, most }))
            }
            _ => Ok(()),
        }
    }

    /// What a literal handle does not serve.
    fn check_literal(self, span: &Span) -> Result<()> {
        self.check()?;
        check_half_turn(span)
    }

    /// The pieces of a chain of arcs of these angles.
    ///
    /// Every rule but Formulation I takes each piece on its own. That one solves for all nodal derivatives at once, so that
    /// the two ends of a piece can differ: each piece comes as (the piece seen from its start, the piece seen from its end).
    ///
    /// # Errors
    ///
    /// As [`Rule::piece`], and [`Error::Impossible`] where the ends leave the circle and the angles differ or the chain is open.
    pub fn pieces(self, spans: &[Span], closed: bool) -> Result<Vec<[Piece; 2]>> {
        // Ends off the circle ask for equal angles, but for the rounding of joints that were computed.
        let is_free = self
            .method()
            .is_some_and(|method| method.card().ends == Ends::OffCircle);
        let equal = spans.windows(2).all(|pair| {
            let first = pair[0].degrees();
            pair[1].degrees() == first || (is_free && pair[1].is_about(first))
        });
        if let Some(method) = self.method() {
            method.check_chain(spans, equal, closed)?;
            if method == Method::Chen1 && !(closed && equal) {
                // Unequal arcs have no angle of their own at which the system fails.
                spans.iter().try_for_each(|span| {
                    if equal {
                        method.check_angle(span)
                    } else {
                        check_half_turn_of_chen_1(span)
                    }
                })?;
                return Ok(chen::chain(spans, closed));
            }
        }
        if equal && let Some(first) = spans.first() {
            let piece = self
                .piece(first)
                .map_err(|error| beyond_half_turn(error, spans))?;
            return Ok(vec![[piece, piece]; spans.len()]);
        }
        spans
            .iter()
            .map(|span| self.piece(span).map(|piece| [piece, piece]))
            .collect::<Result<_>>()
            .map_err(|error| beyond_half_turn(error, spans))
    }
}

impl Method {
    /// Refuses what the method cannot do with a whole chain of pieces.
    fn check_chain(self, spans: &[Span], equal: bool, closed: bool) -> Result<()> {
        let free = self.card().ends == Ends::OffCircle;
        if free && !(closed && equal) {
            let why = if closed {
                MethodError::UnevenOffCircle
            } else {
                MethodError::OpenOffCircle
            };
            let remedy = Remedy::OnCircle(self.on_circle_instead(spans));
            return Err(beyond_half_turn(self.refuse(why, remedy), spans));
        }
        if self == Self::Chen1 && closed && spans.len() < 3 {
            return Err(self.refuse(
                MethodError::CyclicPoints(spans.len()),
                Remedy::ThreeSegments(&["chen-3", "minimax"]),
            ));
        }
        Ok(())
    }

    /// The methods that do the same, or nearly, with their ends on the circle, at these angles.
    fn on_circle_instead(self, spans: &[Span]) -> Vec<&'static str> {
        let candidates: &[Self] = match self {
            Self::ApprichScaled => &[Self::Apprich, Self::Curvature, Self::Minimax],
            Self::CurvatureScaled => &[Self::Curvature, Self::Minimax],
            Self::MinimaxEllipseFree => &[Self::MinimaxEllipse, Self::Minimax],
            Self::MinimaxG0Free => &[Self::MinimaxG0, Self::Minimax],
            Self::QuadraticMinimaxFree => &[Self::QuadraticMinimax, Self::QuadraticTangent],
            _ => &[Self::Minimax, Self::Midpoint],
        };
        // More than half a turn is served by none.
        let asked = |span: &&Span| !span.exceeds(180.0);
        let serves = |method: &&Self| {
            let largest = method.card().largest_angle;
            !spans.iter().filter(asked).any(|span| span.exceeds(largest))
        };
        candidates.iter().filter(serves).map(|m| m.id()).collect()
    }
}

/// The refusal of pieces of which one is more than half a turn: no other method alone serves it.
fn beyond_half_turn(error: Error, spans: &[Span]) -> Error {
    match error {
        Error::Impossible {
            method,
            why,
            remedy,
        } if spans.iter().any(|span| span.exceeds(180.0)) => Error::Impossible {
            method,
            why,
            remedy: match remedy {
                Remedy::Segments(_, methods) => Remedy::NearerJointsBy(methods.to_vec()),
                Remedy::OnCircle(methods) => Remedy::NearerJointsBy(methods),
                other => other,
            },
        },
        other => other,
    }
}

/// More than half a turn is no arc any more.
fn check_half_turn_of_chen_1(span: &Span) -> Result<()> {
    span.check()?;
    if !span.exceeds(180.0) {
        return Ok(());
    }
    Err(Method::Chen1.refuse(MethodError::HalfTurn(span.degrees()), Remedy::NearerJoints))
}

/// A literal handle serves up to half a turn: beyond, one cubic is no arc any more.
fn check_half_turn(span: &Span) -> Result<()> {
    span.check()?;
    if !span.exceeds(180.0) {
        return Ok(());
    }
    Err(Error::Impossible {
        method: RuleName::Handle,
        why: MethodError::HalfTurn(span.degrees()),
        remedy: Remedy::MoreSegments {
            degrees: Some(180.0),
            methods: &[],
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spans<const N: usize>(degrees: [f64; N]) -> [Span; N] {
        degrees.map(Span::from_degrees)
    }

    fn refusal(rule: Rule, spans: &[Span], closed: bool) -> (String, Remedy) {
        match rule.pieces(spans, closed) {
            Err(Error::Impossible { why, remedy, .. }) => (why.to_string(), remedy),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn ends_off_the_circle_have_their_kin_on_it() {
        for (method, kin) in [
            (
                Method::ApprichScaled,
                &["apprich", "curvature", "minimax"][..],
            ),
            (Method::CurvatureScaled, &["curvature", "minimax"]),
            (Method::MinimaxEllipseFree, &["minimax-ellipse", "minimax"]),
            (Method::MinimaxG0Free, &["minimax-g0", "minimax"]),
            (
                Method::QuadraticMinimaxFree,
                &["quadratic-minimax", "quadratic-tangent"],
            ),
            (Method::MinimaxFree, &["minimax", "midpoint"]),
        ] {
            for (spans, closed) in [
                (spans([90.0; 4]), false),
                (spans([80.0, 100.0, 90.0, 90.0]), true),
            ] {
                let (_, remedy) = refusal(method.into(), &spans, closed);
                assert_eq!(remedy, Remedy::OnCircle(kin.to_vec()), "{method}");
            }
        }
        // Of these only what serves such angles.
        let (_, remedy) = refusal(Method::QuadraticMinimaxFree.into(), &spans([178.0]), false);
        assert_eq!(remedy, Remedy::OnCircle(vec!["quadratic-minimax"]));
    }

    #[test]
    fn a_cyclic_system_needs_three_points() {
        for (spans, points) in [
            (&spans([360.0])[..], "one point"),
            (&spans([180.0; 2]), "two points"),
        ] {
            let (why, remedy) = refusal(Method::Chen1.into(), spans, true);
            assert!(why.contains(points), "{why}");
            assert!(matches!(remedy, Remedy::ThreeSegments(_)));
        }
        assert!(
            Rule::from(Method::Chen1)
                .pieces(&spans([120.0; 3]), true)
                .is_ok()
        );
    }

    #[test]
    fn more_than_half_a_turn_is_no_segment() {
        for rule in [Rule::Handle(0.5), Method::Chen1.into()] {
            assert!(
                rule.pieces(&spans([100.0, 180.0]), false).is_ok(),
                "{rule:?}"
            );
            let (why, _) = refusal(rule, &spans([100.0, 181.0]), false);
            assert!(
                why.contains("181 degrees is more than half a turn"),
                "{why}"
            );
        }
    }

    #[test]
    fn an_angle_that_is_no_number_is_refused() {
        let methods = Method::ALL.into_iter().map(Rule::Method);
        for rule in methods.chain([Rule::CHEN_2_GAUSS_2, Rule::Handle(0.5)]) {
            for degrees in [f64::NAN, f64::INFINITY] {
                let span = Span::from_degrees(degrees);
                let refused = |error| matches!(error, Some(Error::NotFinite { .. }));
                assert!(refused(rule.radial_error(&span).err()), "{rule:?}");
                assert!(refused(rule.piece(&span).err()), "{rule:?}");
                assert!(rule.pieces(&spans([90.0, degrees]), false).is_err());
            }
        }
    }

    #[test]
    fn the_largest_angle_is_that_of_the_ellipse() {
        let largest = |method: Method, short| Rule::from(method).largest_uneven_angle(short);
        assert_eq!(largest(Method::MinimaxEllipse, 1.0), Some(180.0));
        assert_eq!(largest(Method::MinimaxEllipse, 0.5), Some(170.0));
        assert_eq!(largest(Method::MinimaxEllipse, 0.03), Some(100.0));
        assert_eq!(largest(Method::QuadraticTangent, 0.5), Some(175.0));
        assert_eq!(largest(Method::MinimaxFree, 1.0), None);
        assert!(Rule::from(Method::QuadraticArea).is_quadratic());
        assert!(!Rule::from(Method::Area).is_quadratic());
    }
}
