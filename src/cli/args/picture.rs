//! The words for pictures.

use clap::{ArgAction, Args};
use curveto::picture::paint::Paint;
use curveto::picture::size::Size;
use curveto::picture::style::{Show, Shown, Style};
use curveto::write::{Format, Image};

use super::values;
use crate::cli::failure::Failure;
use crate::cli::formats;

/// How pictures look.
#[derive(Debug, Args)]
#[command(next_help_heading = "Pictures (svg, eps, png, pdf)")]
pub(crate) struct PictureArgs {
    /// Size, such as 512x512 or 80x60mm
    ///
    /// Without a unit it is pixels in png and svg, points in eps and pdf; units are mm, cm, in and pt. The drawing fits into its middle. [default: in png 512 on the larger side]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    size: Option<Size>,
    /// Colour of the curve [default: black]
    ///
    /// A CSS colour, currentColor or none.
    #[arg(long, value_name = "COLOR")]
    stroke: Option<Paint>,
    /// Width of the stroke in user units [default: about 1 % of the larger side]
    #[arg(long, value_name = "W", hide_short_help = true, value_parser = values::length, allow_hyphen_values = true)]
    stroke_width: Option<f64>,
    /// Colour of the inside [default: none]
    ///
    /// A CSS colour or none.
    #[arg(long, value_name = "COLOR")]
    fill: Option<Paint>,
    /// Colour beneath everything: a CSS colour or none [default: white in png, else none]
    #[arg(long, value_name = "COLOR", hide_short_help = true)]
    background: Option<Paint>,
    /// Free space around all that is drawn, strokes included, in user units [default: 0, with --show about 2 % of the larger side]
    #[arg(long, value_name = "M", hide_short_help = true, value_parser = values::length, allow_hyphen_values = true)]
    margin: Option<f64>,
    /// Show joints, handles, truth or error=K with the curve
    ///
    /// Any of them, with commas between; truth is the true shape beneath; error=K the deviation drawn K times as large, orange outside and blue inside.
    #[arg(long, value_name = "WHAT,...", value_delimiter = ',', value_parser = values::SHOWN, hide_possible_values = true, action = ArgAction::Set)]
    show: Vec<Shown>,
}

impl PictureArgs {
    /// How the picture is to look.
    pub(super) fn style(&self) -> Style {
        let default = Style::default();
        let mut show = Show::default();
        show.extend(self.show.iter().copied());
        Style {
            size: self.size,
            stroke: self.stroke.unwrap_or(default.stroke),
            stroke_width: self.stroke_width,
            fill: self.fill.unwrap_or(default.fill),
            background: self.background,
            margin: self.margin,
            show,
        }
    }

    /// Refuses the options where the format is no picture.
    pub(super) fn check(&self, format: Format) -> Result<(), Failure> {
        match self.given() {
            Some(option) if !matches!(format, Format::Image(_)) => {
                let images = formats::list::<Image>();
                Err(Failure::request_with_hint(
                    format!(
                        "{option} says nothing in the format {format}, which is data and no picture"
                    ),
                    format!(
                        "leave it out, or take a picture with -f or the extension of -o: {images}"
                    ),
                ))
            }
            _ => Ok(()),
        }
    }

    /// The first option that was given.
    fn given(&self) -> Option<&'static str> {
        [
            (self.size.is_some(), "--size"),
            (self.stroke.is_some(), "--stroke"),
            (self.stroke_width.is_some(), "--stroke-width"),
            (self.fill.is_some(), "--fill"),
            (self.background.is_some(), "--background"),
            (self.margin.is_some(), "--margin"),
            (!self.show.is_empty(), "--show"),
        ]
        .into_iter()
        .find_map(|(given, name)| given.then_some(name))
    }
}
