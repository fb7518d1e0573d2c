//! The catalogue for people.

use comfy_table::ColumnConstraint;
use curveto::continuity::Continuity;
use curveto::method::Ends;
use curveto::number::{rounded_up, significant};
use curveto::write::catalogue::MethodDocument;

use crate::cli::table::{close_up, lines, width, wrapped};

/// The widest table: its columns grow until nothing wraps.
const WIDEST: u16 = 200;

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
    let width = width(WIDEST);
    let columns = columns(width);
    let cut = |row: [String; 7]| row.into_iter().take(columns);
    let mut table = wrapped(width);
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
    close_up(&mut table, 1, &[]);
    for (i, column) in table.column_iter_mut().enumerate() {
        if i == CRITERION {
            column.set_padding((0, 2));
        } else {
            column.set_constraint(ColumnConstraint::ContentWidth);
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
