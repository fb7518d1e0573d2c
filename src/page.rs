//! A page to look at: methods, counts and shapes to choose, each drawn and judged beforehand.
//!
//! The page is one file that asks for nothing else. It holds a [`PageDocument`] as JSON, whose curves and errors are those that it states.
//! Its scripts compute what follows from the control points: the charts along the curve, and the texts of formats other than path data.

mod choices;
mod document;
mod drawings;
mod sources;
mod words;

pub use document::{
    CriterionEntry, DrawingEntry, MethodEntry, PageDocument, PageStep, ShapeChoice, SourceRow,
    SourceTable,
};

use core::fmt::Write as _;

use crate::angle::Angle;
use crate::compare::Criterion;
use crate::error::{Error, FormatError, Remedy, Result};
use crate::method::Rule;
use crate::number::compact;
use crate::shape::Shape;
use crate::write::{escaped, json};

/// The largest page, in bytes.
const LARGEST: usize = 400_000;

/// What a page is to show.
#[derive(Debug, Clone)]
pub struct PageRequest<'a> {
    /// The shape to begin with; its radii are those of the others.
    pub shape: Shape,
    /// Whether the closing operator is left out.
    pub open: bool,
    /// The rules to choose from.
    pub rules: &'a [Rule],
    /// The numbers of segments to choose from.
    pub counts: &'a [usize],
    /// Angles of arcs of one segment, where those are to be looked at in place of the shape.
    pub spans: &'a [Angle],
    /// What methods are compared by at first.
    pub by: Criterion,
    /// The words of the command that makes the page, methods and counts left out; those of `explore` where there are none.
    pub words: Option<String>,
}

const PAGE: &str = include_str!("page/assets/page.html");
const STYLE: &str = include_str!("page/assets/page.css");
const SCRIPTS: [&str; 6] = [
    include_str!("page/assets/bezier.js"),
    include_str!("page/assets/formats.js"),
    include_str!("page/assets/figure.js"),
    include_str!("page/assets/charts.js"),
    include_str!("page/assets/tables.js"),
    include_str!("page/assets/page.js"),
];

/// The page. Its sliders hold as much as there is room for in 400,000 bytes.
///
/// # Errors
///
/// Where what was asked for has no room alone ([`Error::Format`]).
pub fn html(document: &PageDocument) -> Result<String> {
    let page = filled(document)?;
    if page.len() > LARGEST {
        return Err(too_large());
    }
    Ok(page)
}

/// The refusal of what has no room.
fn too_large() -> Error {
    Error::Format {
        format: "html",
        why: FormatError::Bytes { most: LARGEST },
        remedy: Remedy::SmallerPage,
    }
}

/// The page, however large.
fn filled(document: &PageDocument) -> Result<String> {
    let data = json::to_line(document)?.replace('<', "\\u003c");
    // The data come last, so that nothing in them is taken for a place to fill.
    let parts = [
        ("@TITLE@", escaped(&document.title)),
        ("@TITLE@", escaped(&document.title)),
        ("@TABLE@", plain_table(document)),
        ("@STYLE@", STYLE.trim_end().to_owned()),
        ("@SCRIPT@", SCRIPTS.concat().trim_end().to_owned()),
        ("@DATA@", data),
    ];
    let fill = |page: String, (place, text): &(&str, String)| page.replacen(place, text, 1);
    Ok(parts.iter().fold(PAGE.to_owned(), fill))
}

/// The peak errors of the shape that was asked for, for readers without scripts.
fn plain_table(document: &PageDocument) -> String {
    let Some((choice, step)) = document
        .shapes
        .first()
        .and_then(|choice| Some((choice, choice.steps.first()?)))
    else {
        return String::new();
    };
    let heads = choice
        .counts
        .iter()
        .map(|n| format!("<th scope=\"col\">{n}</th>"));
    let mut rows = format!(
        "<tr><th scope=\"col\">method</th>{}</tr>\n",
        heads.collect::<String>()
    );
    for method in &document.methods {
        let cell = |&n: &usize| {
            let found = step.drawing(&method.id, n);
            let figure = found.map_or_else(|| "-".to_owned(), |d| compact(d.figures[0], 6));
            format!("<td>{figure}</td>")
        };
        let cells: String = choice.counts.iter().map(cell).collect();
        let id = escaped(&method.id);
        // Writing to a string cannot fail.
        let _ = writeln!(rows, "<tr><th scope=\"row\">{id}</th>{cells}</tr>");
    }
    rows
}
