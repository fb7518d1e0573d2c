//! Drawings, computed and measured.

use core::f64::consts::PI;

use super::document::{DrawingEntry, PageStep, ShapeChoice};
use super::words::{words, words_ps};
use crate::approximate::{Drawing, Options, approximate, automatic_precision};
use crate::compare::{Criterion, square};
use crate::error::{Error, Result};
use crate::joints::Cut;
use crate::measure::radial::Profile;
use crate::measure::{Reference, report};
use crate::method::Rule;
use crate::number::{Precision, rounded_up};
use crate::picture::words::describe;
use crate::radial_error::RadialError;
use crate::shape::{Outline, Shape, Truth};
use crate::write::json::{DrawingDocument, shape_document};

/// The distance is given at the ends and extremes of the Chebyshev polynomial of this degree, through which the page draws a polynomial.
const STEPS: u32 = 24;

/// In how many parts of the peak the distance is given.
const PARTS: f64 = 1000.0;

/// The part of the peak error that rounding may add, before the share that every drawing leaves to it: two decimals more than the
/// error needs keep its picture smooth.
const MAGNIFIED_SHARE: f64 = 0.01;

/// The drawings of a row of shapes by one method with one count; nothing where a shape cannot be drawn so.
pub(super) type DrawingColumn = Vec<Option<(DrawingEntry, Vec<f64>)>>;

/// A shape or a row of shapes, on which drawings are put one method and count after the other.
pub(super) struct ShapeRow {
    choice: ShapeChoice,
    shapes: Vec<Shape>,
    open: bool,
}

impl ShapeRow {
    /// Shapes without drawings, each with the value of its stop.
    pub(super) fn new(
        (id, title): (&str, String),
        quantity: Option<&str>,
        shapes: &[(f64, Shape)],
        counts: &[usize],
        open: bool,
    ) -> Self {
        let step = |(value, shape): &(f64, Shape)| PageStep {
            value: *value,
            title: describe(shape),
            words: words(shape, open).unwrap_or_default(),
            words_ps: words_ps(shape, open).unwrap_or_default(),
            shape: shape_document(shape, kurbo::Affine::IDENTITY),
            closed: !open && shape.outline().is_some_and(|outline| outline.unit.closed),
            joints: vec![Vec::new(); counts.len()],
            drawings: Vec::new(),
        };
        Self {
            choice: ShapeChoice {
                id: id.to_owned(),
                title,
                quantity: quantity.map(str::to_owned),
                counts: counts.to_vec(),
                steps: shapes.iter().map(step).collect(),
            },
            shapes: shapes.iter().map(|(_, shape)| *shape).collect(),
            open,
        }
    }

    /// Draws every shape by this rule with so many segments.
    pub(super) fn column(&self, rule: Rule, count: usize) -> Result<DrawingColumn> {
        let shapes = self.shapes.iter();
        shapes
            .map(|shape| drawing(shape, rule, count, self.open))
            .collect()
    }

    /// Puts the drawings with so many segments on the shapes.
    pub(super) fn take(&mut self, count: usize, column: DrawingColumn) {
        let place = self.choice.counts.iter().position(|&known| known == count);
        for (step, drawn) in self.choice.steps.iter_mut().zip(column) {
            if let Some((entry, angles)) = drawn {
                if let Some(joints) = place.and_then(|place| step.joints.get_mut(place)) {
                    *joints = angles;
                }
                step.drawings.push(entry);
            }
        }
    }

    /// What there is to choose from.
    pub(super) const fn choice(&self) -> &ShapeChoice {
        &self.choice
    }

    /// The same, without the counts that nothing was drawn with.
    pub(super) fn finish(mut self) -> ShapeChoice {
        let Self { choice, .. } = &mut self;
        let steps = &choice.steps;
        let used = |&count: &usize| {
            let mut drawings = steps.iter().flat_map(|step| &step.drawings);
            drawings.any(|drawing| drawing.segments == count)
        };
        let kept: Vec<bool> = choice.counts.iter().map(used).collect();
        for step in &mut choice.steps {
            step.joints = chosen(&step.joints, &kept);
        }
        choice.counts = chosen(&choice.counts, &kept);
        self.choice
    }
}

/// The entries that are kept.
fn chosen<T: Clone>(list: &[T], kept: &[bool]) -> Vec<T> {
    let pairs = list.iter().zip(kept);
    pairs
        .filter(|(_, kept)| **kept)
        .map(|(entry, _)| entry.clone())
        .collect()
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

/// The kinds of profiles, and which each segment has: one that is another run backwards is not stored again, nor is the second half of one
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
