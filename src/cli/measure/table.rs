//! The report for people, 80 columns wide.

use core::fmt::Write;

use curveto::measure::Report;
use curveto::measure::continuity::Joint;
use curveto::measure::curvature::Curvature;
use curveto::measure::fit::FitTo;
use curveto::measure::report::{
    ContinuityReport, CurvatureReport, ErrorReport, Extent, Extreme, Place, ReferenceReport,
};
use curveto::number::{compact, rounded_up, significant};
use curveto::write::measurement::Measurement;

use crate::cli::table::{close_up, lines, plain};

/// How many joints are listed; beyond, most are alike, and JSON lists them all.
const MOST_JOINTS: usize = 16;

/// A name, a figure and what is to be said of it.
type TableLine = [String; 3];

/// The report on one curve.
pub(super) fn render(measurement: &Measurement) -> String {
    let report = &measurement.report;
    let mut table = plain();
    for line in error(&report.error)
        .into_iter()
        .chain(extents(report))
        .chain(curvature(&report.curvature))
    {
        table.add_row(line);
    }
    let lag = &report.angle_lag;
    let linear = "degrees ahead of linear in t".to_owned();
    table.add_row(["angle lag".to_owned(), number(lag.largest), linear]);
    table.add_row([String::new(), String::new(), place(Some(lag.at))]);
    table.add_rows(continuity(&report.continuity));
    close_up(&mut table, 2, &[]);
    let mut out = format!(
        "{}\nagainst {}\n\n{}",
        measurement.subject.title,
        reference(&report.reference),
        lines(&table, "")
    );
    if !report.continuity.joints.is_empty() {
        out += "\n";
        out += &joints(&report.continuity.joints);
    }
    out
}

fn line(name: &str, value: String, note: String) -> TableLine {
    [name.to_owned(), value, note]
}

fn error(error: &ErrorReport) -> [TableLine; 6] {
    let share = format!(
        "{} of the larger radius",
        compact(rounded_up(error.relative_peak, 6), 6)
    );
    [
        line("outward", bound(error.outward), place(error.outward_at)),
        line("inward", bound(error.inward), place(error.inward_at)),
        line("peak", bound(error.peak), share),
        line("mean (t)", number(error.mean), String::new()),
        line("mean (angle)", number(error.mean_angle), String::new()),
        line("rms (t)", number(error.rms), String::new()),
    ]
}

fn extents(report: &Report) -> [TableLine; 2] {
    [
        line(
            "length",
            number(report.length.curve),
            extent(&report.length),
        ),
        line("area", number(report.area.curve), extent(&report.area)),
    ]
}

fn curvature(k: &CurvatureReport) -> [TableLine; 3] {
    let value = |extreme: Option<Extreme>| {
        extreme.map_or_else(
            || "none".to_owned(),
            |e| e.value.map_or_else(|| "unbounded".to_owned(), number),
        )
    };
    [
        line(
            "curvature from",
            value(k.least),
            place(k.least.map(|e| e.at)),
        ),
        line("to", value(k.largest), place(k.largest.map(|e| e.at))),
        line(
            "true, from",
            number(k.true_least),
            format!("to {}", number(k.true_largest)),
        ),
    ]
}

fn continuity(c: &ContinuityReport) -> [TableLine; 2] {
    let order = c
        .order
        .map_or_else(|| "-".to_owned(), |order| order.to_string());
    if c.joints.is_empty() {
        return [
            line("continuity", order, "no joints".to_owned()),
            line("", String::new(), String::new()),
        ];
    }
    let turn = format!("largest turn {} degrees", compact(c.largest_turn, 3));
    let right = format!(
        "coordinates taken as right to {}",
        compact(c.coordinate_tolerance, 2)
    );
    [
        line("continuity", order, turn),
        line("", String::new(), right),
    ]
}

/// A bound, rounded up.
fn bound(x: f64) -> String {
    number(rounded_up(x, 7))
}

