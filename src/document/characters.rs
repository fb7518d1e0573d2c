//! The characters of a document.

pub(super) const BYTE_ORDER_MARK: char = '\u{feff}';

/// The first character that XML 1.0 forbids.
pub(super) fn first_forbidden(text: &str) -> Option<usize> {
    // The first byte of U+FFFE and U+FFFF, among others.
    const HIGHEST: u8 = 0xef;
    let control = |b: u8| b < 0x20 && b != b'\t' && b != b'\n' && b != b'\r';
    let suspect = |b: u8| control(b) || b == HIGHEST;
    // One branch-free pass; the place is looked for only where there may be one.
    let may_be = text
        .as_bytes()
        .iter()
        .fold(false, |some, &b| some | suspect(b));
    if !may_be {
        return None;
    }
    text.bytes()
        .position(control)
        .or_else(|| text.find(['\u{fffe}', '\u{ffff}']))
}
