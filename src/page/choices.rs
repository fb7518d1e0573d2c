//! What a page lets choose from: the shape that was asked for, ellipses and arcs, each with its methods and counts.

use kurbo::Vec2;

use super::document::{CriterionEntry, MethodEntry, PageDocument, ShapeChoice};
use super::drawings::{Choice, options};
use super::words::words;
use super::{LARGEST, Request, sources, too_large};
use crate::angle::Angle;
use crate::approximate::approximate;
use crate::compare::Criterion;
use crate::error::{Error, Result};
use crate::method::{Degree, Method, Rule};
use crate::number::{Precision, text};
use crate::picture::figure::describe;
use crate::shape::{Arc, Ellipse, Outline, Shape};

/// The ratios of the radii that the slider of ellipses runs over.
const RATIOS: [f64; 9] = [1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.3, 0.2, 0.1];

/// The angles of an arc in degrees that its slider runs over.
const ANGLES: [f64; 12] = [
    15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 135.0, 150.0, 165.0, 180.0,
];

/// What the slider of arcs sets.
const ARC_ANGLE: &str = "Angle of the arc in degrees";

/// The methods that sliders prefer, best known first: a page has no room for all at every stop.
const PREFERRED: [Method; 9] = [
    Method::Minimax,
    Method::MinimaxEllipse,
    Method::MinimaxEllipseFree,
    Method::Midpoint,
    Method::Curvature,
    Method::Apprich,
    Method::Chen3,
    Method::LancasterDrawellipse,
    Method::QuadraticMinimax,
];

/// How many methods a slider takes along.
const MOST_ON_SLIDERS: usize = 9;

impl PageDocument {
    /// Draws and measures everything that the page shows.
    ///
    /// # Errors
    ///
    /// Where the shape is a line or nothing, a count is none, or no method can draw the shape with any of the counts.
    pub fn new(request: &Request<'_>) -> Result<Self> {
        // An arc that was given by its ends is drawn from its centre, since that is what the page's commands say.
        let shape = match request.shape {
            Shape::Arc(arc) => Shape::Arc(Arc { ends: None, ..arc }),
            shape => shape,
        };
        let outline = shape.outline().ok_or_else(|| {
            Error::Shape(
                "there is nothing to look at: the shape is a straight line or nothing, and that is exact".to_owned(),
            )
        })?;
        let rules = distinct(request.rules);
        // A segment has six numbers: what is certainly too large need not be drawn first.
        let counts = request.counts.iter();
        let segments = counts.fold(0_usize, |sum, &count| sum.saturating_add(count));
        if segments.saturating_mul(rules.len()) > LARGEST / 12 {
            return Err(too_large());
        }
        let asked = asked(&shape, &outline, &rules, request)?;
        if asked.steps.iter().all(|step| step.drawings.is_empty()) {
            return Err(why_not(&shape, request));
        }
        let fewer = on_sliders(&rules);
        Ok(Self {
            version: 1,
            title: describe(&shape),
            command: command(&shape, &rules, request),
            by: request.by,
            methods: rules.iter().map(|rule| entry(*rule)).collect(),
            criteria: Criterion::ALL.map(criterion).into(),
            shapes: vec![
                asked,
                ellipses(&outline, rotation_of(&shape), &fewer)?,
                arcs(&outline, rotation_of(&shape), &fewer)?,
            ],
            sources: sources::tables()?,
        })
    }
}

/// The shape itself, or the arcs of one segment that were asked for instead.
fn asked(
    shape: &Shape,
    outline: &Outline,
    rules: &[Rule],
    request: &Request<'_>,
) -> Result<ShapeChoice> {
    if !request.spans.is_empty() {
        let degrees: Vec<f64> = request.spans.iter().map(|span| span.degrees()).collect();
        let choice = Choice {
            id: "asked",
            title: "Arcs of one segment".to_owned(),
            quantity: Some(ARC_ANGLE),
            rules,
            counts: vec![1],
            open: request.open,
        };
        return choice.draw(&arcs_of(outline, rotation_of(shape), &degrees)?);
    }
    Choice {
        id: "asked",
        title: describe(shape),
        quantity: None,
        rules,
        counts: request.counts.to_vec(),
        open: request.open,
    }
    .draw(&[(0.0, *shape)])
}

