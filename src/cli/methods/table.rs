//! The catalogue for people.

use comfy_table::{ColumnConstraint, ContentArrangement, Table, presets};
use curveto::continuity::Continuity;
use curveto::method::Ends;
use curveto::number::{rounded_up, significant};
use curveto::write::catalogue::MethodDocument;

/// The width of prose: longer lines are hard to read, and a pipe has no width of its own.
pub(super) const PROSE: u16 = 100;

/// The widest table: its columns grow until nothing wraps.
const WIDEST: u16 = 200;

/// A table without lines that fits the terminal, as far as this width.
pub(super) fn plain(widest: u16) -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Dynamic);
    table.set_width(width(widest));
    table
}

/// The width of the terminal, or what `COLUMNS` says of it.
fn width(widest: u16) -> u16 {
    let told = std::env::var("COLUMNS").ok();
    let told = told.and_then(|columns| columns.parse().ok());
    let width = told.or_else(|| Table::new().width());
    width.unwrap_or(PROSE).clamp(60, widest)
}

/// Without the blanks that a table puts at both ends of its lines.
pub(super) fn lines(table: &Table, indent: &str) -> String {
    let trim = |line: &str| {
        let line = line.strip_prefix(' ').unwrap_or(line).trim_end();
        if line.is_empty() {
            "\n".to_owned()
        } else {
            format!("{indent}{line}\n")
        }
    };
    table.to_string().lines().map(trim).collect()
}

/// The groups, each with its heading.
const GROUPS: [(u8, Ends, &str); 4] = [
    (3, Ends::OnCircle, "CUBICS"),
    (
        3,
        Ends::OffCircle,
        "CUBICS OFF THE CIRCLE (closed shapes, equal segments)",
    ),
    (2, Ends::OnCircle, "QUADRATICS"),
    (
        2,
        Ends::OffCircle,
        "QUADRATICS OFF THE CIRCLE (closed shapes, equal segments)",
    ),
];

pub(super) fn render(entries: &[MethodDocument]) -> String {
    let columns = columns(width(WIDEST));
    let cut = |row: [String; 7]| row.into_iter().take(columns);
    let mut table = plain(WIDEST);
    table.add_row(cut(HEADINGS.map(str::to_owned)));
    for (degree, ends, heading) in GROUPS {
        // One table, so that the groups share their columns; a heading is put in its place afterwards.
        table.add_row([marker(heading)]);
        for entry in entries {
            if entry.degree == degree && entry.ends == ends {
                table.add_row(cut(row(entry)));
            }
        }
    }
    for (i, column) in table.column_iter_mut().enumerate() {
        if i != CRITERION {
            column.set_constraint(ColumnConstraint::ContentWidth);
            column.set_padding((1, 0));
        }
    }
    let mut out = lines(&table, "");
    for (_, _, heading) in GROUPS {
        out = out.replace(&marker(heading), &format!("\n{heading}"));
    }
    out + LEGEND
}

const HEADINGS: [&str; 7] = [
    "method",
    "joints",
    "order",
    "error",
    "angle",
    "criterion",
    "source",
];

/// The column whose texts are wrapped.
const CRITERION: usize = 5;

/// How many columns a width has room for: criteria of a few letters a line say nothing.
const fn columns(width: u16) -> usize {
    match width {
        ..72 => CRITERION,
        72..90 => CRITERION + 1,
        _ => HEADINGS.len(),
    }
}

/// Stands for a heading, which would widen its column: no wider than the ids.
fn marker(heading: &str) -> String {
    format!("<{}>", heading.len())
}

fn row(entry: &MethodDocument) -> [String; 7] {
    let id = if entry.aliases.is_empty() {
        entry.id.to_owned()
    } else {
        format!("{}\n  {}", entry.id, entry.aliases.join("\n  "))
    };
    let joints = match (entry.continuity.equal, entry.continuity.uneven) {
        (equal, uneven) if uneven == equal || uneven == Continuity::Apart => equal.to_string(),
        (equal, uneven) => format!("{equal}/{uneven}"),
    };
    [
        id,
        joints,
        entry.order.map_or_else(String::new, |o| o.to_string()),
        significant(rounded_up(entry.quarter.error.peak, 3), 3),
        format!("{}°", entry.largest_angle),
        entry.criterion.to_owned(),
        entry.origin.to_owned(),
    ]
}

const LEGEND: &str = "
joints  continuity where equal segments meet, after the
        stroke where unequal ones do
order   the power of the angle with which the error falls
error   the largest distance from the circle, in radii, of
        four segments
angle   the largest of one segment

'curveto methods ID' tells everything of one method;
an indented name is an alias.
";
