//! The figures that Lancaster, Chen and Apprich print, each beside the true one, which is computed here.
//!
//! What is printed was read in Lancaster, "Approximating a Circle or an Ellipse Using Four Bezier Cubic Splines" (2005); Chen,
//! "Formulations of composite parametric cubic curves and circle approximations" (1996), Tables 1 and 2; Apprich, Dietrich, Höllig et
//! al., a note on C4 cubic spline approximations of a circle. docs/errata.md says why they differ.

use core::f64::consts::TAU;

use super::document::{SourceRow, SourceTable};
use crate::compare::{Comparison, Criterion};
use crate::error::Result;
use crate::method::{Method, Rule, Span};
use crate::number::{compact, text};
use crate::numeric::functions::power;

/// Lancaster's table: splines, the magic number, the peak and the average.
const LANCASTER: [(usize, &str, &str, &str); 6] = [
    (2, "1.333333", "0.0196725", "0.00869406"),
    (3, "0.7698112", "0.00150716", "0.000705631"),
    (4, "0.551784", "0.000265718", "0.00012482"),
    (5, "0.433072", "6.78897e-05", "3.22829e-05"),
    (6, "0.3572045", "2.38419e-05", "1.20421e-05"),
    (8, "0.2652031", "4.05312e-06", "1.89818e-06"),
];

/// Chen's Table 1: the formulations at a quarter. The second is given with the quadrature that he prints.
const CHEN_1: [(&str, &str, Rule, &str); 4] = [
    (
        "Formulation I",
        "chen-1",
        Rule::Method(Method::Chen1),
        "0.02773",
    ),
    (
        "Formulation II, exact arc length",
        "chen-2",
        Rule::Method(Method::Chen2),
        "0.01903",
    ),
    (
        "Formulation II, two-point Gauss",
        "chen-2",
        Rule::CHEN_2_GAUSS_2,
        "0.01903",
    ),
    (
        "Formulation III",
        "chen-3",
        Rule::Method(Method::Chen3),
        "0.01521",
    ),
];

/// Chen's Table 2: Formulation III at these parts of the circle.
const CHEN_2: [(usize, &str, &str); 3] = [
    (4, "π/2", "0.01521"),
    (6, "π/3", "0.00307"),
    (8, "π/4", "0.00010"),
];

/// The numbers of segments at which Apprich's leading terms are taken.
const APPRICH: [usize; 6] = [3, 4, 5, 6, 8, 12];

/// All of them.
pub(super) fn tables() -> Result<Vec<SourceTable>> {
    Ok(vec![lancaster()?, chen()?, apprich()?])
}

/// A figure of a full circle of radius 1.
fn figure(rule: Rule, count: usize, by: Criterion) -> Result<f64> {
    let comparison = Comparison::new(&[rule], &[count], by, None)?;
    let values = comparison.rows.first().and_then(|row| row.values.first());
    Ok(values.copied().flatten().unwrap_or(f64::NAN))
}

/// A row about circles.
struct TableRow<'a> {
    label: String,
    rule: Rule,
    segments: usize,
    printed: &'a str,
    unit: &'a str,
    command: String,
}

impl TableRow<'_> {
    /// The row with the true figure.
    fn beside(self, truth: f64) -> SourceRow {
        SourceRow {
            label: self.label,
            method: self.rule.id().to_owned(),
            segments: self.segments,
            printed: self.printed.to_owned(),
            printed_value: self.printed.parse().unwrap_or(f64::NAN),
            truth,
            unit: self.unit.to_owned(),
            command: self.command,
        }
    }

    /// The row with the figure by this criterion, which the command shows.
    fn measured(self, by: Criterion) -> Result<SourceRow> {
        let truth = figure(self.rule, self.segments, by)?;
        Ok(self.beside(truth))
    }
}

