//! The characters of a document.

pub(in crate::document) const BYTE_ORDER_MARK: char = '\u{feff}';

/// The first character that XML 1.0 forbids.
pub(in crate::document) fn first_forbidden(text: &str) -> Option<usize> {
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

/// The text of a fragment of a URL, `%41` read as `A`; what is not UTF-8 then stays as it is.
pub(in crate::document) fn percent_decoded(text: &str) -> String {
    let bytes = text.as_bytes();
    let digit = |at: usize| bytes.get(at).and_then(|byte| (*byte as char).to_digit(16));
    let (mut out, mut at) = (Vec::with_capacity(bytes.len()), 0);
    while let Some(byte) = bytes.get(at) {
        let decoded = match (byte, digit(at + 1), digit(at + 2)) {
            (b'%', Some(high), Some(low)) => Some((16 * high + low) as u8),
            _ => None,
        };
        out.push(decoded.unwrap_or(*byte));
        at += if decoded.is_some() { 3 } else { 1 };
    }
    String::from_utf8(out).unwrap_or_else(|_| text.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percent_signs_decode_where_they_can() {
        assert_eq!(percent_decoded("a%20b%C3%a9"), "a bé");
        assert_eq!(percent_decoded("100%%4"), "100%%4");
        assert_eq!(percent_decoded("%ff"), "%ff");
    }

    #[test]
    fn forbidden_characters_are_found_however_many_there_are() {
        for (text, at) in [
            ("a\tb\n\r", None),
            ("a\u{1}", Some(1)),
            ("a\u{1}\u{1}", Some(1)),
            ("\u{feff}é\u{ffff}\u{ffff}", Some(5)),
            ("\u{feff}\u{feff}", None),
            ("ab\u{fffe}", Some(2)),
        ] {
            assert_eq!(first_forbidden(text), at, "{text:?}");
        }
    }
}
