//! The words for output.

use std::path::{Path, PathBuf};

use clap::Args;
use curveto::number::Precision;
use curveto::picture::style::Style;
use curveto::write::Format;
use kurbo::Affine;

use super::picture::PictureArgs;
use super::values::{self, PrecisionWord};
use crate::cli::failure::Failure;
use crate::cli::output::Target;

#[derive(Debug, Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct OutputArgs {
    /// The format [default: by the extension of -o, else path] [possible values: path, svg, ps, eps, json, png]
    #[arg(short, long, value_name = "F", value_parser = |text: &str| text.parse::<Format>())]
    format: Option<Format>,
    /// Write to FILE, atomically; - is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Decimals after the point, or auto: the fewest that add no more than a tenth of the error [default: auto; in json all]
    #[arg(short, long, value_name = "P", value_parser = values::precision)]
    precision: Option<PrecisionWord>,
    /// An SVG transform list, applied to the control points
    #[arg(long, value_name = "LIST", value_parser = values::transform, allow_hyphen_values = true)]
    transform: Option<Affine>,
    /// Relative path commands (path, svg)
    #[arg(long)]
    relative: bool,
    #[command(flatten)]
    picture: PictureArgs,
}

impl OutputArgs {
    /// Where output goes.
    pub(crate) fn target(&self) -> Target {
        Target::new(self.output.as_deref())
    }

    /// The format that was asked for, or that the extension of the output file tells.
    pub(crate) fn format(&self) -> Result<Format, Failure> {
        if let Some(format) = self.format {
            return Ok(format);
        }
        let extension = self
            .output
            .as_deref()
            .and_then(Path::extension)
            .and_then(|extension| extension.to_str());
        let Some(extension) = extension.map(str::to_ascii_lowercase) else {
            return Ok(Format::default());
        };
        if [
            "jpg", "jpeg", "gif", "webp", "pdf", "tif", "tiff", "bmp", "avif", "svgz",
        ]
        .contains(&extension.as_str())
        {
            return Err(Failure::request_with_hint(
                format!("no format of ours has the extension .{extension}"),
                "the formats are path, svg, ps, eps, json and png; -f says which, whatever the name",
            ));
        }
        Ok(extension.parse().unwrap_or_default())
    }

    /// How pictures are to look, where the format can do what was asked for.
    pub(crate) fn style(&self, format: Format) -> Result<Style, Failure> {
        if self.relative && !matches!(format, Format::Path | Format::Svg) {
            return Err(Failure::request_with_hint(
                format!(
                    "--relative says nothing in the format {format}, which has no path commands of SVG"
                ),
                "leave it out, or take -f path or -f svg",
            ));
        }
        match self.picture.given() {
            Some(option) if !format.is_picture() => Err(Failure::request_with_hint(
                format!(
                    "{option} says nothing in the format {format}, which is data and no picture"
                ),
                "leave it out, or take a picture: -f svg, -f eps or -f png, or -o with such an extension",
            )),
            _ => Ok(self.picture.style(self.relative)),
        }
    }

    /// How the points are to be rounded: as it was asked for, in full for JSON, else by what is drawn.
    pub(crate) fn rounding(&self, format: Format) -> Option<Precision> {
        match self.precision {
            Some(word) => word.precision(),
            None => (format == Format::Json).then_some(Precision::Full),
        }
    }

    /// The transform, or the identity.
    pub(crate) fn transform(&self) -> Affine {
        self.transform.unwrap_or_default()
    }
}
