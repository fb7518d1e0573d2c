//! Colours.

use core::str::FromStr;

use super::color_space;
use crate::error::{Error, PictureError, Result};

/// A colour of sRGB, in bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Color {
    /// How red it is.
    pub red: u8,
    /// How green it is.
    pub green: u8,
    /// How blue it is.
    pub blue: u8,
    /// How opaque it is: 0 is not seen at all.
    pub alpha: u8,
}

/// A colour, or nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Paint {
    /// Nothing is painted.
    #[default]
    None,
    /// This colour.
    Color(Color),
    /// The colour of the text around an SVG drawing, where it has one; black elsewhere.
    Current,
}

impl Paint {
    /// Opaque black.
    pub const BLACK: Self = Self::rgb(0, 0, 0);
    /// Opaque white.
    pub const WHITE: Self = Self::rgb(255, 255, 255);

    /// An opaque colour.
    #[must_use]
    pub const fn rgb(red: u8, green: u8, blue: u8) -> Self {
        Self::Color(Color {
            red,
            green,
            blue,
            alpha: 255,
        })
    }

    /// The colour, where there is one that can be seen.
    #[must_use]
    pub const fn visible(self) -> Option<Color> {
        match self {
            Self::None => None,
            Self::Color(color) if color.alpha == 0 => None,
            Self::Color(color) => Some(color),
            Self::Current => Some(Color {
                red: 0,
                green: 0,
                blue: 0,
                alpha: 255,
            }),
        }
    }
}

/// The one name that CSS Color 4 adds to those of CSS Color 3, which svgtypes has.
const REBECCA_PURPLE: Paint = Paint::rgb(0x66, 0x33, 0x99);

impl FromStr for Paint {
    type Err = Error;

    /// A colour of CSS level 4: a name, `#rgb`, `#rrggbb`, with alpha too, `rgb()`, `hsl()`, `hwb()`, `lab()`, `lch()`, `oklab()`,
    /// `oklch()`, `color()` of `srgb`, `srgb-linear` or `xyz`, `currentColor`; or `none`, or `transparent`.
    fn from_str(text: &str) -> Result<Self> {
        let text = text.trim();
        let is = |word: &str| text.eq_ignore_ascii_case(word);
        if is("none") || is("transparent") {
            return Ok(Self::None);
        }
        if is("currentcolor") {
            return Ok(Self::Current);
        }
        if is("rebeccapurple") {
            return Ok(REBECCA_PURPLE);
        }
        parse(text)
            .map(Self::Color)
            .ok_or_else(|| Error::Picture(PictureError::Color(text.to_owned())))
    }
}

/// The functions of sRGB; an older name of each ends in an a.
const OF_SRGB: [&str; 3] = ["rgb", "hsl", "hwb"];

/// Functions of sRGB and hexadecimal digits by csscolorparser; names by svgtypes, since csscolorparser's own table of them brings ten
/// crates. Colours relative to others are of CSS level 5, and csscolorparser takes some by functions of the platform.
fn parse(text: &str) -> Option<Color> {
    if let Some(parts) = color_space::parse(text) {
        let [red, green, blue, alpha] =
            parts.map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8);
        return Some(Color {
            red,
            green,
            blue,
            alpha,
        });
    }
    if let Some((name, rest)) = text.split_once('(') {
        let name = name.to_ascii_lowercase();
        let name = name.strip_suffix('a').unwrap_or(&name);
        let is_relative = rest.trim_start().to_ascii_lowercase().starts_with("from");
        if !OF_SRGB.contains(&name) || is_relative {
            return None;
        }
    }
    if text.starts_with('#') || text.ends_with(')') {
        let [red, green, blue, alpha] = csscolorparser::parse(text).ok()?.to_rgba8();
        return Some(Color {
            red,
            green,
            blue,
            alpha,
        });
    }
    let svgtypes::Color {
        red,
        green,
        blue,
        alpha,
    } = text.parse().ok()?;
    Some(Color {
        red,
        green,
        blue,
        alpha,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_those_of_css_and_none() {
        let paint = |text: &str| text.parse::<Paint>();
        let translucent = |red, green, blue, alpha| {
            Ok(Paint::Color(Color {
                red,
                green,
                blue,
                alpha,
            }))
        };
        assert_eq!(paint("none"), Ok(Paint::None));
        assert_eq!(paint("Transparent"), Ok(Paint::None));
        assert_eq!(paint("currentColor"), Ok(Paint::Current));
        assert_eq!(paint("black"), Ok(Paint::BLACK));
        assert_eq!(paint(" #fff "), Ok(Paint::WHITE));
        assert_eq!(paint("RebeccaPurple"), Ok(REBECCA_PURPLE));
        assert_eq!(paint("#663399"), Ok(REBECCA_PURPLE));
        assert_eq!(paint("rgb(0, 158, 115)"), Ok(Paint::rgb(0, 158, 115)));
        assert_eq!(paint("rgb(0 158 115)"), Ok(Paint::rgb(0, 158, 115)));
        assert_eq!(paint("rgb(255 0 0 / 50%)"), translucent(255, 0, 0, 128));
        assert_eq!(paint("#f008"), translucent(255, 0, 0, 0x88));
        assert_eq!(paint("hsl(120deg 100% 25%)"), Ok(Paint::rgb(0, 128, 0)));
        assert_eq!(paint("hwb(0 100% 0%)"), Ok(Paint::WHITE));
        // As the specification's own example has it: rebeccapurple is oklch(44.027% 0.1603 303.37).
        assert_eq!(paint("oklch(44.027% 0.1603 303.37)"), Ok(REBECCA_PURPLE));
        for wrong in [
            "blak",
            "#12",
            "",
            "#ggg",
            "rgb(1,2",
            "red red",
            "beef",
            "rgb(1 2)",
            "rgb(from lab(50 20 0) r g b)",
            "hsv(0 100% 100%)",
        ] {
            assert!(paint(wrong).is_err(), "{wrong}");
        }
    }
}
