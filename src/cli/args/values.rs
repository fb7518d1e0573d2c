//! Readers of single values, with messages that say what is expected.

use std::ffi::OsStr;
use std::num::{IntErrorKind, NonZeroUsize, ParseIntError};
use std::str::FromStr;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, Command, ValueEnum};
use curveto::compare::Criterion;
use curveto::error::{Error, ShapeError};
use curveto::measure::Quantity;
use curveto::number::Precision;
use curveto::picture::style::Shown;
use curveto::shape::flattens;
use curveto::spline::SplineEnds;
use curveto::write::Format;
use curveto::{Angle, Method, Tolerance};
use kurbo::{Affine, Point, Vec2};

use crate::cli::remedies;

/// Readers give clap the message; it adds the argument's name and the value.
type Read<T> = Result<T, String>;

/// The message of a library error, with its hint.
fn told(error: &Error) -> String {
    let message = remedies::message(error);
    match remedies::hint(error) {
        Some(hint) => format!("{message}\nhint: {hint}"),
        None => message,
    }
}

/// Reads what the library reads, with its message.
fn parsed<T: FromStr<Err = Error>>(text: &str) -> Read<T> {
    text.parse().map_err(|error| told(&error))
}

pub(super) fn method(text: &str) -> Read<Method> {
    parsed(text)
}

/// A reader with words that the completions of shells list.
#[derive(Clone)]
pub(super) struct Listed<T> {
    read: fn(&str) -> Read<T>,
    words: fn() -> Vec<PossibleValue>,
}

impl<T: Clone + Send + Sync + 'static> TypedValueParser for Listed<T> {
    type Value = T;

    fn parse_ref(
        &self,
        command: &Command,
        arg: Option<&Arg>,
        value: &OsStr,
    ) -> Result<T, clap::Error> {
        self.read.parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new((self.words)().into_iter()))
    }
}

/// Reads a method.
pub(super) const METHOD: Listed<Method> = Listed {
    read: method,
    words: || method_names().collect(),
};

/// Reads a list of methods, or `all`.
pub(super) const METHODS: Listed<MethodList> = Listed {
    read: methods,
    words: || {
        let all = PossibleValue::new("all").help("every method");
        std::iter::once(all).chain(method_names()).collect()
    },
};

/// Reads what `--show` takes.
pub(super) const SHOWN: Listed<Shown> = Listed {
    read: |text| {
        text.parse()
            .map_err(|error: curveto::Error| error.to_string())
    },
    words: || {
        ["joints", "handles", "truth", "error=500"]
            .map(PossibleValue::new)
            .into()
    },
};

/// Reads by what `compare` compares.
pub(super) const CRITERION: Listed<Criterion> = Listed {
    read: parsed,
    words: || {
        Criterion::ALL
            .map(|criterion| PossibleValue::new(criterion.name()))
            .into()
    },
};

/// Reads what a plot of `measure` shows.
pub(super) const QUANTITY: Listed<Quantity> = Listed {
    read: parsed,
    words: || {
        Quantity::ALL
            .map(|quantity| PossibleValue::new(quantity.name()))
            .into()
    },
};

/// Reads what holds at the ends of a spline.
pub(super) const ENDS: Listed<SplineEnds> = Listed {
    read: super::spline::ends,
    words: || {
        ["cyclic", "free", "natural", "fixed:"]
            .map(PossibleValue::new)
            .into()
    },
};

/// Reads a format of a command that cannot make G-code: typed all the same, it is told what can.
pub(super) fn format_but_gcode() -> impl TypedValueParser<Value = Format> {
    let words = Format::value_variants().iter().filter_map(|&format| {
        let word = format.to_possible_value()?;
        Some(word.hide(format == Format::Gcode))
    });
    PossibleValuesParser::new(words).try_map(|word| <Format as ValueEnum>::from_str(&word, true))
}

/// The ids of the methods and then their aliases: completions list what stands here, and no aliases of it.
fn method_names() -> impl Iterator<Item = PossibleValue> {
    let named = |name, method: Method| PossibleValue::new(name).help(method.card().title);
    let ids = Method::ALL.map(|method| named(method.id(), method));
    let others = Method::ALL.into_iter().flat_map(move |method| {
        let aliases = method.card().aliases.iter();
        aliases.map(move |&alias| named(alias, method))
    });
    ids.into_iter().chain(others)
}

/// The methods that were named; a name of its own, since clap reads a plain `Vec` value by value.
pub(super) type MethodList = Vec<Method>;

fn methods(text: &str) -> Read<MethodList> {
    if text == "all" {
        return Ok(Method::ALL.to_vec());
    }
    text.split(',').map(|name| method(name.trim())).collect()
}

pub(super) fn angle(text: &str) -> Read<Angle> {
    parsed(text)
}

pub(super) fn number(text: &str) -> Read<f64> {
    text.trim().parse().map_err(|_| {
        let what = format!("'{text}' is not a number");
        match hint_of_number(text.trim()) {
            Some(hint) => format!("{what}\nhint: {hint}"),
            None => what,
        }
    })
}

/// Reads a distance between drawings, which have no radius that a part could be of.
pub(super) fn distance(text: &str) -> Read<f64> {
    if text.trim_end().ends_with('%') {
        return Err(format!(
            "'{text}' is not a distance\nhint: a distance is in user units: two drawings have no radius that a part could be of"
        ));
    }
    number(text)
}

