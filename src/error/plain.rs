//! Numbers in messages.

/// A number as people write it: with an exponent where it would be long.
pub(super) fn plain(value: f64) -> String {
    if value == 0.0 || (1e-6..1e15).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}
