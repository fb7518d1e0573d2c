//! Lines in, lines out: any number of shapes from a stream in bounded memory, in order, on several threads.
//!
//! Input is taken as it comes. What one read returns is answered as far as it has whole lines, and the answers are written and
//! flushed before the next read is waited for, so that a program on the other end of two pipes gets its answer at once.
//! With several threads the chunks go to them in turn and come back in turn: that alone keeps the order, and each queue holds
//! a few chunks only.

mod lines;
mod picture;
pub mod spec;

use std::io::{self, Read, Write};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread;

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
/// How many chunks wait before and after each thread.
const QUEUE: usize = 4;

/// How lines are answered.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// `Path`, `Json` or `Ps`; each answer is one line.
    pub format: Format,
    /// What gives the control points where a line names no method.
    pub rule: Rule,
    /// Where sweeps are cut where a line does not say.
    pub cut: Cut,
    /// How control points are rounded; `None` as in [`crate::approximate::Options`].
    pub precision: Option<Precision>,
    /// What becomes of a line that cannot be drawn.
    pub on_error: OnError,
    /// How many threads, at least one.
    pub jobs: usize,
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
        }
    }
}

/// What becomes of a line that cannot be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum OnError {
    /// It ends the run; the answers to all lines before it are written.
    #[default]
    Stop,
    /// It has no answer.
    Skip,
    /// Its answer is a blank line, so that the lines of output and input correspond.
    Blank,
    /// Its answer is a JSON object with the line's `id` where it has one, its number `line` and the `error`.
    Report,
}

/// How a run went.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Summary {
    /// The lines that were read, up to the one that ended the run.
    pub lines: u64,
    /// The lines that could not be drawn.
    pub failed: u64,
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
}

/// Answers every line of `input` and writes the answers to `output`; `complain` gets the number of each line that cannot be drawn.
///
/// Blank lines, and lines that begin with `#`, give a blank line.
///
/// The threads outlive the call where it ends early while `input` keeps them waiting.
///
/// # Errors
///
/// Where reading or writing fails, and [`io::ErrorKind::InvalidData`] for a line longer than 4 MiB.
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
    let mut writer = Writer {
        output,
        complain,
        stop: options.on_error == OnError::Stop,
        summary: Summary::default(),
    };
    let mut chunks = Chunks::new(input);
    if options.jobs <= 1 {
        return run_alone(&mut chunks, writer, options);
    }
    // What was written goes back to the reader, so that memory is asked for once and not a chunk.
    let (done, free) = channel::<Job>();
    // It starts first: the others may be as many as the system gives.
    let (begin, begun) = channel::<Vec<SyncSender<Job>>>();
    let reader = thread::Builder::new()
        .spawn(move || hand_out(&mut chunks, &begun.recv().unwrap_or_default(), &free))?;
    let (jobs, threads) = start_threads(options)?;
    // The reader waits for them.
    let _ = begin.send(jobs);
    let mut turn = threads.iter().cycle();
    let mut thread = turn.next();
    while let Some((results, written)) = thread
        && let Ok(job) = results.recv()
    {
        let is_last = job.is_last;
        if !writer.write(&job.answers)? {
            return Ok(writer.summary);
        }
        // At the end the thread or the reader is gone and has no use for it.
        if job.answers.text.len() > LONGEST_ANSWERS {
            drop(job.answers.text);
            let _ = written.send(());
        } else if is_last {
            let _ = done.send(job);
        }
        if is_last {
            thread = turn.next();
        }
    }
    // The queues run dry only when the reader is done.
    match reader.join() {
        Ok(done) => done.map(|()| writer.summary),
        Err(_) => Err(io::Error::other("the reading thread failed")),
    }
}

