//! Drawings, computed and measured.

use core::f64::consts::PI;

use super::document::{DrawingEntry, ShapeChoice, Step};
use super::words::{words, words_ps};
use crate::approximate::{Drawing, Options, approximate, automatic_precision};
use crate::compare::{Criterion, square};
use crate::error::{Error, Result};
use crate::joints::Cut;
use crate::measure::radial::Profile;
use crate::measure::{Reference, report};
use crate::method::Rule;
use crate::number::{Precision, rounded_up};
use crate::picture::figure::describe;
use crate::radial_error::RadialError;
use crate::shape::{Outline, Shape, Truth};
use crate::write::json::{DrawingDocument, shape_document};

/// The distance is told at the ends and extremes of the Chebyshev polynomial of this degree, through which the page draws a polynomial.
const STEPS: u32 = 24;

/// In how many parts of the peak the distance is told.
const PARTS: f64 = 1000.0;

/// The part of the peak error that rounding may add, before the share that every drawing leaves to it: two decimals more than the
/// error needs keep its picture smooth.
const MAGNIFIED_SHARE: f64 = 0.01;

/// Shapes to be drawn alike.
pub(super) struct Choice<'a> {
    pub(super) id: &'static str,
    pub(super) title: String,
    pub(super) quantity: Option<&'static str>,
    pub(super) rules: &'a [Rule],
    pub(super) counts: Vec<usize>,
    pub(super) open: bool,
}

impl Choice<'_> {
    pub(super) fn draw(self, shapes: &[(f64, Shape)]) -> Result<ShapeChoice> {
        let step = |(value, shape): &(f64, Shape)| self.step(*value, shape);
        Ok(ShapeChoice {
            steps: shapes.iter().map(step).collect::<Result<_>>()?,
            id: self.id.to_owned(),
            title: self.title,
            quantity: self.quantity.map(str::to_owned),
            counts: self.counts,
        })
    }

    fn step(&self, value: f64, shape: &Shape) -> Result<Step> {
        let mut drawings = Vec::new();
        let mut joints = Vec::new();
        for &count in &self.counts {
            let mut angles = Vec::new();
            for &rule in self.rules {
                if let Some((entry, found)) = drawing(shape, rule, count, self.open)? {
                    drawings.push(entry);
                    angles = found;
                }
            }
            joints.push(angles);
        }
        Ok(Step {
            value,
            title: describe(shape),
            words: words(shape, self.open).unwrap_or_default(),
            words_ps: words_ps(shape, self.open).unwrap_or_default(),
            shape: shape_document(shape, kurbo::Affine::IDENTITY),
            closed: !self.open && shape.outline().is_some_and(|outline| outline.unit.closed),
            joints,
            drawings,
        })
    }
}

pub(super) fn options(rule: Rule, count: usize, precision: Option<Precision>) -> Options {
    Options {
        rule,
        cut: Cut::Count(count),
        precision,
        ..Options::default()
    }
}

/// A drawing with the angles of its joints; nothing where the rule cannot draw it.
fn drawing(
    shape: &Shape,
    rule: Rule,
    count: usize,
    open: bool,
) -> Result<Option<(DrawingEntry, Vec<f64>)>> {
    let full = match approximate(shape, &options(rule, count, Some(Precision::Full))) {
        Ok(full) => full,
        Err(Error::Impossible { .. }) => return Ok(None),
        Err(other) => return Err(other),
    };
    let Some(outline) = &full.outline else {
        return Ok(None);
    };
    let reference = Reference::from(outline);
    let share = MAGNIFIED_SHARE * full.error.peak();
    let precision = match automatic_precision(share, &full.curve.segments) {
        Precision::Fixed(decimals) => Some(decimals),
        Precision::Full => None,
    };
    let mut printed = approximate(
        shape,
        &options(rule, count, precision.map(Precision::Fixed)),
    )?;
    if open {
        printed.curve.closed = false;
    }
    let document = DrawingDocument::from(&printed);
    let figures = figures(&full, outline);
    let (profiles, profile_of) = profiles(&full, &outline.truth, figures[0]);
    let entry = DrawingEntry {
        method: rule.id().to_owned(),
        segments: count,
        precision,
        path: document.path,
        error: [document.error.outward, document.error.inward],
        corner: document.corner,
        quadrature: document.quadrature,
        figures,
        continuity: report(&full.curve, &reference, None)?.continuity.order,
        profiles,
        profile_of,
    };
    Ok(Some((entry, printed.angles)))
}

/// What methods are compared by, for a larger radius of 1.
fn figures(full: &Drawing, outline: &Outline) -> [f64; 6] {
    let radius = full.larger_radius();
    let figure = |by: Criterion| match by {
        Criterion::Area | Criterion::Length => by.of(&full.curve, outline),
        Criterion::Square => square(RadialError {
            outward: full.error.outward / radius,
            inward: full.error.inward / radius,
        }),
        Criterion::Peak | Criterion::Mean | Criterion::Rms => by.of(&full.curve, outline) / radius,
    };
    Criterion::ALL.map(|by| rounded_up(figure(by), 6))
}

/// The kinds of profiles, and which each segment has: one that is another run backwards is not told again, nor is the second half of one
/// that mirrors itself.
fn profiles(full: &Drawing, truth: &Truth, peak: f64) -> (Vec<Vec<i16>>, Vec<i16>) {
    let unit = (peak * full.larger_radius()).max(f64::MIN_POSITIVE);
    let mut kinds: Vec<Vec<i16>> = Vec::new();
    let mut kind_of = Vec::new();
    let angles = (0..=STEPS).map(|i| PI * f64::from(i) / f64::from(STEPS));
    let places: Vec<f64> = angles.map(|a| (1.0 - libm::cos(a)) / 2.0).collect();
    for segment in &full.curve.segments {
        let profile = Profile::new(segment, truth);
        let part = |&t: &f64| (profile.at(t) / unit * PARTS).round();
        let parts = places.iter().map(part);
        let own: Vec<i16> = parts.map(|d| d.clamp(-PARTS, PARTS) as i16).collect();
        let backwards: Vec<i16> = own.iter().rev().copied().collect();
        let position = |wanted: &[i16]| kinds.iter().position(|kind| near(kind, wanted));
        let kind = match (position(&own), position(&backwards)) {
            (Some(forwards), _) => numbered(forwards),
            (None, Some(backwards)) => -numbered(backwards),
            (None, None) => {
                kinds.push(own);
                numbered(kinds.len() - 1)
            }
        };
        kind_of.push(kind);
    }
    for kind in &mut kinds {
        let backwards: Vec<i16> = kind.iter().rev().copied().collect();
        if near(kind, &backwards) {
            kind.truncate(kind.len().div_ceil(2));
        }
    }
    if kind_of.iter().all(|&kind| kind == 1) {
        kind_of.clear();
    }
    (kinds, kind_of)
}

/// Whether two profiles differ by the rounding of their parts at most.
fn near(a: &[i16], b: &[i16]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() <= 1)
}

/// A place in a list, counted from 1. No page has room for more segments than that has numbers.
fn numbered(place: usize) -> i16 {
    i16::try_from(place + 1).unwrap_or(i16::MAX)
}
