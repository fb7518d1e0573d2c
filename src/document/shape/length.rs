//! Lengths of geometry attributes in user units.

use crate::number::decimal::Decimal;
use crate::number::decimals_for;
use crate::number::read as number;
use crate::numeric::double::Double;

/// A length: its value, and its digits as the file spells them, or some of them where it was computed.
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
    /// More than a number holds.
    TooLarge,
    /// A unit that depends on something else, a function, or no length at all.
    Unknown,
}

/// The CSS absolute units in user units, each a quotient of whole numbers.
const UNITS: [(&str, [f64; 2]); 7] = [
    ("px", [1.0, 1.0]),
    ("in", [96.0, 1.0]),
    ("cm", [4800.0, 127.0]),
    ("mm", [480.0, 127.0]),
    ("q", [120.0, 127.0]),
    ("pt", [4.0, 3.0]),
    ("pc", [16.0, 1.0]),
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

    /// What the digits leave out of the value.
    fn rest(self) -> f64 {
        self.value - self.exact.value()
    }

    /// With so many decimals at least, where the digits leave something out and there is room for more.
    pub(in crate::document) fn with_decimals(self, decimals: u32) -> Self {
        if self.rest() == 0.0 || decimals <= self.exact.decimals {
            return self;
        }
        Self {
            exact: Decimal::round(self.value, decimals),
            ..self
        }
    }

    pub(in crate::document) fn minus(self, other: Self) -> Self {
        let exact = self.exact.minus(other.exact);
        Self {
            value: exact.value() + (self.rest() - other.rest()),
            exact,
        }
    }

    pub(in crate::document) fn plus(self, other: Self) -> Self {
        self.minus(Self {
            value: -other.value,
            exact: other.exact.negated(),
        })
    }
}

/// Reads the value of a geometry attribute.
pub(in crate::document) fn read(text: &str) -> LengthAttribute {
    let text = text.trim_matches([' ', '\t', '\n', '\r', '\x0c']);
    if text == "auto" {
        return LengthAttribute::Auto;
    }
    let Some((value, end)) = number::read(text.as_bytes(), 0) else {
        return LengthAttribute::Unknown;
    };
    if !value.is_finite() {
        return LengthAttribute::TooLarge;
    }
    let unit = &text[end..];
    if unit.is_empty() || unit.eq_ignore_ascii_case("px") {
        let exact = Decimal::read(&text[..end]).unwrap_or(Length::computed(value).exact);
        return LengthAttribute::Length(Length { value, exact });
    }
    match UNITS
        .iter()
        .find(|(name, _)| name.eq_ignore_ascii_case(unit))
    {
        Some((_, [of, over])) => {
            let exact = Double::of(value).scaled(*of).over(*over).value();
            // Of what leaves the range no digit counts.
            let value = if exact.is_finite() {
                exact
            } else {
                value * (of / over)
            };
            LengthAttribute::Length(Length::computed(value))
        }
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
        assert_eq!(value("1e308mm"), Some(f64::INFINITY));
        assert!(value("1e306mm").is_some_and(|value| value > 3.7e306));
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
        assert_eq!(read("-1e400px"), LengthAttribute::TooLarge);
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