/// Answers every line in this thread.
fn run_alone<W: Write, C: FnMut(u64, &Error)>(
    chunks: &mut Chunks<impl Read>,
    mut writer: Writer<W, C>,
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

/// Reads chunks and gives them to the threads in turn, until nobody takes them.
fn hand_out(
    chunks: &mut Chunks<impl Read>,
    threads: &[SyncSender<Job>],
    free: &Receiver<Job>,
) -> io::Result<()> {
    let mut before = 0;
    for queue in threads.iter().cycle() {
        let Some(chunk) = chunks.next_chunk()? else {
            return Ok(());
        };
        let mut job = free.try_recv().unwrap_or_default();
        job.is_last = false;
        job.chunk.clear();
        job.chunk.extend_from_slice(chunk);
        job.answers.before = before;
        before += memchr::memchr_iter(b'\n', chunk).count() as u64;
        if queue.send(job).is_err() {
            return Ok(());
        }
    }
    Ok(())
}

/// A chunk and the answers to its lines, or to some of them.
#[derive(Debug, Default)]
struct Job {
    chunk: Vec<u8>,
    answers: Answers,
    /// Whether all its lines are answered.
    is_last: bool,
}

/// What comes out of a thread, and the way to say that a long one was written.
type Thread = (Receiver<Job>, Sender<()>);

/// Threads that answer chunks, as many as the system gives: one queue into each and one out of it. A thread holds no more than
/// one long part of its answers.
fn start_threads(options: &Options) -> io::Result<(Vec<SyncSender<Job>>, Vec<Thread>)> {
    let options = Arc::new(options.clone());
    let start = |_| {
        let (job, jobs) = sync_channel::<Job>(QUEUE);
        let (result, results) = sync_channel(QUEUE);
        let (written, was_written) = channel();
        let options = Arc::clone(&options);
        let work = move || {
            let mut worker = Worker::new((*options).clone());
            for job in jobs {
                if !answer(&mut worker, job, &result, &was_written) {
                    break;
                }
            }
        };
        thread::Builder::new().spawn(work)?;
        Ok((job, (results, written)))
    };
    let mut started = Vec::new();
    for thread in (0..options.jobs).map(start) {
        match thread {
            Ok(thread) => started.push(thread),
            Err(error) if started.is_empty() => return Err(error),
            Err(_) => break,
        }
    }
    Ok(started.into_iter().unzip())
}

/// Answers a chunk, in several parts where they are long. Whether someone is left to take them.
fn answer(
    worker: &mut Worker,
    mut job: Job,
    result: &SyncSender<Job>,
    was_written: &Receiver<()>,
) -> bool {
    let mut begin = 0;
    loop {
        let lines = &without_last_end(&job.chunk)[begin..];
        let left = worker.answer_some(lines, LONGEST_ANSWERS, &mut job.answers);
        let is_long = job.answers.text.len() > LONGEST_ANSWERS;
        let Some(left) = left else {
            job.is_last = true;
            return result.send(job).is_ok() && (!is_long || was_written.recv().is_ok());
        };
        begin += left;
        let before = job.answers.before + job.answers.lines;
        let part = Job {
            answers: core::mem::take(&mut job.answers),
            ..Job::default()
        };
        job.answers.before = before;
        if result.send(part).is_err() || was_written.recv().is_err() {
            return false;
        }
    }
}

/// The end of the way: writes, counts and complains.
struct Writer<W, C> {
    output: W,
    complain: C,
    stop: bool,
    summary: Summary,
}

impl<W: Write, C: FnMut(u64, &Error)> Writer<W, C> {
    /// Whether to go on.
    fn write(&mut self, answers: &Answers) -> io::Result<bool> {
        self.output.write_all(&answers.text)?;
        self.output.flush()?;
        for (line, error) in &answers.failures {
            (self.complain)(self.summary.lines + line, error);
        }
        self.summary.lines += answers.lines;
        self.summary.failed += answers.failures.len() as u64;
        Ok(!self.stop || answers.failures.is_empty())
    }
}

/// The input in whole lines, as much as a read returns at a time.
struct Chunks<R> {
    input: R,
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
        self.buffer.copy_within(self.taken..self.filled, 0);
        self.filled -= self.taken;
        self.taken = 0;
        let mut searched = 0;
        while !self.ended {
            if self.buffer.len() - self.filled < CHUNK {
                if self.filled > LONGEST_LINE {
                    return Err(io::Error::new(
                        io::ErrorKind::InvalidData,
                        "a line is longer than 4 MiB",
                    ));
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