fn number(x: f64) -> String {
    compact(x, 7)
}

fn place(at: Option<Place>) -> String {
    at.map_or_else(String::new, |at| {
        format!(
            "at {} degrees, segment {}, t {}",
            significant(at.angle, 6),
            at.segment,
            significant(at.t, 5)
        )
    })
}

fn extent(extent: &Extent) -> String {
    let relative = extent
        .relative
        .map(|r| format!(", {} of it", compact(r, 4)));
    format!(
        "true {}; {}{}",
        number(extent.truth),
        compact(extent.difference, 4),
        relative.unwrap_or_default()
    )
}

fn reference(reference: &ReferenceReport) -> String {
    // What rounding leaves of 0 is told as 0.
    let unless_nothing = |x: f64, size: f64| if x.abs() < 1e-13 * size { 0.0 } else { x };
    let radius = reference.radii[0].max(reference.radii[1]);
    let [x, y] = reference
        .center
        .map(|x| significant(unless_nothing(x, radius), 8));
    let [rx, ry] = reference.radii.map(|r| significant(r, 10));
    let shape = if reference.radii[0] == reference.radii[1] {
        format!("the circle about {x},{y} of radius {rx}")
    } else {
        format!(
            "the ellipse about {x},{y}\nwith radii {rx} and {ry} at {} degrees",
            significant(unless_nothing(reference.rotation, 360.0), 6)
        )
    };
    let Some(fit) = reference.fit else {
        return shape;
    };
    let to = match fit.to {
        FitTo::Joints => "joints",
        FitTo::Curve => "points of the curve",
    };
    format!(
        "{shape},\nfitted to {} {to}: root mean square {}, {} of the radius",
        fit.points,
        compact(fit.rms, 4),
        compact(fit.relative_rms, 4)
    )
}

fn joints(joints: &[Joint]) -> String {
    let mut table = plain();
    table.set_header([
        "joint at",
        "order",
        "gap",
        "turn",
        "",
        "curvature",
        "d/ds",
        "d²/ds²",
    ]);
    for joint in joints.iter().take(MOST_JOINTS) {
        table.add_row(side(joint, "before", joint.before));
        table.add_row(side(joint, "after", joint.after));
    }
    close_up(&mut table, 2, &[0, 2, 3, 5, 6, 7]);
    let mut out = lines(&table, "");
    out += &parameters(joints);
    if joints.len() > MOST_JOINTS {
        let more = joints.len() - MOST_JOINTS;
        // Writing to a string cannot fail.
        let _ = writeln!(out, "... and {more} more joints: -f json lists them all");
    }
    out
}

/// Bias and tension of the joints that have them.
fn parameters(joints: &[Joint]) -> String {
    let mut table = plain();
    table.set_header(["joint at", "bias", "tension", "rest along the normal"]);
    for joint in joints.iter().take(MOST_JOINTS) {
        if let Some(found) = joint.parameters {
            table.add_row([
                significant(joint.angle, 6),
                compact(found.bias, 6),
                compact(found.tension, 6),
                compact(found.rest, 6),
            ]);
        }
    }
    if table.is_empty() {
        return String::new();
    }
    close_up(&mut table, 2, &[0, 1, 2, 3]);
    "\n".to_owned() + &lines(&table, "")
}

/// The line of one side of a joint; what holds for both stands in the first.
fn side(joint: &Joint, name: &str, side: Option<Curvature>) -> [String; 8] {
    let once = |text: String| {
        if name == "before" {
            text
        } else {
            String::new()
        }
    };
    let figure =
        |of: fn(Curvature) -> f64| side.map_or_else(|| "none".to_owned(), |k| compact(of(k), 6));
    [
        once(significant(joint.angle, 6)),
        once(joint.continuity.to_string()),
        once(compact(joint.gap, 3)),
        once(compact(joint.turn, 3)),
        name.to_owned(),
        figure(|k| k.value),
        figure(|k| k.d1),
        figure(|k| k.d2),
    ]
}
