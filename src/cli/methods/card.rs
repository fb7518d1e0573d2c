//! The card of one method.

use comfy_table::{ColumnConstraint, Table, Width};
use curveto::continuity::Continuity;
use curveto::method::{Ends, Span};
use curveto::number::{rounded_up, significant, text};
use curveto::write::catalogue::{MethodDocument, corner};
use curveto::{Method, Result};

use super::notes::notes;
use crate::cli::table::{PROSE, close_up, lines, plain, width, wrapped};

/// The numbers of segments to the circle that a card tells.
const COUNTS: [u32; 7] = [2, 3, 4, 5, 6, 8, 12];

pub(super) fn render(method: Method, entry: &MethodDocument) -> Result<String> {
    let mut out = heading(entry);
    out += &section("", &words(entry));
    out += &section("A quarter of the unit circle", &quarter(entry));
    out += "\nSegments to a circle of radius 1\n";
    out += &lines(&counts(method)?, "  ");
    for note in notes(method)? {
        let mut table = wrapped(width(PROSE));
        table.add_row([note]);
        close_up(&mut table, 2, &[]);
        out.push('\n');
        out += &lines(&table, "");
    }
    Ok(out)
}

fn heading(entry: &MethodDocument) -> String {
    let aliases = if entry.aliases.is_empty() {
        String::new()
    } else {
        format!(" (also {})", entry.aliases.join(", "))
    };
    format!("{}{aliases}: {}\n", entry.id, entry.title)
}

/// A heading, and rows of a name and what is to be said.
fn section(heading: &str, rows: &[(&str, String)]) -> String {
    let mut table = wrapped(width(PROSE));
    for (name, value) in rows {
        table.add_row([*name, value.as_str()]);
    }
    close_up(&mut table, 2, &[]);
    if let Some(column) = table.column_mut(0) {
        column.set_constraint(ColumnConstraint::Absolute(Width::Fixed(19)));
    }
    let heading = if heading.is_empty() {
        String::new()
    } else {
        format!("{heading}\n")
    };
    format!("\n{heading}{}", lines(&table, "  "))
}

fn words(entry: &MethodDocument) -> Vec<(&'static str, String)> {
    let degree = if entry.degree == 3 {
        "cubic"
    } else {
        "quadratic"
    };
    let ends = match entry.ends {
        Ends::OnCircle => "both ends on the circle",
        Ends::OffCircle => "ends off the circle: closed shapes with equal segments only",
    };
    vec![
        ("criterion", entry.criterion.to_owned()),
        ("formula", entry.formula.to_owned()),
        ("curve", format!("{degree}, {ends}")),
        ("joints", joints(entry)),
        ("order", order(entry)),
        ("largest angle", format!("{} degrees", entry.largest_angle)),
        ("when to use it", entry.advice.to_owned()),
        ("source", entry.source.to_owned()),
    ]
}

fn joints(entry: &MethodDocument) -> String {
    let told = |continuity: Continuity| match continuity {
        Continuity::Apart => "refused".to_owned(),
        Continuity::G0 => "G0, corners".to_owned(),
        other => other.to_string(),
    };
    format!(
        "equal segments {}; unequal ones {}",
        told(entry.continuity.equal),
        told(entry.continuity.uneven)
    )
}

fn order(entry: &MethodDocument) -> String {
    match (entry.order, entry.leading_constant) {
        (Some(order), Some(constant)) => format!(
            "{order}: the error tends to {} a^{order}, a in radians; the factor is {}",
            significant(constant, 6),
            entry.leading
        ),
        _ => entry.leading.to_owned(),
    }
}

fn quarter(entry: &MethodDocument) -> Vec<(&'static str, String)> {
    let quarter = &entry.quarter;
    let points: Vec<String> = quarter
        .points
        .iter()
        .map(|[x, y]| format!("({}, {})", text(*x), text(*y)))
        .collect();
    let mut rows = vec![
        ("control points", points.join("\n")),
        ("handle", text(quarter.handle)),
    ];
    if entry.ends == Ends::OffCircle {
        rows.push(("end radius", text(quarter.end_radius)));
    }
    let error = &quarter.error;
    rows.push((
        "error",
        format!(
            "{} outside, {} inside",
            bound(error.outward),
            bound(error.inward)
        ),
    ));
    if quarter.corner != 0.0 {
        rows.push((
            "corner at a joint",
            format!("{} degrees", significant(quarter.corner, 6)),
        ));
    }
    rows
}

fn counts(method: Method) -> Result<Table> {
    let corners = method.card().continuity_equal == Continuity::G0;
    let mut table = plain();
    let mut header = vec!["segments", "angle", "handle", "outside", "inside"];
    if corners {
        header.push("corner");
    }
    table.add_row(header);
    for count in COUNTS {
        let span = Span::from_degrees(360.0 / f64::from(count));
        // What a method does not serve is said by its largest angle and by its formula.
        let (Ok(piece), Ok(error)) = (method.piece(&span), method.radial_error(&span)) else {
            continue;
        };
        let mut row = vec![
            count.to_string(),
            format!("{}°", significant(span.degrees(), 4)),
            significant(piece.handle_length(), 10),
            bound(error.outward),
            bound(error.inward),
        ];
        if corners {
            row.push(format!("{}°", significant(corner(method, &span)?, 4)));
        }
        table.add_row(row);
    }
    close_up(&mut table, 2, &[0, 1]);
    Ok(table)
}

/// An error to six digits, rounded up.
fn bound(error: f64) -> String {
    significant(rounded_up(error, 6), 6)
}
