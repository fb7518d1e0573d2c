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

impl Color {
    const fn of([red, green, blue, alpha]: [u8; 4]) -> Self {
        Self {
            red,
            green,
            blue,
            alpha,
        }
    }
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
        Self::Color(Color::of([red, green, blue, 255]))
    }

    /// The colour, where there is one that can be seen.
    #[must_use]
    pub const fn visible(self) -> Option<Color> {
        match self {
            Self::None => None,
            Self::Color(color) if color.alpha == 0 => None,
            Self::Color(color) => Some(color),
            Self::Current => Some(Color::of([0, 0, 0, 255])),
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
        let color = text.to_owned();
        parse(text).map(Self::Color).ok_or_else(|| {
            Error::Picture(match unsupported(text) {
                Some(kind) => PictureError::UnsupportedColor { color, kind },
                None => PictureError::Color(color),
            })
        })
    }
}

/// The colour spaces that `color()` takes in CSS, but not here.
const OTHER_SPACES: [&str; 5] = [
    "display-p3",
    "display-p3-linear",
    "a98-rgb",
    "prophoto-rgb",
    "rec2020",
];

/// The functions of sRGB; an older name of each ends in an a.
const OF_SRGB: [&str; 3] = ["rgb", "hsl", "hwb"];

/// Functions of sRGB and hexadecimal digits by csscolorparser; names by svgtypes, since csscolorparser's own table of them brings ten
/// crates. Colours relative to others are of CSS level 5, and csscolorparser takes some by functions of the platform.
fn parse(text: &str) -> Option<Color> {
    if let Some(parts) = color_space::parse(text) {
        return Some(Color::of(
            parts.map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8),
        ));
    }
    if let Some((name, rest)) = text.split_once('(') {
        let name = name.to_ascii_lowercase();
        let name = name.strip_suffix('a').unwrap_or(&name);
        if !OF_SRGB.contains(&name) || is_relative(rest) || !separators_agree(name, rest) {
            return None;
        }
    }
    if text.starts_with('#') || text.ends_with(')') {
        return Some(Color::of(csscolorparser::parse(text).ok()?.to_rgba8()));
    }
    let named: svgtypes::Color = text.parse().ok()?;
    Some(Color::of([named.red, named.green, named.blue, named.alpha]))
}

fn is_relative(arguments: &str) -> bool {
    let first = arguments.split_ascii_whitespace().next();
    first.is_some_and(|word| word.eq_ignore_ascii_case("from"))
}

/// Whether commas stand between all arguments or none. In the older form with commas, numbers and percentages do not mix either; csscolorparser
/// takes all of these.
fn separators_agree(name: &str, arguments: &str) -> bool {
    let arguments = arguments.trim_end_matches(')');
    if !arguments.contains(',') {
        return true;
    }
    let words: Vec<&str> = arguments.split(',').map(str::trim).collect();
    let [percent_a, percent_b, percent_c] =
        [0, 1, 2].map(|i| words.get(i).is_some_and(|word| word.ends_with('%')));
    let is_one = |word: &&str| !word.contains(|c: char| c == '/' || c.is_ascii_whitespace());
    words.iter().all(is_one)
        && match name {
            "rgb" => percent_a == percent_b && percent_b == percent_c,
            "hsl" => percent_b && percent_c,
            _ => false,
        }
}

/// What kind of colour it is that CSS has, but this does not read.
fn unsupported(text: &str) -> Option<&'static str> {
    let (name, arguments) = text.strip_suffix(')')?.split_once('(')?;
    let space = arguments.split_ascii_whitespace().next();
    match (name.to_ascii_lowercase().as_str(), space) {
        (
            "rgb" | "rgba" | "hsl" | "hsla" | "hwb" | "lab" | "lch" | "oklab" | "oklch" | "color",
            _,
        ) if is_relative(arguments) => Some("a colour relative to another"),
        ("color", Some(space)) => OTHER_SPACES
            .iter()
            .any(|other| space.eq_ignore_ascii_case(other))
            .then_some("a colour of that space"),
        ("color-mix" | "light-dark" | "contrast-color", _) => Some("a colour made of others"),
        ("device-cmyk", _) => Some("a colour of inks"),
        ("var", _) => Some("a variable"),
        ("url", _) => Some("a gradient or a pattern"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_css_has_and_is_not_drawn_is_called_so() {
        for text in [
            "color(display-p3 1 0 0)",
            "COLOR( Rec2020 1 0 0 / 50%)",
            "color(a98-rgb 0 0 0)",
            "color(prophoto-rgb 0 0 0)",
            "rgb(from lab(50 20 0) r g b)",
            "color-mix(in oklch, red, blue)",
            "light-dark(red, blue)",
            "device-cmyk(0 81% 81% 30%)",
            "var(--ink)",
            "url(#g)",
        ] {
            let said = text.parse::<Paint>().unwrap_err().to_string();
            assert!(said.contains("is not supported"), "{said}");
        }
        for wrong in ["color(srgb 1 0)", "color(nothing 1 0 0)", "color()", "a(b)"] {
            let said = wrong.parse::<Paint>().unwrap_err().to_string();
            assert!(said.contains("is not a colour"), "{said}");
        }
    }

    #[test]
    fn commas_stand_everywhere_or_nowhere() {
        for right in [
            "rgb(1,2,3)",
            "rgba( 1 , 2 ,3 , 50%)",
            "rgb(1% 2 3)",
            "rgb(1 2 3/.5)",
            "rgb(1%,2%,3%)",
            "hsl(120,50%,50%)",
            "hsl(120 50 50%)",
        ] {
            assert!(right.parse::<Paint>().is_ok(), "{right}");
        }
        for wrong in [
            "rgb(1 2,3)",
            "rgb(1,2 3)",
            "rgb(1,2,3/.5)",
            "rgb(1 2 3, .5)",
            "rgb(1,2%,3)",
            "rgb(1,2,3,)",
            "hsl(120, 50, 50)",
            "hsl(120,50% 50%)",
            "hwb(0, 100%, 0%)",
        ] {
            assert!(wrong.parse::<Paint>().is_err(), "{wrong}");
        }
    }

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
