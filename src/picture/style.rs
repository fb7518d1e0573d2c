//! How a picture looks: colours, widths, sizes, and what is shown beside the curve.

use core::str::FromStr;

use super::paint::Paint;
use super::size::Size;
use crate::error::{Error, PictureError, Result, finite};
use crate::number::round_one_two_five;

/// The part of the larger side that the default stroke is wide.
const STROKE_PART: f64 = 0.01;

/// How a picture looks. Lengths are in user units, as the coordinates are.
#[derive(Debug, Clone, PartialEq)]
pub struct Style {
    /// Width and height of the picture. Without it SVG, EPS and PDF are as large as their coordinates and PNG has 512 pixels on its
    /// larger side.
    pub size: Option<Size>,
    /// What curves are stroked with.
    pub stroke: Paint,
    /// How wide their stroke is; without it about 1 % of the larger side.
    pub stroke_width: Option<f64>,
    /// What curves are filled with.
    pub fill: Paint,
    /// What lies beneath everything; without it white in PNG and nothing elsewhere.
    pub background: Option<Paint>,
    /// The free space around everything that is drawn, strokes included; without it 0, or twice the default stroke where
    /// something is shown beside the curve.
    pub margin: Option<f64>,
    /// What is shown beside the curve.
    pub show: Show,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            size: None,
            stroke: Paint::BLACK,
            stroke_width: None,
            fill: Paint::None,
            background: None,
            margin: None,
            show: Show::default(),
        }
    }
}

impl Style {
    /// Refuses a size or a length of which no picture can be made.
    pub(crate) fn check(&self) -> Result<()> {
        self.size.map_or(Ok(()), Size::check)?;
        for (what, value) in [("stroke width", self.stroke_width), ("margin", self.margin)] {
            let value = value.map_or(Ok(0.0), |value| finite(what, value))?;
            if value < 0.0 {
                return Err(Error::Picture(PictureError::Length { what, value }));
            }
        }
        let factor = self.show.error.unwrap_or(1.0);
        if !is_factor(factor) {
            return Err(Error::Picture(PictureError::Factor(factor.to_string())));
        }
        finite("factor of the error", factor)?;
        Ok(())
    }
}

fn is_factor(factor: f64) -> bool {
    factor.is_finite() && factor > 0.0
}

/// The width of the stroke of a drawing whose larger side is this long: about 1 % of it, a 1, 2 or 5 with zeros.
pub(super) fn default_stroke_width(larger_side: f64) -> f64 {
    if larger_side > 0.0 && larger_side.is_finite() {
        round_one_two_five(STROKE_PART * larger_side)
    } else {
        1.0
    }
}

/// What is shown beside the curve.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Show {
    /// The joints of the segments.
    pub joints: bool,
    /// The control points off the curve, and the lines to the joints that they belong to.
    pub handles: bool,
    /// The true shape, beneath the curve.
    pub truth: bool,
    /// The deviation from the true shape, drawn this many times as large.
    pub error: Option<f64>,
}

impl Show {
    /// Whether anything is shown.
    #[must_use]
    pub fn is_any(&self) -> bool {
        *self != Self::default()
    }
}

impl Extend<Shown> for Show {
    fn extend<T: IntoIterator<Item = Shown>>(&mut self, items: T) {
        for item in items {
            match item {
                Shown::Joints => self.joints = true,
                Shown::Handles => self.handles = true,
                Shown::Truth => self.truth = true,
                Shown::Error(factor) => self.error = Some(factor),
            }
        }
    }
}

/// One thing to be shown beside the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shown {
    /// `joints`
    Joints,
    /// `handles`
    Handles,
    /// `truth`
    Truth,
    /// `error=K`, K the positive factor.
    Error(f64),
}

impl FromStr for Shown {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text.trim() {
            "joints" => return Ok(Self::Joints),
            "handles" => return Ok(Self::Handles),
            "truth" => return Ok(Self::Truth),
            "error" => {
                return Err(Error::Picture(PictureError::NoFactor));
            }
            _ => {}
        }
        let Some(factor) = text.trim().strip_prefix("error=") else {
            return Err(Error::Picture(PictureError::Shown(text.to_owned())));
        };
        match factor.trim().parse::<f64>() {
            Ok(factor) if is_factor(factor) => Ok(Self::Error(factor)),
            _ => Err(Error::Picture(PictureError::Factor(factor.to_owned()))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_stroke_is_a_round_hundredth_of_the_larger_side() {
        for (side, width) in [
            (100.0, 1.0),
            (300.0, 2.0),
            (400.0, 5.0),
            (2.0, 0.02),
            (2e6, 2e4),
            (2e-6, 2e-8),
            (0.0, 1.0),
        ] {
            assert_eq!(default_stroke_width(side), width, "{side}");
        }
    }

    #[test]
    fn what_is_shown_is_read_from_words() {
        let mut show = Show::default();
        assert!(!show.is_any());
        show.extend(
            ["joints", "truth", "error=2.5e2"]
                .iter()
                .map(|text| text.parse().unwrap()),
        );
        assert_eq!(
            show,
            Show {
                joints: true,
                handles: false,
                truth: true,
                error: Some(250.0)
            }
        );
        for wrong in [
            "joint",
            "",
            "error",
            "error=",
            "error=0",
            "error=-1",
            "error=inf",
        ] {
            assert!(wrong.parse::<Shown>().is_err(), "{wrong}");
        }
    }
}