/// What is meant by what is almost a number.
pub(crate) fn hint_of_number(text: &str) -> Option<String> {
    const UNITS: [&str; 11] = [
        "mm", "cm", "um", "µm", "in", "pt", "px", "pc", "em", "m", "\"",
    ];
    let pointed = text.replace(',', ".");
    if pointed != text && pointed.parse::<f64>().is_ok() {
        return Some(format!("decimals come after a point: {pointed}"));
    }
    // A minus sign, an en dash and a hyphen that does not break.
    let with_minus = text.replace(['\u{2212}', '\u{2013}', '\u{2011}'], "-");
    if with_minus != text && with_minus.parse::<f64>().is_ok() {
        return Some(format!("the minus of numbers is a hyphen: {with_minus}"));
    }
    // Groups of three digits, not points of three coordinates.
    let whole = text.split('.').next().unwrap_or_default();
    let is_grouped = whole.contains(',') && whole.split(',').skip(1).all(|group| group.len() == 3);
    if is_grouped && text.replace(',', "").parse::<f64>().is_ok() {
        return Some(format!("numbers have no commas: {}", text.replace(',', "")));
    }
    if let Some(degrees) = text.strip_suffix('°') {
        return Some(format!("degrees need no unit: {degrees}"));
    }
    let unit = UNITS.iter().find_map(|unit| text.strip_suffix(unit))?;
    unit.trim().parse::<f64>().ok()?;
    Some(format!(
        "lengths are numbers in user units: {}; --size 80x60mm gives a picture its size",
        unit.trim()
    ))
}

/// A number of things.
pub(super) fn count(text: &str) -> Read<usize> {
    text.trim()
        .parse()
        .map_err(|error: ParseIntError| match error.kind() {
            IntErrorKind::PosOverflow => format!("'{text}' is too large a number"),
            _ => format!("'{text}' is not a whole number, such as 4"),
        })
}

/// A number of things of which there is at least one.
pub(super) fn count_from_one(text: &str) -> Read<NonZeroUsize> {
    NonZeroUsize::new(count(text)?).ok_or_else(|| "there is at least 1".to_owned())
}

fn pair(text: &str) -> Read<[f64; 2]> {
    match text.split(',').collect::<Vec<_>>().as_slice() {
        [x, y] => Ok([number(x)?, number(y)?]),
        _ => Err(format!(
            "'{text}' is not two numbers with a comma between them, such as 30,20"
        )),
    }
}

pub(super) fn point(text: &str) -> Read<Point> {
    pair(text).map(|[x, y]| Point::new(x, y))
}

/// Two angles with a comma between them.
pub(super) fn angles(text: &str) -> Read<[Angle; 2]> {
    let (first, second) = text
        .split_once(',')
        .ok_or_else(|| format!("'{text}' is not two angles with a comma between them"))?;
    Ok([angle(first)?, angle(second)?])
}

pub(super) fn size(text: &str) -> Read<Vec2> {
    pair(text).map(|[x, y]| Vec2::new(x, y))
}

pub(super) fn positive(text: &str) -> Read<f64> {
    match number(text)? {
        number if number.is_finite() && number > 0.0 => Ok(number),
        _ => Err(format!("'{text}' is not a positive number")),
    }
}

/// A length that is not negative.
pub(super) fn length(text: &str) -> Read<f64> {
    match number(text)? {
        length if length.is_finite() && length >= 0.0 => Ok(length),
        _ => Err("a length is a finite number of user units, at least 0".to_owned()),
    }
}

pub(super) fn tolerance(text: &str) -> Read<Tolerance> {
    text.parse().map_err(|error| match error {
        curveto::Error::Syntax { why, .. } => why,
        other => told(&other),
    })
}

/// How numbers were asked to be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PrecisionWord {
    /// With the fewest decimals that add no more than a tenth of the error.
    Auto,
    /// With this many decimals.
    Decimals(u8),
}

impl PrecisionWord {
    /// The decimals, or `None` for auto.
    pub(crate) const fn decimals(self) -> Option<u8> {
        match self {
            Self::Auto => None,
            Self::Decimals(decimals) => Some(decimals),
        }
    }

    /// The precision, or `None` for auto.
    pub(crate) fn precision(self) -> Option<Precision> {
        self.decimals().map(Precision::Fixed)
    }
}

/// How points are to be rounded: as it was asked for, else as the format wants it, else by what is drawn.
pub(super) fn rounding(asked: Option<PrecisionWord>, format: Format) -> Option<Precision> {
    asked.map_or_else(|| format.precision(), PrecisionWord::precision)
}

/// The most decimals that are taken.
pub(crate) const MOST_DECIMALS: u8 = 30;

pub(super) fn precision(text: &str) -> Read<PrecisionWord> {
    match text {
        "auto" => Ok(PrecisionWord::Auto),
        _ => match text.parse() {
            Ok(decimals @ 0..=MOST_DECIMALS) => Ok(PrecisionWord::Decimals(decimals)),
            _ => Err(format!(
                "a precision is a number of decimals from 0 to {MOST_DECIMALS}, or auto"
            )),
        },
    }
}

pub(super) fn transform(text: &str) -> Read<Affine> {
    let map = curveto::path::transform(text).map_err(|error| error.to_string())?;
    if flattens(map) {
        return Err(Error::Shape(ShapeError::Flattened).to_string());
    }
    Ok(map)
}
