//! Lines in, lines out: any number of shapes from a stream in bounded memory, in order, on several threads.
//!
//! Input is taken as it comes. What one read returns is answered as far as it has whole lines, and the answers are written and
//! flushed before the next read is waited for, so that a program on the other end of two pipes gets its answer at once.
//! With several threads each takes the next chunk when it is done with one; the answers are waited for in the order of the chunks,
//! of which a few are on their way at a time.

mod lines;
mod picture;
pub mod spec;
mod threads;
mod turn;

use std::io::{self, Read, Write};

use crate::error::Error;
use crate::joints::Cut;
use crate::method::Rule;
use crate::number::Precision;
use crate::write::Format;

pub use lines::Worker;
use lines::without_last_end;
pub use picture::{MOST_SHAPES, Picture, figure};

/// How much is read at once.
const CHUNK: usize = 1 << 16;
/// The longest line.
const LONGEST_LINE: usize = 1 << 22;
/// Answers longer than this are written before the next line is answered: one may be a thousand times as long as its line.
const LONGEST_ANSWERS: usize = 1 << 20;

/// How lines are answered.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// `Path`, `Json` or `Ps`, of which each answer is one line, or that of the picture that all lines make.
    pub format: Format,
    /// What gives the control points where a line names no method.
    pub rule: Rule,
    /// Where sweeps are cut where a line does not say.
    pub cut: Cut,
    /// How control points are rounded; `None` as in [`crate::approximate::Options`].
    pub precision: Option<Precision>,
    /// What becomes of a line that cannot be drawn.
    pub on_error: OnError,
    /// How many threads, at least one; more than 256 are 256.
    pub jobs: usize,
    /// Whether [`Summary::worst`] is found; JSON and pictures state it in any case, path data and PostScript take several times as long.
    pub measure: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            format: Format::Path,
            rule: Rule::default(),
            cut: Cut::default(),
            precision: None,
            on_error: OnError::Stop,
            jobs: 1,
            measure: false,
        }
    }
}

/// What becomes of a line that cannot be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum OnError {
    /// It ends the run; the answers to all lines before it are written.
    #[default]
    Stop,
    /// It has no answer.
    Skip,
    /// Its answer is a blank line, so that the lines of output and input correspond.
    Blank,
    /// Its answer is a JSON object with the line's id where it has one, its number and the error.
    Report,
}

/// How a run went.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Summary {
    /// The lines that were read, up to the one that ended the run.
    pub lines: u64,
    /// The lines that could not be drawn.
    pub failed: u64,
    /// The largest peak error of an answer as it is written, and its line.
    pub worst: Option<Worst>,
}

/// A line, from 1, and the peak error of its answer, in user units.
pub type Worst = (u64, f64);

/// Takes up the error of one more line.
fn worsen(worst: &mut Option<Worst>, line: u64, peak: f64) {
    if worst.is_none_or(|(_, before)| peak > before) {
        *worst = Some((line, peak));
    }
}

/// The answers to the lines of one chunk.
#[derive(Debug, Default)]
pub struct Answers {
    /// As they are to be written.
    pub text: Vec<u8>,
    /// How many lines of the input stand before the chunk; set by the caller, for [`OnError::Report`].
    pub before: u64,
    /// How many lines were read.
    pub lines: u64,
    /// What could not be drawn, with its line counted from 1 within the chunk.
    pub failures: Vec<(u64, Error)>,
    /// The largest peak error that was stated or measured, with its line counted as those.
    pub worst: Option<Worst>,
}

/// Answers every line of `input` and writes the answers to `output`; `complain` gets the number of each line that cannot be drawn.
///
/// Blank lines, and lines that begin with `#`, give a blank line.
///
/// The threads outlive the call where it ends early while `input` keeps them waiting.
///
/// # Errors
///
/// Where reading or writing fails, [`io::ErrorKind::InvalidInput`] for a format whose answers are no lines, and [`io::ErrorKind::InvalidData`] for a line longer than 4 MiB, whatever [`OnError`] says: its
/// message begins with the number of the line.
///
/// ```
/// use curveto::batch::{Options, run};
/// let mut out = Vec::new();
/// let summary = run(&b"circle 0 0 50\n\narc 0 0 1 0 90\n"[..], &mut out, &Options::default(), |_, _| ())?;
/// assert_eq!(summary.lines, 3);
/// assert!(out.starts_with(b"M50 0C50 27.596 27.596 50 0 50C"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn run(
    input: impl Read + Send + 'static,
    output: impl Write,
    options: &Options,
    complain: impl FnMut(u64, &Error),
) -> io::Result<Summary> {
    if !matches!(options.format, Format::Path | Format::Json | Format::Ps) {
        let why = format!("a line holds no {}", options.format);
        return Err(io::Error::new(io::ErrorKind::InvalidInput, why));
    }
    let writer = AnswerWriter {
        output,
        complain,
        stop: options.on_error == OnError::Stop,
        summary: Summary::default(),
    };
    let mut chunks = Chunks::new(input);
    if options.jobs <= 1 {
        return run_alone(&mut chunks, writer, options);
    }
    threads::run(chunks, writer, options)
}

