//! What kind of drawing an input is, by its name and its bytes.

use std::ffi::OsStr;
use std::path::Path;

/// The kinds of drawings that commands read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum InputKind {
    Svg,
    Json,
    PostScript,
    PathData,
    Unknown,
}

impl InputKind {
    /// The kind of these bytes, which `words` name.
    pub(crate) fn of(words: &OsStr, bytes: &[u8]) -> Self {
        let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
        let is_operator = |word: &[u8]| [&b"moveto"[..], b"arc", b"arcn"].contains(&word);
        let mut tokens = bytes.split(u8::is_ascii_whitespace);
        // A matrix, a dictionary or a string may stand first in PostScript.
        match bytes.trim_ascii_start() {
            [b'{', ..] => Self::Json,
            _ if is_postscript_name(words) => Self::PostScript,
            [b'%', ..] | [b'<', b'<' | b'~' | b'0'..=b'9', ..] => Self::PostScript,
            [b'<', ..] => Self::Svg,
            _ if tokens.any(is_operator) => Self::PostScript,
            [b'[', ..] => Self::Json,
            [b'M' | b'm', ..] => Self::PathData,
            _ => Self::Unknown,
        }
    }

    /// What to do about it where another kind was expected: `svg` or `path_data` where it is such.
    pub(crate) const fn remedy(
        self,
        svg: Option<&'static str>,
        path_data: Option<&'static str>,
    ) -> Option<&'static str> {
        match self {
            Self::Svg => svg,
            Self::PathData => path_data,
            Self::Unknown => None,
            Self::PostScript => Some("'curveto diff' reads PostScript drawings"),
            Self::Json => {
                Some("JSON holds path data under its key path, and 'curveto diff' reads it whole")
            }
        }
    }
}

fn is_postscript_name(words: &OsStr) -> bool {
    let ending = Path::new(words).extension();
    ending.is_some_and(|e| e.eq_ignore_ascii_case("ps") || e.eq_ignore_ascii_case("eps"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_is_known_by_its_first_bytes_and_its_name() {
        for (name, text, kind) in [
            ("-", "\u{feff} <svg/>", InputKind::Svg),
            ("-", "<!-- 1 0 moveto -->", InputKind::Svg),
            ("-", "<< /a 1 >> pop 0 0 moveto", InputKind::PostScript),
            ("-", "\n<~ab~> pop", InputKind::PostScript),
            ("-", "<61> pop", InputKind::PostScript),
            ("a.EPS", "<ab> pop", InputKind::PostScript),
            (
                "-",
                "[1 0 0 1 0 0] concat 0 0 moveto",
                InputKind::PostScript,
            ),
            ("-", "%!PS", InputKind::PostScript),
            ("-", "[{}]", InputKind::Json),
            ("-", "{\"title\": \"a moveto b\"}", InputKind::Json),
            ("-", "M0 0L1 1", InputKind::PathData),
            ("-", "", InputKind::Unknown),
        ] {
            assert_eq!(
                InputKind::of(OsStr::new(name), text.as_bytes()),
                kind,
                "{text}"
            );
        }
    }
}
