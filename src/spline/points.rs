//! Points as text: one pair a line, or one after the other.

mod names;

use std::io::{self, BufRead};

use kurbo::Point;
use thiserror::Error;

use self::names::{NO_NAME, is_mistyped, is_unit, names_column, unquoted};
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

/// The longest line: two numbers take no more.
const LONGEST_LINE: usize = 1 << 16;

impl Points {
    /// Reads one pair a line: two numbers, quoted or not, with a comma, a semicolon, spaces or tabs between them.
    ///
    /// Blank lines and what follows a `#` are skipped, and so is a first line of names: words of letters, digits, `_` and `-` that begin
    /// with a letter, and units in brackets, quoted or not; a name may have more of them, as `Column 1`, where it ends at a comma, a
    /// semicolon or a tab. A word such as `l0` or `O5` is a number with a typing error. A separator may end every line. Line ends are
    /// LF, CR LF or CR.
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
        // Whether the lines end with a separator, as the first one that counts does.
        let mut separated = None;
        for line in 1.. {
            if !read_line(&mut reader, &mut bytes)? {
                break;
            }
            if bytes.len() + 1 >= LONGEST_LINE {
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
            let at = |flaw: Flaw| flaw.at(line);
            let is_separated = match fields.pair() {
                Ok(Some((point, is_separated))) => {
                    read.points.push(point);
                    read.lines.push(line);
                    is_separated
                }
                Ok(None) => continue,
                Err(flaw) if separated.is_none() => fields.names(flaw).map_err(at)?,
                Err(flaw) => return Err(at(flaw)),
            };
            if *separated.get_or_insert(is_separated) != is_separated {
                return Err(at(fields.wrongly_separated(is_separated)));
            }
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

/// Reads a line without its end, or so much of one that it is too long; whether there is one.
fn read_line(reader: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<bool> {
    line.clear();
    while line.len() < LONGEST_LINE {
        let bytes = match reader.fill_buf() {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            bytes => bytes?,
        };
        if bytes.is_empty() {
            return Ok(!line.is_empty());
        }
        let end = bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let length = end.unwrap_or(bytes.len());
        line.extend_from_slice(&bytes[..length]);
        let may_go_on = end.is_some_and(|end| bytes[end] == b'\r');
        reader.consume(length + usize::from(end.is_some()));
        if may_go_on && reader.fill_buf()?.first() == Some(&b'\n') {
            reader.consume(1);
        }
        if end.is_some() {
            break;
        }
    }
    Ok(true)
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

    /// The same of a first line that is no line of names either.
    fn of_first_line(mut self) -> Self {
        if self.why.ends_with("is not a number") || self.why.ends_with("is missing") {
            self.why += ", and the first line is neither two numbers nor the names of two columns";
        }
        self
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

/// The numbers of a text, which commas, semicolons or white space separate.
#[derive(Clone, Copy)]
struct Fields<'a> {
    whole: &'a str,
    rest: &'a str,
    first: bool,
}

impl<'a> Fields<'a> {
    fn new(text: &'a str) -> Self {
        let content = text.split('#').next().unwrap_or_default();
        Self {
            whole: text,
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

    /// The two numbers of a line and whether a separator follows them, or none where it has no content.
    fn pair(mut self) -> Result<Option<(Point, bool)>, Flaw> {
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
            None => Ok(Some((Point::new(x, y), false))),
            Some("") if self.rest.is_empty() => Ok(Some((Point::new(x, y), true))),
            Some("") => Err(self.flaw(self.rest, "no number after a separator".to_owned())),
            Some(third) => Err(self.flaw(
                third,
                "a point is two numbers, but here is a third; decimals have a point, not a comma"
                    .to_owned(),
            )),
        }
    }

    /// The fields between commas and semicolons, else between tabs, those within quotes left out; and whether one of them is the last.
    fn columns(&self) -> (Vec<&'a str>, bool) {
        let split = |separators: &[char]| -> Vec<&'a str> {
            let mut quoted = false;
            let separates = |c: char| {
                quoted ^= c == '"';
                !quoted && separators.contains(&c)
            };
            self.rest.split(separates).map(str::trim).collect()
        };
        let mut columns = split(&[',', ';']);
        if columns.len() == 1 {
            columns = split(&['\t']);
        }
        let is_separated = columns.len() > 1 && columns.last() == Some(&"");
        if is_separated {
            columns.pop();
        }
        (columns, is_separated)
    }

    /// Whether this is a line of names, and one that a separator ends; `flaw` is what is wrong with it as a point.
    fn names(mut self, flaw: Flaw) -> Result<bool, Flaw> {
        let (columns, is_separated) = self.columns();
        let is_empty = |field: &str| unquoted(field).is_empty();
        let named = columns.iter().filter(|field| names_column(field)).count();
        let unnamed = columns.iter().filter(|field| is_empty(field)).count();
        if columns.len() == 2 && named == 2 {
            return Ok(is_separated);
        }
        if columns.len() > 2 && named > 0 && named + unnamed == columns.len() {
            return Err(self.too_many(&columns));
        }
        let mut first = true;
        while let Some(field) = self.next() {
            if names_column(field) || !first && is_unit(field) {
                first = false;
                continue;
            }
            let begins_a_number = |c: char| c.is_ascii_digit() || "+-.".contains(c);
            return Err(match unquoted(field) {
                // Of the numbers themselves the point says more.
                number if number.is_empty() || number.parse::<f64>().is_ok() => {
                    flaw.of_first_line()
                }
                number if number.starts_with(begins_a_number) => self.no_number(field),
                name if is_mistyped(name) => self.flaw(
                    field,
                    format!("'{field}' is a number but for letters in place of 0 or 1"),
                ),
                _ => self.flaw(field, format!("'{field}' is not a number, and {NO_NAME}")),
            });
        }
        Ok(is_separated)
    }

    /// What is said of more than two columns, as where one of row numbers has no name.
    fn too_many(&self, columns: &[&str]) -> Flaw {
        let delimiter = [(';', " -d ';'"), (',', " -d,")];
        let delimiter = delimiter.iter().find(|(c, _)| self.rest.contains(*c));
        let delimiter = delimiter.map_or("", |(_, option)| option);
        let first = if unquoted(columns[0]).is_empty() {
            2
        } else {
            1
        };
        let why = format!(
            "the first line has {} columns, and a point is two numbers: keep two of them, as cut{delimiter} -f{first},{} does",
            columns.len(),
            first + 1
        );
        self.flaw(self.rest, why)
    }

    fn wrongly_separated(&self, is_separated: bool) -> Flaw {
        let why = if is_separated {
            "no number after a separator"
        } else {
            "the lines before end with a separator, and this one does not"
        };
        let end = &self.rest[self.rest.len()..];
        self.flaw(end, why.to_owned())
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
