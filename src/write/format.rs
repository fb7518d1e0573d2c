//! The names of formats, and the extensions of files that tell them.

use core::fmt;

use crate::number::Precision;

/// An output format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Format {
    /// SVG path data, one line.
    #[default]
    Path,
    /// JSON.
    Json,
    /// PostScript path operators, one a line.
    Ps,
    /// A picture, which has colours and widths.
    Image(Image),
}

/// The format of a picture: of a drawing as of a plot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Image {
    /// An SVG document.
    Svg,
    /// An Encapsulated PostScript file.
    Eps,
    /// Pixels.
    Png,
}

impl Image {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Svg, Self::Eps, Self::Png];

    /// The name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Eps => "eps",
            Self::Png => "png",
        }
    }

    /// The extensions of its files, in lower case.
    #[must_use]
    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Svg => &["svg"],
            Self::Eps => &["eps"],
            Self::Png => &["png"],
        }
    }

    /// What it is, in a few words.
    #[cfg(feature = "cli")]
    const fn about(self) -> &'static str {
        match self {
            Self::Svg => "An SVG document",
            Self::Eps => "Encapsulated PostScript",
            Self::Png => "Pixels",
        }
    }
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 6] = [
        Self::Path,
        Self::Image(Image::Svg),
        Self::Ps,
        Self::Image(Image::Eps),
        Self::Json,
        Self::Image(Image::Png),
    ];

    /// The name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Path => "path",
            Self::Json => "json",
            Self::Ps => "ps",
            Self::Image(image) => image.name(),
        }
    }

    /// The extensions of its files, in lower case.
    #[must_use]
    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Path => &["path", "txt"],
            Self::Json => &["json"],
            Self::Ps => &["ps"],
            Self::Image(image) => image.extensions(),
        }
    }

    /// Whether +y is up: on a PostScript page it is, on an SVG canvas it is down.
    #[must_use]
    pub const fn has_y_up(self) -> bool {
        matches!(self, Self::Ps | Self::Image(Image::Eps))
    }

    /// Whether closed shapes start at 180 degrees and run in the negative direction, as Lancaster's `drawellipse` does.
    #[must_use]
    pub const fn runs_as_drawellipse(self) -> bool {
        matches!(self, Self::Ps | Self::Image(Image::Eps))
    }

    /// Whether it has the path commands of SVG, which can be relative.
    #[must_use]
    pub const fn has_path_commands(self) -> bool {
        matches!(self, Self::Path | Self::Image(Image::Svg))
    }

    /// How control points are rounded where nothing was asked for; `None` for what the error of the drawing deserves.
    #[must_use]
    pub const fn precision(self) -> Option<Precision> {
        match self {
            Self::Json => Some(Precision::Full),
            _ => None,
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(feature = "cli")]
mod cli {
    use clap::ValueEnum;
    use clap::builder::PossibleValue;

    use super::{Format, Image};

    impl ValueEnum for Format {
        fn value_variants<'a>() -> &'a [Self] {
            &Self::ALL
        }

        fn to_possible_value(&self) -> Option<PossibleValue> {
            let about = match self {
                Self::Path => "SVG path data, one line",
                Self::Json => "The shape, the segments and the error; docs/schema describes it",
                Self::Ps => "PostScript path operators, one a line",
                Self::Image(image) => return image.to_possible_value(),
            };
            Some(PossibleValue::new(self.name()).help(about))
        }
    }

    impl ValueEnum for Image {
        fn value_variants<'a>() -> &'a [Self] {
            &Self::ALL
        }

        fn to_possible_value(&self) -> Option<PossibleValue> {
            Some(PossibleValue::new(self.name()).help(self.about()))
        }
    }
}
