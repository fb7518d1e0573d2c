//! Points as text: one pair a line, or one after the other.

use std::io::{self, BufRead};

use kurbo::Point;
use thiserror::Error;

use crate::error::{Error as Refusal, finite};

/// Points, and the line of each where they came in lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Points {
    /// The points in their order.
    pub points: Vec<Point>,
    /// The line of each, counted from 1; empty for points that came one after the other.
    pub lines: Vec<usize>,
}

/// Why points cannot be read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The text itself cannot be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// It holds something else.
    #[error("{line}:{column}: {why}")]
    Syntax {
        /// The line, counted from 1.
        line: usize,
        /// The column, counted in characters from 1.
        column: usize,
        /// What stands there, without quotes around it.
        text: String,
        /// What is wrong with it.
        why: String,
    },
}

/// What is said of a word in the first line that is neither number nor name.
const NO_NAME: &str = "no name of a column: a letter, then letters, digits, _ and -, perhaps a unit in brackets; a # begins a comment";

/// The longest line: two numbers take no more.
const LONGEST_LINE: u64 = 1 << 16;

impl Points {
    /// Reads one pair a line: two numbers, quoted or not, with a comma, a semicolon, spaces or tabs between them.
    ///
    /// Blank lines and what follows a `#` are skipped, and so is a first line of names: words of letters, digits, `_` and `-` that begin
    /// with a letter, and units in brackets, quoted or not. A word such as `l0` or `O5` is a number with a typing error. Line ends are LF
    /// or CR LF.
    ///
    /// # Errors
    ///
    /// [`ReadError::Syntax`] with line and column for what is no pair of finite numbers, [`ReadError::Io`] where reading fails.
    ///
    /// ```
    /// use curveto::spline::points::Points;
    /// let read = Points::read("x,y\n0,0\n\n1.5;2  # the top\n".as_bytes())?;
    /// assert_eq!(read.points, [(0.0, 0.0).into(), (1.5, 2.0).into()]);
    /// assert_eq!(read.lines, [2, 4]);
    /// // A number that is spoiled is no name.
    /// assert!(Points::read("O.5,0\n1,1\n".as_bytes()).is_err());
    /// # Ok::<(), curveto::spline::points::ReadError>(())
    /// ```
    pub fn read(mut reader: impl BufRead) -> Result<Self, ReadError> {
        let mut read = Self::default();
        let mut bytes = Vec::new();
        let mut header_may_come = true;
        for line in 1.. {
            bytes.clear();
            if std::io::Read::take(&mut reader, LONGEST_LINE).read_until(b'\n', &mut bytes)? == 0 {
                break;
            }
            if bytes.len() as u64 == LONGEST_LINE {
                let why = format!("the line is longer than {} KiB", LONGEST_LINE >> 10);
                return Err(Flaw::of("", 1, why).at(line));
            }
            let text = String::from_utf8_lossy(&bytes);
            let text = if line == 1 {
                text.trim_start_matches('\u{feff}')
            } else {
                &text
            };
            let fields = Fields::new(text);
            match fields.pair() {
                Ok(Some(point)) => {
                    read.points.push(point);
                    read.lines.push(line);
                }
                Ok(None) => continue,
                Err(flaw) if header_may_come => fields.names(flaw).map_err(|flaw| flaw.at(line))?,
                Err(flaw) => return Err(flaw.at(line)),
            }
            header_may_come = false;
        }
        Ok(read)
    }

    /// Reads pairs one after the other: `0,0 1,2 3,1`.
    ///
    /// # Errors
    ///
    /// [`ReadError::Syntax`] with the column for what is no finite number or a coordinate that is left over.
    pub fn parse(text: &str) -> Result<Self, ReadError> {
        let mut fields = Fields::new(text);
        let mut points = Vec::new();
        let at = |flaw: Flaw| flaw.at(1);
        while let Some(x) = fields.number().map_err(at)? {
            let y = fields.number().map_err(at)?.ok_or_else(|| {
                at(fields.flaw(fields.rest, format!("point {} has no y", points.len() + 1)))
            })?;
            points.push(Point::new(x, y));
        }
        Ok(Self {
            points,
            lines: Vec::new(),
        })
    }
}

/// What is wrong in a line.
struct Flaw {
    column: usize,
    text: String,
    why: String,
}

impl Flaw {
    fn of(text: &str, column: usize, why: String) -> Self {
        let text = unquoted(text).to_owned();
        Self { column, text, why }
    }

    fn at(self, line: usize) -> ReadError {
        let Self { column, text, why } = self;
        ReadError::Syntax {
            line,
            column,
            text,
            why,
        }
    }
}

/// A field without the quotes around it.
fn unquoted(field: &str) -> &str {
    let inner = field.strip_prefix('"');
    let inner = inner.and_then(|rest| rest.strip_suffix('"'));
    inner.map_or(field, str::trim)
}

/// A name without quotes of either kind.
fn bare(field: &str) -> &str {
    let inner = field.strip_prefix('\'');
    let inner = inner.and_then(|rest| rest.strip_suffix('\''));
    inner.unwrap_or_else(|| unquoted(field))
}

/// What names are made of; accents may follow their letters.
fn is_made_of(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || ('\u{300}'..='\u{36f}').contains(&c)
}

