//! `measure` of curves that someone else made: each subpath is judged by itself, and what cannot be judged is named.

use curveto::contour::Contour;
use curveto::curve::Curve;
use curveto::measure::{Reference, fit, report};
use curveto::number::counted;
use curveto::write::measurement::Measurement;
use curveto::{document, path};
use kurbo::Affine;

use super::super::args::measure::{ForeignArgs, ReportArgs};
use super::super::failure::Failure;
use super::super::input::{self, InputKind};
use super::{MeasuredSubject, check_segments};

/// The curves of one element, or of a path that stands alone.
struct ForeignPath {
    /// What messages call it.
    name: String,
    contours: curveto::Result<(Vec<Contour>, Affine)>,
}

/// Measures every subpath that can be measured, and notes the others.
pub(super) fn measured(
    args: &ForeignArgs,
    report: &ReportArgs,
) -> Result<Vec<MeasuredSubject>, Failure> {
    let (name, sources) = sources(args, report)?;
    let readable = sources
        .iter()
        .filter_map(|source| source.contours.as_ref().ok());
    let contours = readable.flat_map(|(contours, _)| contours);
    check_segments(contours.map(|contour| contour.steps.len()).sum())?;
    let mut found = Vec::new();
    let mut refused = Vec::new();
    for source in sources {
        match source.contours {
            Ok((contours, map)) => {
                let several = contours.len() > 1;
                for (i, contour) in contours.iter().enumerate() {
                    let name = if several {
                        format!("{}, subpath {}", source.name, i + 1)
                    } else {
                        source.name.clone()
                    };
                    match subject(&name, contour, map, args, report) {
                        Ok(subject) => found.push(subject),
                        Err(failure) => refused.push((name, failure)),
                    }
                }
                if contours.is_empty() {
                    refused.push((source.name, empty()));
                }
            }
            Err(error) => refused.push((source.name, error.into())),
        }
    }
    // A single one that cannot be judged is the failure of the whole.
    if found.is_empty() && args.path.is_some() && refused.len() == 1 {
        return Err(refused.remove(0).1);
    }
    for (place, failure) in refused {
        match failure {
            Failure::Request { message, .. } => {
                report
                    .quiet
                    .note(&format!("{place}: not measured: {message}"));
            }
            other => return Err(other),
        }
    }
    if found.is_empty() {
        return Err(Failure::request_with_hint(
            format!("{name} holds no path that can be measured"),
            "a path of cubic or quadratic Béziers can; 'curveto convert' makes them of circles, ellipses and arcs",
        ));
    }
    Ok(found)
}

fn empty() -> Failure {
    Failure::request("there is nothing to measure: the path is empty, or a single point")
}

fn sources(args: &ForeignArgs, report: &ReportArgs) -> Result<(String, Vec<ForeignPath>), Failure> {
    if let Some(data) = &args.path {
        let (bytes, name) = input::drawing(data)?;
        let contours = input::contours(data, bytes, &name, Some("--file reads SVG"))?;
        let source = ForeignPath {
            name: "path".to_owned(),
            contours: Ok((contours, Affine::IDENTITY)),
        };
        return Ok((name, vec![source]));
    }
    let Some(file) = &args.file else {
        return Err(Failure::request_with_hint(
            "nothing to measure was named",
            "for example: curveto measure circle 50, curveto measure --path 'M...', curveto measure --file drawing.svg",
        ));
    };
    let (svg, name) = input::document(input::Source::of(file))?;
    let drawing = document::svg_paths(&svg).map_err(|error| Failure::Request {
        message: format!("{name}:{error}"),
        hint: InputKind::of(file.as_os_str(), &svg)
            .remedy(None, Some("--path reads path data"))
            .map(str::to_owned),
    })?;
    for unread in &drawing.unread {
        report.quiet.note(&format!("{name}: {unread}"));
    }
    let source = |path: document::SvgPath| ForeignPath {
        name: input::place(&name, &path),
        contours: path.contours,
    };
    let sources = drawing.paths.into_iter().map(source).collect();
    Ok((name, sources))
}

/// Measures one subpath.
fn subject(
    name: &str,
    contour: &Contour,
    map: Affine,
    args: &ForeignArgs,
    report_args: &ReportArgs,
) -> Result<MeasuredSubject, Failure> {
    let curve = path::curve(contour).ok_or_else(empty)??.transformed(map);
    let (curve, left_out) = curve.without_empty_segments();
    if curve.segments.is_empty() {
        return Err(empty());
    }
    let (truth, fit) = match args.against {
        Some(truth) => (truth, None),
        None => fitted(&curve, args)?,
    };
    let reference = Reference::from(truth);
    let mut found = report(&curve, &reference, report_args.coordinate_tolerance()?)?;
    found.reference.fit = fit;
    if left_out > 0 {
        let left_out = counted(left_out, "segment");
        let left_out = format!("{name}: {left_out} of no length left out");
        report_args.quiet.note(&left_out);
    }
    Ok(MeasuredSubject {
        name: name.to_owned(),
        curve,
        reference,
        measurement: Measurement::of_source(name, found),
        panel: 0,
    })
}

/// The shape that a curve was meant to be.
fn fitted(
    curve: &Curve,
    args: &ForeignArgs,
) -> Result<(curveto::shape::Truth, Option<fit::Fit>), Failure> {
    let fit = args.fit.unwrap_or_default();
    fit.fitted(curve)
        .map(|(truth, fit)| (truth, Some(fit)))
        .map_err(|error| {
            Failure::request_with_hint(
                error.to_string(),
                "--against circle:CX,CY,R or ellipse:CX,CY,RX,RY,ROT names the true shape",
            )
        })
}
