//! Lengths of geometry attributes in user units.

use crate::number::decimal::Decimal;
use crate::number::decimals_for;
use crate::number::read as number;

/// A length: its value, and its digits as the file spells them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::document) struct Length {
    pub(in crate::document) value: f64,
    pub(in crate::document) exact: Decimal,
}

/// What an attribute says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::document) enum LengthAttribute {
    Length(Length),
    /// The keyword `auto`.
    Auto,
    /// A unit that depends on something else, a function, or no length at all.
    Unknown,
}

/// The CSS absolute units in user units.
const UNITS: [(&str, f64); 7] = [
    ("px", 1.0),
    ("in", 96.0),
    ("cm", 96.0 / 2.54),
    ("mm", 96.0 / 25.4),
    ("q", 96.0 / 101.6),
    ("pt", 96.0 / 72.0),
    ("pc", 16.0),
];

impl Length {
    /// A value that was computed.
    pub(in crate::document) fn computed(value: f64) -> Self {
        Self {
            value,
            exact: Decimal::round(value, decimals_for(value, 14)),
        }
    }

    pub(in crate::document) fn zero() -> Self {
        Self {
            value: 0.0,
            exact: Decimal::ZERO,
        }
    }
}

/// Reads the value of a geometry attribute.
pub(in crate::document) fn read(text: &str) -> LengthAttribute {
    let text = text.trim_matches([' ', '\t', '\n', '\r', '\x0c']);
    if text == "auto" {
        return LengthAttribute::Auto;
    }
    let Some((value, end)) =
        number::read(text.as_bytes(), 0).filter(|(value, _)| value.is_finite())
    else {
        return LengthAttribute::Unknown;
    };
    let unit = &text[end..];
    if unit.is_empty() || unit.eq_ignore_ascii_case("px") {
        let exact = Decimal::read(&text[..end]).unwrap_or(Length::computed(value).exact);
        return LengthAttribute::Length(Length { value, exact });
    }
    match UNITS
        .iter()
        .find(|(name, _)| name.eq_ignore_ascii_case(unit))
    {
        Some((_, factor)) => LengthAttribute::Length(Length::computed(value * factor)),
        None => LengthAttribute::Unknown,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> Option<f64> {
        match read(text) {
            LengthAttribute::Length(length) => Some(length.value),
            _ => None,
        }
    }

    #[test]
    fn absolute_units_resolve_and_others_do_not() {
        assert_eq!(value(" 12.5px "), Some(12.5));
        assert_eq!(value("1IN"), Some(96.0));
        assert_eq!(value("25.4mm"), Some(96.0));
        assert_eq!(value("1e2"), Some(100.0));
        assert_eq!(value("72pt"), Some(96.0));
        for text in [
            "50%",
            "2em",
            "calc(1px)",
            "var(--r)",
            "",
            "5 5",
            "inherit",
            "1vw",
            "1.",
        ] {
            assert_eq!(read(text), LengthAttribute::Unknown, "{text}");
        }
        assert_eq!(read("auto"), LengthAttribute::Auto);
    }

    #[test]
    fn what_is_computed_has_at_most_fifteen_digits() {
        for text in ["1mm", "7.3cm", "1000pt", "12345678.9mm", ".0001q"] {
            let LengthAttribute::Length(length) = read(text) else {
                panic!("{text}")
            };
            assert!(
                length.exact.units.unsigned_abs() < 1_000_000_000_000_000,
                "{text}"
            );
        }
    }
}
