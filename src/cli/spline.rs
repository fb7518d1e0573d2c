//! `spline`.

use std::io::BufReader;
use std::process::ExitCode;

use curveto::Error;
use curveto::spline::Spline;
use curveto::spline::points::{Points, ReadError};
use curveto::write::spline::SplineDrawing;

use super::args::{SplineArgs, SplineSource, hint_of_number};
use super::failure::Failure;
use super::input::Source;
use super::output::write_drawn;
use super::{Outcome, remedies};

pub(super) fn run(args: &SplineArgs) -> Outcome {
    let format = args.output.format_but_gcode()?;
    let options = args.options()?;
    let source = PointSource::of(&args.source);
    let Points { points, lines } = source.read()?;
    let spline = Spline::new(points, options).map_err(|error| source.locate(error, &lines))?;
    drop(lines);
    let transform = args.output.transform();
    let curve = spline.curve(args.output.rounding(format), transform)?;
    let drawing = SplineDrawing {
        spline: &spline,
        curve,
        transform,
    };
    write_drawn(
        &drawing,
        format,
        &args.output.options(format)?,
        &args.output,
    )?;
    Ok(ExitCode::SUCCESS)
}

/// Where points come from.
#[derive(Clone, Copy)]
enum PointSource<'a> {
    Words(&'a str),
    Source(Source<'a>),
}

impl<'a> PointSource<'a> {
    fn of(words: &'a SplineSource) -> Self {
        match words.points_file.as_deref() {
            None => Self::Words(words.points.as_deref().unwrap_or_default()),
            Some(path) => Self::Source(Source::of(path)),
        }
    }

    /// What messages call it.
    fn name(self) -> String {
        match self {
            Self::Words(_) => "--points".to_owned(),
            Self::Source(source) => source.name(),
        }
    }

    fn read(self) -> Result<Points, Failure> {
        let read = match self {
            Self::Words(words) => Points::parse(words),
            Self::Source(source) => Points::read(BufReader::new(source.open()?)),
        };
        read.map_err(|error| match (&error, self) {
            (
                ReadError::Syntax {
                    column, text, why, ..
                },
                source,
            ) => Failure::Request {
                message: match source {
                    Self::Words(_) => format!("{why}, at column {column} of --points"),
                    Self::Source(_) => format!("{}:{error}", source.name()),
                },
                hint: hint_of_number(text),
            },
            _ => anyhow::Error::from(error)
                .context(format!("cannot read {}", self.name()))
                .into(),
        })
    }

    /// The error with the lines of the points that it names.
    fn locate(self, error: Error, lines: &[usize]) -> Failure {
        match error {
            Error::RepeatedPoint { first, second } if !lines.is_empty() => {
                // The place to look at is the later of the two; that is the last point of all where it meets the first.
                let at = lines[first].max(lines[second]);
                let other = lines[first].min(lines[second]);
                Failure::Request {
                    message: format!("{}:{at}: {error} (lines {other} and {at})", self.name()),
                    hint: remedies::hint(&error),
                }
            }
            error => error.into(),
        }
    }
}