/// What Lancaster says of four splines: his numbers, and by what part the best one is better.
fn lancasters_words() -> Result<Vec<SourceRow>> {
    let (best, normal) = (Method::LancasterBest, Method::Midpoint);
    let quarter = Span::from_degrees(90.0);
    let handle = |method: Method| Ok(method.piece(&quarter)?.handle_length());
    let saved = |by| -> Result<f64> {
        let [best, normal] = [best, normal].map(|method| figure(method.into(), 4, by));
        Ok(100.0 * (1.0 - best? / normal?))
    };
    let compared = "curveto compare -m midpoint,lancaster-best -n 4";
    let by_mean = format!("{compared} --by mean");
    let rows: [(_, Method, _, Result<f64>, _, &str); 4] = [
        (
            "Normal number, 4 splines",
            normal,
            "0.55228475",
            handle(normal),
            "",
            "curveto methods lancaster-normal",
        ),
        (
            "Best number, 4 splines",
            best,
            "0.551784",
            handle(Method::Minimax),
            "",
            "curveto methods minimax",
        ),
        (
            "Peak lower than the normal one by",
            best,
            "24",
            saved(Criterion::Peak),
            "%",
            compared,
        ),
        (
            "Average lower than the normal one by",
            best,
            "24",
            saved(Criterion::Mean),
            "%",
            &by_mean,
        ),
    ];
    rows.into_iter()
        .map(|(label, method, printed, truth, unit, command)| {
            let row = TableRow {
                label: label.to_owned(),
                rule: method.into(),
                segments: 4,
                printed,
                unit,
                command: command.to_owned(),
            };
            Ok(row.beside(truth?))
        })
        .collect()
}

fn lancaster() -> Result<SourceTable> {
    let mut rows = lancasters_words()?;
    for (segments, number, peak, average) in LANCASTER {
        let figures = [
            ("Peak", peak, Criterion::Peak),
            ("Average", average, Criterion::Mean),
        ];
        for (name, printed, by) in figures {
            let row = TableRow {
                label: format!("{name}, {segments} splines by {number}"),
                rule: Method::LancasterBest.into(),
                segments,
                printed,
                unit: "",
                command: format!("curveto compare -m lancaster-best -n {segments} --by {by}"),
            };
            rows.push(row.measured(by)?);
        }
    }
    Ok(SourceTable {
        id: "lancaster".to_owned(),
        title: "Lancaster 2005".to_owned(),
        source: "Don Lancaster, Approximating a Circle or an Ellipse Using Four Bezier Cubic Splines".to_owned(),
        note: "Errors of the full circle of radius 1. Beside his best number stands the one whose peak is least; an average is the mean distance over t.".to_owned(),
        rows,
    })
}

fn chen() -> Result<SourceTable> {
    let mut rows = Vec::new();
    for (label, id, rule, printed) in CHEN_1 {
        let quadrature = if rule == Rule::CHEN_2_GAUSS_2 {
            " --quadrature gauss2"
        } else {
            ""
        };
        let row = TableRow {
            label: format!("Table 1, π/2: {label}"),
            rule,
            segments: 4,
            printed,
            unit: "",
            command: format!("curveto compare -m {id} -n 4{quadrature}"),
        };
        rows.push(row.measured(Criterion::Peak)?);
    }
    for (segments, angle, printed) in CHEN_2 {
        let row = TableRow {
            label: format!("Table 2, {angle}: Formulation III"),
            rule: Method::Chen3.into(),
            segments,
            printed,
            unit: "",
            command: format!("curveto compare -m chen-3 -n {segments}"),
        };
        rows.push(row.measured(Criterion::Peak)?);
    }
    Ok(SourceTable {
        id: "chen".to_owned(),
        title: "Chen 1996".to_owned(),
        source: "Da-Pan Chen, Formulations of composite parametric cubic curves and circle approximations".to_owned(),
        note: "The largest radial deviation |Δr|/r of a segment of this angle.".to_owned(),
        rows,
    })
}

/// E is the largest 1 - r² of the method, E* its error after scaling.
fn apprich() -> Result<SourceTable> {
    let mut rows = Vec::new();
    for segments in APPRICH {
        let angle = TAU / segments as f64;
        for (name, denominator, method, by) in [
            ("E", 4096.0, Method::Apprich, Criterion::Square),
            ("E*", 16384.0, Method::ApprichScaled, Criterion::Peak),
        ] {
            let leading = compact(3.0 / denominator * power(angle, 6), 6);
            let row = TableRow {
                label: format!("{name}, φ = 360°/{segments}: 3φ⁶/{}", text(denominator)),
                rule: method.into(),
                segments,
                printed: &leading,
                unit: "",
                command: format!("curveto compare -m {} -n {segments} --by {by}", method.id()),
            };
            rows.push(row.measured(by)?);
        }
    }
    Ok(SourceTable {
        id: "apprich".to_owned(),
        title: "Apprich, Dietrich, Höllig et al.".to_owned(),
        source: "Christian Apprich, Anne Dietrich, Klaus Höllig et al., a note on C4 cubic spline approximations of a circle".to_owned(),
        note: "The paper prints no table but leading terms: E, the largest 1 − r² of apprich, is 3φ⁶/4096 + O(φ⁸); E*, the error of apprich-scaled, is 3φ⁶/16384 + O(φ⁸). Here they stand beside the values themselves.".to_owned(),
        rows,
    })
}
