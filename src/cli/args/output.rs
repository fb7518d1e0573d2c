//! The words for output.

use std::path::{Path, PathBuf};

use clap::Args;
use curveto::number::Precision;
use curveto::write::{self, Format};
use kurbo::Affine;

use super::TalkArgs;
use super::picture::PictureArgs;
use super::values::{self, PrecisionWord};
use crate::cli::failure::Failure;
use crate::cli::formats;
use crate::cli::output::OutputTarget;

/// The file that output goes to.
#[derive(Debug, Args)]
pub(crate) struct FileArgs {
    /// Write to FILE, atomically; - is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl FileArgs {
    /// Its name, where one was given.
    pub(crate) fn path(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    /// Where output goes.
    pub(crate) fn target(&self) -> OutputTarget {
        OutputTarget::new(self.path())
    }
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct OutputArgs {
    /// The format [default: by the extension of -o, else path]
    #[arg(short, long, value_name = "F", value_enum, ignore_case = true)]
    format: Option<Format>,
    #[command(flatten)]
    output: FileArgs,
    /// Decimals, or auto [default: auto; json all, glif 0]
    ///
    /// They stand after the point; auto takes the fewest that add no more than a tenth of the error.
    #[arg(short, long, value_name = "P", value_parser = values::precision, allow_hyphen_values = true)]
    precision: Option<PrecisionWord>,
    /// An SVG transform list, applied to the control points
    #[arg(long, value_name = "LIST", value_parser = values::transform, allow_hyphen_values = true)]
    transform: Option<Affine>,
    /// Relative path commands (path, svg)
    #[arg(long, hide_short_help = true)]
    relative: bool,
    /// How fast gcode moves, in units a minute
    #[arg(long, value_name = "F", hide_short_help = true, value_parser = values::positive, allow_hyphen_values = true)]
    feed: Option<f64>,
    #[command(flatten)]
    pub(crate) talk: TalkArgs,
    #[command(flatten)]
    picture: PictureArgs,
}

impl OutputArgs {
    /// Where output goes.
    pub(crate) fn target(&self) -> OutputTarget {
        self.output.target()
    }

    /// The format that was asked for, or that the extension of the output file tells.
    pub(crate) fn format(&self) -> Result<Format, Failure> {
        formats::choose(self.format, self.output.path())
    }

    /// The same for a command that makes no G-code.
    pub(crate) fn format_but_gcode(&self) -> Result<Format, Failure> {
        let format = formats::choose_but(Some(&Format::Gcode), self.format, self.output.path())?;
        if self.feed.is_some() {
            return Err(Failure::request_with_hint(
                "--feed is for gcode, which this command does not write",
                "leave it out; 'curveto path --to arcs' makes arcs of path data, for -f gcode",
            ));
        }
        Ok(format)
    }

    /// How it is to be written, where the format can do what was asked for.
    pub(crate) fn options(&self, format: Format) -> Result<write::Options, Failure> {
        let idle = |option: &str, why: &str, remedy: String| {
            let message = format!("{option} says nothing in the format {format}, {why}");
            Err(Failure::request_with_hint(
                message,
                format!("leave it out, or take {remedy}"),
            ))
        };
        if self.relative && !format.has_path_commands() {
            let why = if format == Format::Json {
                "whose path is absolute"
            } else {
                "which has no path commands of SVG"
            };
            return idle("--relative", why, "-f path or -f svg".to_owned());
        }
        if self.feed.is_some() && format != Format::Gcode {
            return idle("--feed", "which moves nothing", "-f gcode".to_owned());
        }
        self.picture.check(format)?;
        Ok(write::Options {
            style: self.picture.style(),
            relative: self.relative,
            precision: self.precision.and_then(PrecisionWord::precision),
            feed: self.feed,
            exact: false,
            glyph: self.target().glyph(),
            room: None,
        })
    }

    /// How the points are to be rounded: as it was asked for, else as the format wants it, else by what is drawn.
    pub(crate) fn rounding(&self, format: Format) -> Option<Precision> {
        values::rounding(self.precision, format)
    }

    /// The transform, or the identity.
    pub(crate) fn transform(&self) -> Affine {
        self.transform.unwrap_or_default()
    }
}