/// Answers every line in this thread.
fn run_alone<W: Write, C: FnMut(u64, &Error)>(
    chunks: &mut Chunks<impl Read>,
    mut writer: AnswerWriter<W, C>,
    options: &Options,
) -> io::Result<Summary> {
    let mut worker = Worker::new(options.clone());
    let mut answers = Answers::default();
    while let Some(chunk) = chunks.next_chunk()? {
        let mut lines = without_last_end(chunk);
        loop {
            answers.before = writer.summary.lines;
            let left = worker.answer_some(lines, LONGEST_ANSWERS, &mut answers);
            if !writer.write(&answers)? {
                return Ok(writer.summary);
            }
            let Some(left) = left else { break };
            lines = &lines[left..];
        }
    }
    Ok(writer.summary)
}

/// The end of the way: writes, counts and complains.
struct AnswerWriter<W, C> {
    output: W,
    complain: C,
    stop: bool,
    summary: Summary,
}

impl<W: Write, C: FnMut(u64, &Error)> AnswerWriter<W, C> {
    /// Whether to go on.
    fn write(&mut self, answers: &Answers) -> io::Result<bool> {
        self.output.write_all(&answers.text)?;
        self.output.flush()?;
        for (line, error) in &answers.failures {
            (self.complain)(self.summary.lines + line, error);
        }
        if let Some((line, peak)) = answers.worst {
            worsen(&mut self.summary.worst, self.summary.lines + line, peak);
        }
        self.summary.lines += answers.lines;
        self.summary.failed += answers.failures.len() as u64;
        Ok(!self.stop || answers.failures.is_empty())
    }
}

/// What is wrong with a line so that the run cannot go on.
fn too_much(line: u64, why: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, format!("{line}: {why}"))
}

/// The same for each kind of run.
fn too_long(line: u64) -> io::Error {
    too_much(line, "the line is longer than 4 MiB, which ends the run")
}

/// The input in whole lines, as much as a read returns at a time.
struct Chunks<R> {
    input: R,
    /// How many lines stand before those that were handed out last.
    before: u64,
    buffer: Vec<u8>,
    /// How much of the buffer is filled, and how much of that was handed out.
    filled: usize,
    taken: usize,
    begun: bool,
    ended: bool,
}

/// What some programs begin a file of UTF-8 with.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

impl<R: Read> Chunks<R> {
    fn new(input: R) -> Self {
        Self {
            input,
            before: 0,
            buffer: vec![0; 2 * CHUNK],
            filled: 0,
            taken: 0,
            begun: false,
            ended: false,
        }
    }

    /// The next whole lines; at the end a last one may lack its newline. A byte order mark at the beginning is left out.
    fn next_chunk(&mut self) -> io::Result<Option<&[u8]>> {
        let first = !core::mem::replace(&mut self.begun, true);
        let chunk = self.whole_lines()?;
        Ok(
            chunk.map(|chunk| match chunk.strip_prefix(BYTE_ORDER_MARK) {
                Some(rest) if first => rest,
                _ => chunk,
            }),
        )
    }

    fn whole_lines(&mut self) -> io::Result<Option<&[u8]>> {
        self.before += memchr::memchr_iter(b'\n', &self.buffer[..self.taken]).count() as u64;
        self.buffer.copy_within(self.taken..self.filled, 0);
        self.filled -= self.taken;
        self.taken = 0;
        let mut searched = 0;
        while !self.ended {
            if self.buffer.len() - self.filled < CHUNK {
                if self.filled > LONGEST_LINE {
                    return Err(too_long(self.before + 1));
                }
                self.buffer.resize(self.filled + 2 * CHUNK, 0);
            }
            match self.input.read(&mut self.buffer[self.filled..]) {
                Ok(0) => self.ended = true,
                Ok(count) => self.filled += count,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                Err(error) => return Err(error),
            }
            let new = &self.buffer[searched..self.filled];
            if let Some(at) = new.iter().rposition(|&byte| byte == b'\n') {
                self.taken = searched + at + 1;
                return Ok(Some(&self.buffer[..self.taken]));
            }
            searched = self.filled;
        }
        self.taken = self.filled;
        Ok((self.filled > 0).then(|| &self.buffer[..self.filled]))
    }
}

#[cfg(test)]
mod tests;
