//! What a page lets choose from: the shape that was asked for, ellipses and arcs, each with its methods and counts.

use kurbo::{Point, Vec2};
use serde::Serialize;

use super::document::{CriterionEntry, MethodEntry, PageDocument, ShapeChoice};
use super::drawings::{ShapeRow, options};
use super::words::words;
use super::{LARGEST, PageRequest, filled, sources, too_large};
use crate::angle::Angle;
use crate::approximate::approximate;
use crate::compare::Criterion;
use crate::error::{Error, PictureError, Result};
use crate::method::{Degree, Method, Rule};
use crate::number::{Precision, text};
use crate::picture::words::describe;
use crate::shape::{Arc, Ellipse, Outline, Shape};
use crate::write::json;

/// The ratios of the radii that the slider of ellipses runs over.
const RATIOS: [f64; 9] = [1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.3, 0.2, 0.1];

/// The angles of an arc in degrees that its slider runs over.
const ANGLES: [f64; 12] = [
    15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 135.0, 150.0, 165.0, 180.0,
];

/// What the slider of arcs sets.
const ARC_ANGLE: &str = "Angle of the arc in degrees";

/// The methods that sliders prefer, best known first: a page has no room for all with every count at every stop.
const PREFERRED: [Method; 14] = [
    Method::Minimax,
    Method::MinimaxEllipse,
    Method::MinimaxEllipseFree,
    Method::Midpoint,
    Method::Curvature,
    Method::Apprich,
    Method::Chen3,
    Method::LancasterDrawellipse,
    Method::QuadraticMinimax,
    Method::MinimaxG0,
    Method::LancasterBest,
    Method::Chen1,
    Method::Chen2,
    Method::Area,
];

/// The counts that the sliders over ellipses and over arcs prefer.
const PREFERRED_COUNTS: [[usize; 2]; 2] = [[4, 8], [1, 2]];

impl PageDocument {
    /// Draws and measures everything that the page shows.
    ///
    /// # Errors
    ///
    /// Where the shape is a line or nothing, a count is none, or no method can draw the shape with any of the counts.
    pub fn new(request: &PageRequest<'_>) -> Result<Self> {
        // An arc that was given by its ends is drawn from its centre, since that is what the page's commands say.
        let shape = match request.shape {
            Shape::Arc(arc) => Shape::Arc(Arc { ends: None, ..arc }),
            shape => shape,
        };
        let outline = shape.outline().ok_or(Error::Picture(PictureError::Exact))?;
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
        let mut page = Self {
            version: 1,
            title: describe(&shape),
            command: command(&shape, &rules, request),
            by: request.by,
            methods: rules.iter().map(|rule| entry(*rule)).collect(),
            criteria: Criterion::ALL.map(criterion).into(),
            shapes: vec![asked],
            sources: sources::tables()?,
        };
        let room = LARGEST.saturating_sub(filled(&page)?.len());
        let drawn = sliders(&outline, &rules, request.counts, room)?;
        page.shapes.extend(drawn);
        Ok(page)
    }
}

/// The shape itself, or the arcs of one segment that were asked for instead.
fn asked(
    shape: &Shape,
    outline: &Outline,
    rules: &[Rule],
    request: &PageRequest<'_>,
) -> Result<ShapeChoice> {
    let mut row = if request.spans.is_empty() {
        let name = ("asked", describe(shape));
        ShapeRow::new(name, None, &[(0.0, *shape)], request.counts, request.open)
    } else {
        let degrees: Vec<f64> = request.spans.iter().map(|span| span.degrees()).collect();
        let arcs = arcs_of(outline, &degrees)?;
        let name = ("asked", "Arcs of one segment".to_owned());
        ShapeRow::new(name, Some(ARC_ANGLE), &arcs, &[1], request.open)
    };
    for count in row.choice().counts.clone() {
        for &rule in rules {
            let column = row.column(rule, count)?;
            row.take(count, column);
        }
    }
    Ok(row.finish())
}

