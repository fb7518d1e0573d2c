//! Numbers in messages.

/// A number as people write it: with an exponent where it would be long.
pub(super) fn plain(value: f64) -> String {
    if value == 0.0 || (1e-6..1e15).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// A number without the last digits, in which what a computation leaves would show.
pub(super) fn short(value: f64) -> f64 {
    format!("{value:.12e}").parse().unwrap_or(value)
}

/// A number that may not be finite: what is read as infinite may be written with digits.
pub(super) fn told(value: f64) -> String {
    if value.is_infinite() {
        format!("{value}: infinite or too large")
    } else {
        value.to_string()
    }
}
