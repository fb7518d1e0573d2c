//! Legacy encodings that hold ASCII as it is: their files are converted byte for byte, without being decoded.

use std::borrow::Cow;

/// What is read: a text, or a text that stands for bytes in a declared encoding.
#[derive(Debug, Clone, Copy)]
pub(in crate::document) struct SourceText<'a> {
    pub(in crate::document) text: &'a str,
    /// Whether the text is [`widen`]ed.
    pub(in crate::document) is_widened: bool,
}

impl<'a> From<&'a str> for SourceText<'a> {
    fn from(text: &'a str) -> Self {
        Self {
            text,
            is_widened: false,
        }
    }
}

/// A byte beyond ASCII stands as the character of this number more, a letter, which XML takes anywhere and CSS does not mind.
const BASE: u32 = 0x100;

/// Whether every ASCII byte of a file in this encoding is that character, and never a part of another one. (Those of Shift-JIS, Big5,
/// GBK and UTF-7 may be.)
pub(in crate::document) fn keeps_ascii(name: &str) -> bool {
    const NAMES: [&str; 20] = [
        "latin1",
        "latin-1",
        "l1",
        "cp819",
        "ansi_x3.4-1968",
        "iso8859-1",
        "iso_8859-1",
        "iso8859-15",
        "koi8-r",
        "koi8-u",
        "koi8-ru",
        "macintosh",
        "x-mac-roman",
        "mac",
        "ibm866",
        "cp866",
        "tis-620",
        "euc-jp",
        "euc-kr",
        "gb2312",
    ];
    const FAMILIES: [&str; 4] = ["iso-8859-", "windows-125", "cp125", "x-cp125"];
    let name = name.to_ascii_lowercase();
    let of_family = |family: &&str| {
        name.strip_prefix(family)
            .is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
    };
    NAMES.contains(&name.as_str()) || FAMILIES.iter().any(of_family)
}

/// The bytes as a text of as many characters.
pub(in crate::document) fn widen(bytes: &[u8]) -> String {
    bytes
        .iter()
        .filter_map(|&byte| {
            let base = if byte.is_ascii() { 0 } else { BASE };
            char::from_u32(u32::from(byte) + base)
        })
        .collect()
}

/// What can be compared of a name in a widened text. References, escapes of CSS and `%E9` give characters where the text has bytes,
/// and how many bytes a character has is not known: whatever stands beyond ASCII counts as the same. Names that are equal stay so.
pub(in crate::document) fn folded(name: &str) -> String {
    let (mut out, mut is_beyond) = (String::with_capacity(name.len()), false);
    for character in name.chars() {
        if character.is_ascii() {
            out.push(character);
        } else if !is_beyond {
            out.push(char::REPLACEMENT_CHARACTER);
        }
        is_beyond = !character.is_ascii();
    }
    out
}

/// The bytes for which a widened text stands.
pub(in crate::document) fn narrow(text: &str) -> Cow<'static, [u8]> {
    // Without BASE, which is the ninth bit.
    let byte = |character: char| u32::from(character) as u8;
    Cow::Owned(text.chars().map(byte).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_comes_back() {
        let bytes: Vec<u8> = (0..=255).collect();
        let text = widen(&bytes);
        assert_eq!(text.chars().count(), 256);
        assert_eq!(narrow(&text), bytes);
        assert!(text.chars().skip(128).all(char::is_alphabetic));
    }

    #[test]
    fn names_beyond_ascii_are_one() {
        assert_eq!(folded("a-\u{1e9}b"), folded("a-éb"));
        assert_eq!(folded("\u{1c3}\u{1a9}"), folded("é"));
        assert_ne!(folded("éa"), folded("éb"));
        assert_eq!(folded("a b"), "a b");
    }

    #[test]
    fn encodings_are_known_by_their_names() {
        for name in ["ISO-8859-1", "windows-1251", "Latin1", "EUC-JP", "koi8-r"] {
            assert!(keeps_ascii(name), "{name}");
        }
        for name in [
            "Shift_JIS",
            "UTF-16",
            "utf-7",
            "Big5",
            "GBK",
            "iso-8859-",
            "ibm037",
            "iso-2022-jp",
        ] {
            assert!(!keeps_ascii(name), "{name}");
        }
    }
}