/// Ellipses about the same centre, with the same larger radius.
fn ellipses(outline: &Outline, rotation: Angle, rules: &[Rule]) -> Result<ShapeChoice> {
    let (center, larger) = (outline.truth.center, outline.truth.larger_radius());
    let ellipse = |&ratio: &f64| {
        let radii = Vec2::new(larger, larger * ratio);
        let ellipse = Ellipse::new(center, radii, rotation)?;
        Ok((ratio, Shape::Ellipse(ellipse)))
    };
    let ellipses: Vec<(f64, Shape)> = RATIOS.iter().map(ellipse).collect::<Result<_>>()?;
    Choice {
        id: "ellipse",
        title: "Ellipses".to_owned(),
        quantity: Some("Ratio of the radii"),
        rules,
        counts: vec![4, 8],
        open: false,
    }
    .draw(&ellipses)
}

/// Arcs of the same ellipse from the same point on.
fn arcs(outline: &Outline, rotation: Angle, rules: &[Rule]) -> Result<ShapeChoice> {
    Choice {
        id: "arc",
        title: "Arcs".to_owned(),
        quantity: Some(ARC_ANGLE),
        rules,
        counts: vec![1, 2],
        open: false,
    }
    .draw(&arcs_of(outline, rotation, &ANGLES)?)
}

fn arcs_of(outline: &Outline, rotation: Angle, degrees: &[f64]) -> Result<Vec<(f64, Shape)>> {
    let (truth, start) = (&outline.truth, outline.unit.start);
    let arc = |&angle: &f64| {
        let sweep = Angle::from_degrees(angle);
        let arc = Arc::new(truth.center, truth.radii, rotation, start, sweep)?;
        Ok((angle, arc.shape()))
    };
    degrees.iter().map(arc).collect()
}

fn criterion(by: Criterion) -> CriterionEntry {
    CriterionEntry {
        id: by,
        title: by.title().to_owned(),
        label: by.label().to_owned(),
    }
}

/// The rules without repetitions.
fn distinct(rules: &[Rule]) -> Vec<Rule> {
    let mut found: Vec<Rule> = Vec::new();
    for rule in rules {
        if !found.iter().any(|known| known.id() == rule.id()) {
            found.push(*rule);
        }
    }
    found
}

/// The rules that sliders take along.
fn on_sliders(rules: &[Rule]) -> Vec<Rule> {
    let rank = |rule: &Rule| {
        let place = PREFERRED
            .iter()
            .position(|&method| rule.method() == Some(method));
        place.unwrap_or(PREFERRED.len())
    };
    let mut sorted = rules.to_vec();
    sorted.sort_by_key(rank);
    sorted.truncate(MOST_ON_SLIDERS);
    sorted
}

const fn rotation_of(shape: &Shape) -> Angle {
    match shape {
        Shape::Ellipse(e) => e.rotation,
        Shape::Arc(a) => a.rotation,
        _ => Angle::ZERO,
    }
}

/// The refusal of the first drawing.
fn why_not(shape: &Shape, request: &Request<'_>) -> Error {
    let first = request.rules.first().zip(request.counts.first());
    let refusal = first.and_then(|(&rule, &count)| {
        let options = options(rule, count, Some(Precision::Full));
        approximate(shape, &options).err()
    });
    refusal.unwrap_or_else(|| Error::Shape("no method and no count was named".to_owned()))
}

fn entry(rule: Rule) -> MethodEntry {
    let card = rule.method().unwrap_or_default().card();
    MethodEntry {
        id: rule.id().to_owned(),
        words: if rule == Rule::Chen2Gauss2 {
            format!("-m {} --quadrature gauss2", rule.id())
        } else {
            format!("-m {}", rule.id())
        },
        title: card.title.to_owned(),
        degree: match card.degree {
            Degree::Quadratic => 2,
            Degree::Cubic => 3,
        },
        order: (card.order > 0).then_some(card.order),
        leading: card.leading.to_owned(),
        criterion: card.criterion.to_owned(),
        origin: card.origin.to_owned(),
        advice: card.advice.to_owned(),
    }
}

/// The command that makes the page.
fn command(shape: &Shape, rules: &[Rule], request: &Request<'_>) -> String {
    let explore = || format!("explore {}", words(shape, request.open).unwrap_or_default());
    let asked = request.words.clone().unwrap_or_else(explore);
    let ids: Vec<&str> = rules.iter().map(|rule| rule.id()).collect();
    let methods = if ids == Method::ALL.map(Method::id) {
        String::new()
    } else {
        format!(" -m {}", ids.join(","))
    };
    let columns = if request.spans.is_empty() {
        let counts: Vec<String> = request.counts.iter().map(usize::to_string).collect();
        format!("-n {}", counts.join(","))
    } else {
        let spans = request.spans.iter();
        let spans: Vec<String> = spans.map(|span| text(span.degrees())).collect();
        format!("--spans {}", spans.join(","))
    };
    format!("curveto {asked}{methods} {columns} -o page.html")
}