/// Ellipses with the same larger radius, and arcs of the same radii from the same angle on, by as many methods and counts as there is
/// room for, in bytes. They lie about the origin and are not rotated, since no distance depends on that.
fn sliders(
    outline: &Outline,
    rules: &[Rule],
    counts: &[usize],
    room: usize,
) -> Result<Vec<ShapeChoice>> {
    let counts = PREFERRED_COUNTS.map(|preferred| {
        let mut all: Vec<usize> = preferred.iter().chain(counts).copied().collect();
        all.sort_unstable();
        all.dedup();
        all
    });
    let [on_ellipses, on_arcs] = &counts;
    let ellipses = ShapeRow::new(
        ("ellipse", "Ellipses".to_owned()),
        Some("Ratio of the radii"),
        &ellipses(outline.truth.larger_radius())?,
        on_ellipses,
        false,
    );
    let arcs = ShapeRow::new(
        ("arc", "Arcs".to_owned()),
        Some(ARC_ANGLE),
        &arcs_of(outline, &ANGLES)?,
        on_arcs,
        false,
    );
    let mut rows = [ellipses, arcs];
    let taken: usize = rows
        .iter()
        .map(|row| size(row.choice()))
        .sum::<Result<_>>()?;
    fill(&mut rows, rules, &counts, room.saturating_sub(taken))?;
    let drawn = |choice: &ShapeChoice| choice.steps.iter().any(|step| !step.drawings.is_empty());
    Ok(rows
        .map(ShapeRow::finish)
        .into_iter()
        .filter(drawn)
        .collect())
}

/// Puts drawings on the rows until the room is filled: the preferred methods with the preferred counts, all others with these, then
/// the other counts in the same order.
fn fill(
    rows: &mut [ShapeRow; 2],
    rules: &[Rule],
    counts: &[Vec<usize>; 2],
    mut room: usize,
) -> Result<()> {
    let is_preferred = |rule: &Rule| PREFERRED.iter().position(|&m| rule.method() == Some(m));
    let mut preferred: Vec<Rule> = rules
        .iter()
        .copied()
        .filter(|rule| is_preferred(rule).is_some())
        .collect();
    preferred.sort_by_key(is_preferred);
    let others: Vec<Rule> = rules
        .iter()
        .copied()
        .filter(|rule| is_preferred(rule).is_none())
        .collect();
    for counted_first in [true, false] {
        for rule in preferred.iter().chain(&others) {
            for (row, (all, first)) in rows.iter_mut().zip(counts.iter().zip(PREFERRED_COUNTS)) {
                for &count in all
                    .iter()
                    .filter(|count| first.contains(count) == counted_first)
                {
                    let column = row.column(*rule, count)?;
                    let size = column.iter().flatten().map(size).sum::<Result<usize>>()?;
                    if size > room {
                        return Ok(());
                    }
                    room -= size;
                    row.take(count, column);
                }
            }
        }
    }
    Ok(())
}

/// The bytes that a part of the page takes.
fn size(part: &impl Serialize) -> Result<usize> {
    Ok(json::to_line(part)?.len() + 1)
}

/// The ellipses of the slider.
fn ellipses(larger: f64) -> Result<Vec<(f64, Shape)>> {
    let ellipse = |&ratio: &f64| {
        let radii = Vec2::new(larger, larger * ratio);
        let ellipse = Ellipse::new(Point::ORIGIN, radii, Angle::ZERO)?;
        Ok((ratio, Shape::Ellipse(ellipse)))
    };
    RATIOS.iter().map(ellipse).collect()
}

fn arcs_of(outline: &Outline, degrees: &[f64]) -> Result<Vec<(f64, Shape)>> {
    let (radii, start) = (outline.truth.radii, outline.unit.start);
    let arc = |&angle: &f64| {
        let sweep = Angle::from_degrees(angle);
        let arc = Arc::new(Point::ORIGIN, radii, Angle::ZERO, start, sweep)?;
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

/// The refusal of the first drawing.
fn why_not(shape: &Shape, request: &PageRequest<'_>) -> Error {
    let first = request.rules.first().zip(request.counts.first());
    let refusal = first.and_then(|(&rule, &count)| {
        let options = options(rule, count, Some(Precision::Full));
        approximate(shape, &options).err()
    });
    refusal.unwrap_or(Error::Picture(PictureError::Nothing))
}

fn entry(rule: Rule) -> MethodEntry {
    let card = rule.method().unwrap_or_default().card();
    MethodEntry {
        id: rule.id().to_owned(),
        words: if rule == Rule::CHEN_2_GAUSS_2 {
            format!("-m {} --quadrature gauss2", rule.id())
        } else {
            format!("-m {}", rule.id())
        },
        title: card.title.to_owned(),
        degree: match card.degree {
            Degree::Quadratic => 2,
            Degree::Cubic => 3,
        },
        order: card.law.map(|law| law.order),
        leading: card.leading.to_owned(),
        criterion: card.criterion.to_owned(),
        origin: card.origin.to_owned(),
        advice: card.advice.to_owned(),
    }
}

/// The command that makes the page.
fn command(shape: &Shape, rules: &[Rule], request: &PageRequest<'_>) -> String {
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