/// Whether it has digits and is a number but for letters that look like some.
fn is_mistyped(name: &str) -> bool {
    let meant = name.replace(['O', 'o'], "0").replace(['l', 'I'], "1");
    name.contains(|c: char| c.is_ascii_digit()) && meant.parse::<f64>().is_ok()
}

/// Whether a word, perhaps with a unit after it, names a column.
fn is_name(word: &str) -> bool {
    let end = word.find(['(', '[']).unwrap_or(word.len());
    let (name, unit) = word.split_at(end);
    let is_number = is_mistyped(name) || name.parse::<f64>().is_ok();
    let is_word =
        name.starts_with(char::is_alphabetic) && name.chars().all(|c| is_made_of(c) || c == '-');
    !is_number && is_word && (unit.is_empty() || is_unit(unit))
}

/// Whether a word is a unit in brackets.
fn is_unit(word: &str) -> bool {
    let round = word
        .strip_prefix('(')
        .and_then(|rest| rest.strip_suffix(')'));
    let square = || word.strip_prefix('[')?.strip_suffix(']');
    let begins_well = |c: char| c.is_alphabetic() || "°%".contains(c);
    round
        .or_else(square)
        .is_some_and(|unit| unit.starts_with(begins_well))
}

/// The numbers of a text, which commas, semicolons or white space separate.
#[derive(Clone, Copy)]
struct Fields<'a> {
    whole: &'a str,
    rest: &'a str,
    first: bool,
}

impl<'a> Fields<'a> {
    fn new(text: &'a str) -> Self {
        let whole = text.trim_end_matches(['\n', '\r']);
        let content = whole.split('#').next().unwrap_or_default();
        Self {
            whole,
            rest: content.trim(),
            first: true,
        }
    }

    /// The next field, empty where a separator follows a separator; none at the end.
    fn next(&mut self) -> Option<&'a str> {
        if self.rest.is_empty() {
            return None;
        }
        if !core::mem::take(&mut self.first) {
            let trimmed = self.rest.trim_start();
            self.rest = trimmed
                .strip_prefix([',', ';'])
                .unwrap_or(trimmed)
                .trim_start();
        }
        // What is quoted is one field.
        let quoted = self.rest.strip_prefix('"').and_then(|rest| rest.find('"'));
        let begin = quoted.map_or(0, |length| length + 2);
        let end = self.rest[begin..]
            .find(|c: char| c == ',' || c == ';' || c.is_whitespace())
            .map_or(self.rest.len(), |length| begin + length);
        let (field, rest) = self.rest.split_at(end);
        self.rest = rest;
        Some(field)
    }

    fn number(&mut self) -> Result<Option<f64>, Flaw> {
        let Some(field) = self.next() else {
            return Ok(None);
        };
        if field.is_empty() {
            return Err(self.flaw(field, "a number is missing".to_owned()));
        }
        let value: f64 = unquoted(field).parse().map_err(|_| self.no_number(field))?;
        finite("coordinate", value)
            .map(Some)
            .map_err(|refusal| match refusal {
                Refusal::NotFinite { .. } => {
                    self.flaw(field, format!("'{field}' is not a finite number"))
                }
                other => self.flaw(field, other.to_string()),
            })
    }

    /// The two numbers of a line, or none where it has no content.
    fn pair(mut self) -> Result<Option<Point>, Flaw> {
        let Some(x) = self.number()? else {
            return Ok(None);
        };
        let Some(y) = self.number()? else {
            return Err(self.flaw(
                self.rest,
                "a point is two numbers, but this is one".to_owned(),
            ));
        };
        match self.next() {
            None => Ok(Some(Point::new(x, y))),
            Some("") => Err(self.flaw(self.rest, "no number after a separator".to_owned())),
            Some(third) => Err(self.flaw(
                third,
                "a point is two numbers, but here is a third; decimals have a point, not a comma"
                    .to_owned(),
            )),
        }
    }

    /// Whether this is a line of names; `flaw` is what is wrong with it as a point.
    fn names(mut self, flaw: Flaw) -> Result<(), Flaw> {
        let mut first = true;
        while let Some(field) = self.next() {
            // Within quotes more words may follow, with commas too.
            let mut words = bare(field).split([' ', '\t', ',', ';']);
            let begins_well = |word: &str| is_name(word) || !first && is_unit(word);
            let goes_on = |word: &str| word.chars().all(is_made_of) || is_unit(word);
            if words.next().is_some_and(begins_well) && words.all(goes_on) {
                first = false;
                continue;
            }
            let begins_a_number = |c: char| c.is_ascii_digit() || "+-.".contains(c);
            return Err(match unquoted(field) {
                // Of the numbers themselves the point says more.
                number if number.is_empty() || number.parse::<f64>().is_ok() => flaw,
                number if number.starts_with(begins_a_number) => self.no_number(field),
                name if is_mistyped(name) => self.flaw(
                    field,
                    format!("'{field}' is a number but for letters in place of 0 or 1"),
                ),
                _ => self.flaw(field, format!("'{field}' is not a number, and {NO_NAME}")),
            });
        }
        Ok(())
    }

    fn no_number(&self, field: &str) -> Flaw {
        self.flaw(field, format!("'{field}' is not a number"))
    }

    /// A flaw at a part of the text.
    fn flaw(&self, part: &str, why: String) -> Flaw {
        let offset = part.as_ptr() as usize - self.whole.as_ptr() as usize;
        let before = self.whole.get(..offset).unwrap_or_default();
        Flaw::of(part, before.chars().count() + 1, why)
    }
}
