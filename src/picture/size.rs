//! The size of a picture, in pixels, points or a length of paper.

use core::fmt;
use core::str::FromStr;

use crate::error::{Error, PictureError, Result};
use crate::number::text;

/// Pixels of CSS in an inch.
const PIXELS: f64 = 96.0;
/// Points of PostScript and PDF in an inch.
const POINTS: f64 = 72.0;

/// Width and height of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size {
    /// Its width.
    pub width: SideLength,
    /// Its height.
    pub height: SideLength,
}

/// One side of a picture, positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SideLength {
    /// How many of its unit.
    pub value: f64,
    /// Its unit.
    pub unit: Unit,
}

/// What the side of a picture is counted in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Unit {
    /// What the format counts in: pixels in PNG and SVG, points in EPS and PDF.
    #[default]
    Own,
    /// Pixels of CSS, 96 to an inch.
    Px,
    /// Millimetres.
    Mm,
    /// Centimetres.
    Cm,
    /// Inches.
    In,
    /// Points, 72 to an inch.
    Pt,
}

impl Unit {
    /// All of them; the one without a name comes last, since every number ends in it.
    const ALL: [Self; 6] = [Self::Px, Self::Mm, Self::Cm, Self::In, Self::Pt, Self::Own];

    const fn name(self) -> &'static str {
        match self {
            Self::Own => "",
            Self::Px => "px",
            Self::Mm => "mm",
            Self::Cm => "cm",
            Self::In => "in",
            Self::Pt => "pt",
        }
    }

    /// How many of it make an inch; the format's own unit has no length.
    const fn in_an_inch(self) -> Option<f64> {
        match self {
            Self::Own => None,
            Self::Px => Some(PIXELS),
            Self::Mm => Some(25.4),
            Self::Cm => Some(2.54),
            Self::In => Some(1.0),
            Self::Pt => Some(POINTS),
        }
    }
}

impl Size {
    /// Sides in what the format itself counts in.
    #[must_use]
    pub const fn plain([width, height]: [f64; 2]) -> Self {
        let unit = Unit::Own;
        Self {
            width: SideLength { value: width, unit },
            height: SideLength {
                value: height,
                unit,
            },
        }
    }

    /// Refuses sides that are not positive and finite.
    pub(crate) fn check(self) -> Result<()> {
        let values = [self.width, self.height].map(|side| side.value);
        self.check_as(|| format!("{}x{}", values[0], values[1]))
    }

    fn check_as(self, text: impl Fn() -> String) -> Result<()> {
        let is_side = |side: SideLength| side.value.is_finite() && side.value > 0.0;
        if is_side(self.width) && is_side(self.height) {
            return Ok(());
        }
        Err(Error::Picture(PictureError::Side(text())))
    }

    /// Width and height in pixels, for a format that counts in them.
    #[must_use]
    pub fn pixels(self) -> [f64; 2] {
        [self.width, self.height].map(|side| side.counted(PIXELS))
    }

    /// Width and height in points, for a format that counts in them.
    #[must_use]
    pub fn points(self) -> [f64; 2] {
        [self.width, self.height].map(|side| side.counted(POINTS))
    }
}

impl SideLength {
    /// Its length in a format that counts `own` to an inch.
    fn counted(self, own: f64) -> f64 {
        self.unit
            .in_an_inch()
            .map_or(self.value, |inch| self.value / inch * own)
    }
}

impl fmt::Display for SideLength {
    /// As SVG writes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&text(self.value))?;
        f.write_str(self.unit.name())
    }
}

impl FromStr for Size {
    type Err = Error;

    /// `WxH`, each with a unit or without; where only one has one, it is the unit of both.
    fn from_str(text: &str) -> Result<Self> {
        // An x may be that of px.
        let crosses = text.match_indices(['x', 'X', '×']);
        let mut sides = crosses.filter_map(|(at, cross)| {
            let (width, unit) = side(&text[..at])?;
            let (height, last) = side(&text[at + cross.len()..])?;
            let other = unit.or(last).unwrap_or_default();
            Some([
                (width, unit.unwrap_or(other)),
                (height, last.unwrap_or(other)),
            ])
        });
        let Some([width, height]) = sides.next_back() else {
            return Err(Error::Picture(PictureError::Size(text.to_owned())));
        };
        let [width, height] = [width, height].map(|(value, unit)| SideLength { value, unit });
        let size = Self { width, height };
        size.check_as(|| text.to_owned())?;
        Ok(size)
    }
}

/// A number and the unit after it, where there is one.
fn side(text: &str) -> Option<(f64, Option<Unit>)> {
    let text = text.trim();
    let (number, unit) = Unit::ALL
        .into_iter()
        .find_map(|unit| Some((text.strip_suffix(unit.name())?, unit)))?;
    let named = (unit != Unit::Own).then_some(unit);
    Some((number.trim_end().parse().ok()?, named))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size(text: &str) -> Size {
        text.parse().unwrap()
    }

    #[test]
    fn sides_take_units_and_share_the_last_one() {
        assert_eq!(size("640x480").pixels(), [640.0, 480.0]);
        assert_eq!(size("640x480").points(), [640.0, 480.0]);
        assert_eq!(size("25.4x50.8mm").points(), [72.0, 144.0]);
        assert_eq!(size("1inx2.54cm").pixels(), [96.0, 96.0]);
        assert_eq!(size("96pxx48px").points(), [72.0, 36.0]);
        assert_eq!(size("72 x 36 pt").pixels(), [96.0, 48.0]);
        assert_eq!(size("72ptx36").pixels(), [96.0, 48.0]);
        let sides = size("80x60.5mm");
        assert_eq!(
            [sides.width.to_string(), sides.height.to_string()],
            ["80mm", "60.5mm"]
        );
    }

    #[test]
    fn what_is_no_size_is_refused() {
        for wrong in [
            "",
            "640",
            "x",
            "10x",
            "x10",
            "10x10furlong",
            "0x10",
            "-1x5mm",
            "infx1",
            "NaNx1",
            "10mm",
            "1xx1",
        ] {
            assert!(wrong.parse::<Size>().is_err(), "{wrong}");
        }
    }
}
