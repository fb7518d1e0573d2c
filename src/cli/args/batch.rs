//! The words of `batch`.

use std::path::PathBuf;

use clap::Args;
use curveto::batch::{OnError, Options};
use curveto::write::{self, Format};

use super::each::EachArgs;
use super::picture::PictureArgs;
use super::{FileArgs, TalkArgs, values};
use crate::cli::failure::Failure;
use crate::cli::formats;

/// The forms of a line, for `--help` and the manual page.
const GRAMMAR: &str = "\
A line is a JSON object or one of:
  circle CX CY R
  ellipse CX CY RX RY [ROTATION]
  arc CX CY R START SWEEP
  arc CX CY RX RY ROTATION START SWEEP
  svgarc X1 Y1 RX RY ROTATION LARGE SWEEP X2 Y2
  bulge X1 Y1 X2 Y2 B
  through X1 Y1 X2 Y2 X3 Y3
  polyline X Y B X Y B ... [close]
  path DATA
polyline is a DXF LWPOLYLINE, B the bulge to the next vertex.

JSON, with id, method, segments or tolerance where a line needs its own, and stroke, fill or stroke_width for svg, eps, png or pdf:
  {\"id\": \"a1\", \"circle\": {\"center\": [0,0], \"radius\": 50}, \"method\": \"minimax\", \"segments\": 4}
  {\"ellipse\": {\"center\": [0,0], \"radii\": [30,20], \"rotation\": 15}, \"tolerance\": 0.001}
  {\"arc\": {\"center\": [0,0], \"radius\": 50, \"start\": 0, \"sweep\": 90}}
  {\"svg_arc\": {\"from\": [0,0], \"radii\": [25,25], \"rotation\": -30, \"large_arc\": false, \"sweep\": true, \"to\": [50,-25]}}
  {\"bulge\": {\"from\": [0,0], \"to\": [10,0], \"bulge\": 1}}
  {\"through\": [[0,0], [5,5], [10,0]]}
  {\"polyline\": {\"vertices\": [[0,0,1], [10,0,0]], \"closed\": true}}
  {\"path\": \"M0 0A5 5 0 0 1 10 0Z\"}
Blank lines and lines that begin with # give a blank line.";

#[derive(Debug, Args)]
#[command(
    after_long_help = GRAMMAR,
    mut_arg("precision", |arg| arg.help("Decimals after the point, or auto [default: auto; in json all]").long_help("Decimals after the point, or auto [default: auto; in json all]\n\nauto takes for each shape the fewest that add no more than a tenth of its error.")),
)]
pub(crate) struct BatchArgs {
    /// The lines, one shape each; - is standard input [default: -]
    ///
    /// What a line says of its method and segments wins.
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,
    /// The format [default: by the extension of -o, else path]
    ///
    /// path, json and ps answer each line with a line; the others are one picture of all lines.
    #[arg(short, long, value_name = "F", value_parser = values::format_but_gcode(), ignore_case = true)]
    format: Option<Format>,
    #[command(flatten)]
    pub(crate) output: FileArgs,
    #[command(flatten)]
    pub(crate) talk: TalkArgs,
    #[command(flatten)]
    each: EachArgs,
    /// What becomes of a line that cannot be drawn
    ///
    /// One longer than 4 MiB ends the run in any case.
    #[arg(long, value_name = "ACTION", value_enum, default_value_t)]
    on_error: OnError,
    #[command(flatten)]
    picture: PictureArgs,
}

impl BatchArgs {
    /// How a picture of this format looks; refuses colours for what is data.
    pub(crate) fn picture(&self, format: Format) -> Result<write::Options, Failure> {
        self.picture.check(format)?;
        Ok(write::Options {
            style: self.picture.style(),
            glyph: self.output.target().glyph(),
            ..write::Options::default()
        })
    }

    pub(crate) fn options(&self) -> Result<Options, Failure> {
        let jobs = self.each.jobs.map_or_else(
            || std::thread::available_parallelism().map_or(1, usize::from),
            core::num::NonZeroUsize::get,
        );
        let format = formats::choose_but(Some(&Format::Gcode), self.format, self.output.path())?;
        if format == Format::Gcode {
            return Err(Failure::request_with_hint(
                "a batch has no G-code",
                "'curveto circle', 'curveto arc' and 'curveto path --to arcs' write it, one path at a time; batch -f dxf keeps circular arcs",
            ));
        }
        if self.on_error == OnError::Report && format != Format::Json {
            return Err(Failure::request_with_hint(
                "--on-error report answers with JSON objects",
                "add -f json, or take --on-error blank",
            ));
        }
        Ok(Options {
            format,
            rule: self.each.rule(),
            cut: self.each.cut()?,
            precision: values::rounding(self.each.precision, format),
            on_error: self.on_error,
            jobs,
            measure: self.talk.verbose,
        })
    }
}
