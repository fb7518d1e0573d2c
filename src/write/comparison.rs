//! The table and the CSV of a comparison.

use core::fmt::Write;

use super::csv;
use crate::compare::{Comparison, NOISE, Row};
use crate::number::{compact, rounded_up, text};
use crate::picture::words::sentence;

/// How wide a table may be.
const COLUMNS: usize = 80;

/// The table for people: as many digits, six at most, as 80 columns have room for.
#[must_use]
pub fn table(comparison: &Comparison) -> String {
    let candidates = [(6, 2), (5, 2), (4, 2), (4, 1), (3, 2), (3, 1)];
    let laid = candidates.map(|(digits, gap)| lay_out(&cells(comparison, digits), gap));
    let fits = |text: &&String| text.lines().all(|line| line.chars().count() <= COLUMNS);
    let widest = laid.iter().find(fits).or(laid.last());
    widest.cloned().unwrap_or_default() + &notes(comparison)
}

/// What the table cannot say in its cells.
fn notes(comparison: &Comparison) -> String {
    let label = sentence(comparison.by.label());
    let by_span = !comparison.spans.is_empty();
    let (whole, command) = match comparison.ellipse.map(text) {
        Some(b) => (
            format!("the full ellipse with the semi-axes 1 and {b}"),
            format!("ellipse 1 {b} -m ID -n N"),
        ),
        None if by_span => (
            "one segment of the circle of radius 1".to_owned(),
            "arc 1 --sweep ANGLE -m ID -n 1".to_owned(),
        ),
        None => (
            "the full circle of radius 1".to_owned(),
            "circle 1 -m ID -n N".to_owned(),
        ),
    };
    let order = match comparison.rows.iter().any(|row| row.order.is_some()) {
        false => "",
        true if by_span => {
            ".\norder: the power of the angle with which it falls, from a row's two least angles"
        }
        true => ".\norder: the power of 1/n with which it falls, from a row's last two figures",
    };
    let impossible = if comparison.rows.iter().any(|row| row.values.contains(&None)) {
        format!(".\n-: impossible; 'curveto measure {command}' says why")
    } else {
        String::new()
    };
    format!("\n{label}, of {whole}{order}{impossible}.\n")
}

/// The head and the rows as texts.
fn cells(comparison: &Comparison, digits: u8) -> Vec<Vec<String>> {
    let columns = comparison.columns().into_iter().map(|(name, _)| name);
    let head = core::iter::once("method".to_owned())
        .chain(columns)
        .chain(["order".to_owned()]);
    let rows = comparison.rows.iter().map(|row| row_cells(row, digits));
    core::iter::once(head.collect()).chain(rows).collect()
}

fn row_cells(row: &Row, digits: u8) -> Vec<String> {
    let mut cells = vec![row.rule.id().to_owned()];
    cells.extend(row.values.iter().map(|&value| figure(value, digits)));
    cells.push(
        row.order
            .map_or_else(|| "-".to_owned(), |order| format!("{order:.2}")),
    );
    cells
}

fn figure(value: Option<f64>, digits: u8) -> String {
    match value {
        None => "-".to_owned(),
        Some(value) if value <= NOISE => "<2e-15".to_owned(),
        Some(value) => compact(rounded_up(value, digits), digits),
    }
}

/// Columns as wide as their widest cells, the first to the left and the others to the right.
fn lay_out(cells: &[Vec<String>], gap: usize) -> String {
    let columns = cells.first().map_or(0, Vec::len);
    let width = |column: usize| {
        cells
            .iter()
            .map(|row| row[column].chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut out = String::new();
    for row in cells {
        let mut line = format!("{:<1$}", row[0], widths[0]);
        for (cell, &width) in row.iter().zip(&widths).skip(1) {
            let _ = write!(line, "{:gap$}{cell:>width$}", "");
        }
        out += line.trim_end();
        out.push('\n');
    }
    out
}

/// A line a method, all digits.
#[must_use]
pub fn csv(comparison: &Comparison) -> String {
    let sizes = comparison.columns().into_iter().map(|(_, size)| text(size));
    let sizes: Vec<String> = sizes.collect();
    let row = |row: &Row| -> Vec<String> {
        let values = row.values.iter().chain([&row.order]);
        let values = values.map(|value| value.map(text).unwrap_or_default());
        core::iter::once(row.rule.id().to_owned())
            .chain(values)
            .collect()
    };
    let names = format!("method,{},order", sizes.join(","));
    csv::lines(&names, comparison.rows.iter().map(row))
}
