//! Chunks of lines answered by several threads, in order.

use std::io::{self, Read, Write};
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex};
use std::thread;

use super::lines::{Worker, without_last_end};
use super::{AnswerWriter, Answers, Chunks, LONGEST_ANSWERS, Options, Summary};
use crate::error::Error;

/// How many chunks are on their way for each thread.
const QUEUE: usize = 3;

/// The most threads, however many are asked for.
const MOST_JOBS: usize = 256;

/// A chunk, or its answers, or some of them.
#[derive(Debug, Default)]
struct Job {
    chunk: Vec<u8>,
    answers: Answers,
    /// Whether all its lines are answered.
    is_last: bool,
}

/// A thread's end of what becomes of one chunk.
struct Task {
    job: Job,
    parts: SyncSender<Job>,
    was_written: Receiver<()>,
}

/// The writer's end: the parts of the answers, and the way to say that a long one was written.
struct WriterEnd {
    parts: Receiver<Job>,
    written: Sender<()>,
}

/// Where the reader puts chunks: for the thread that is free first, and in their order for the writer.
struct Queues {
    tasks: SyncSender<Task>,
    outcomes: SyncSender<WriterEnd>,
}

/// As [`super::run`] on several threads.
pub(super) fn run<W: Write, C: FnMut(u64, &Error)>(
    mut chunks: Chunks<impl Read + Send + 'static>,
    mut writer: AnswerWriter<W, C>,
    options: &Options,
) -> io::Result<Summary> {
    // What was written goes back to the reader, so that memory is asked for once and not a chunk.
    let (done, free) = channel();
    // It starts first: the others may be as many as the system gives.
    let (begin, begun) = channel();
    let reader = thread::Builder::new().spawn(move || match begun.recv() {
        Ok(queues) => hand_out(&mut chunks, &queues, &free),
        Err(_) => Ok(()),
    })?;
    let (queues, outcomes) = start_threads(options)?;
    // The reader waits for them.
    let _ = begin.send(queues);
    for outcome in outcomes {
        loop {
            let Ok(job) = outcome.parts.recv() else {
                return Err(io::Error::other("an answering thread failed"));
            };
            if !writer.write(&job.answers)? {
                return Ok(writer.summary);
            }
            let is_last = job.is_last;
            // At the end the thread or the reader is gone and has no use for it.
            if job.answers.text.len() > LONGEST_ANSWERS {
                drop(job);
                let _ = outcome.written.send(());
            } else if is_last {
                let _ = done.send(job);
            }
            if is_last {
                break;
            }
        }
    }
    // The queues run dry only when the reader is done.
    match reader.join() {
        Ok(done) => done.map(|()| writer.summary),
        Err(_) => Err(io::Error::other("the reading thread failed")),
    }
}

/// Reads chunks and queues them, until nobody takes them.
fn hand_out(
    chunks: &mut Chunks<impl Read>,
    queues: &Queues,
    free: &Receiver<Job>,
) -> io::Result<()> {
    while let Some(chunk) = chunks.next_chunk()? {
        let mut job = free.try_recv().unwrap_or_default();
        job.is_last = false;
        job.chunk.clear();
        job.chunk.extend_from_slice(chunk);
        job.answers.before = chunks.before;
        let (parts, answers) = sync_channel(1);
        let (written, was_written) = channel();
        let outcome = WriterEnd {
            parts: answers,
            written,
        };
        let task = Task {
            job,
            parts,
            was_written,
        };
        if queues.outcomes.send(outcome).is_err() || queues.tasks.send(task).is_err() {
            break;
        }
    }
    Ok(())
}

/// Threads that answer chunks, as many as the system gives. A thread holds no more than one long part of its answers.
fn start_threads(options: &Options) -> io::Result<(Queues, Receiver<WriterEnd>)> {
    let jobs = options.jobs.min(MOST_JOBS);
    let (tasks, waiting) = sync_channel::<Task>(QUEUE * jobs);
    let waiting = Arc::new(Mutex::new(waiting));
    let options = Arc::new(options.clone());
    let mut started = 0;
    for _ in 0..jobs {
        let (waiting, options) = (Arc::clone(&waiting), Arc::clone(&options));
        let work = move || {
            let mut worker = Worker::new((*options).clone());
            // The lock is held while there is nothing to do, and let go with the task.
            while let Ok(Ok(task)) = waiting.lock().map(|waiting| waiting.recv()) {
                if !answer(&mut worker, task) {
                    break;
                }
            }
        };
        match thread::Builder::new().spawn(work) {
            Ok(_) => started += 1,
            Err(error) if started == 0 => return Err(error),
            Err(_) => break,
        }
    }
    let (outcomes, in_order) = sync_channel(QUEUE * started);
    Ok((Queues { tasks, outcomes }, in_order))
}

/// Answers a chunk, in several parts where they are long. Whether someone is left to take them.
fn answer(worker: &mut Worker, task: Task) -> bool {
    let Task {
        mut job,
        parts,
        was_written,
    } = task;
    let mut begin = 0;
    loop {
        let lines = &without_last_end(&job.chunk)[begin..];
        let left = worker.answer_some(lines, LONGEST_ANSWERS, &mut job.answers);
        let is_long = job.answers.text.len() > LONGEST_ANSWERS;
        let Some(left) = left else {
            job.is_last = true;
            return parts.send(job).is_ok() && (!is_long || was_written.recv().is_ok());
        };
        begin += left;
        let before = job.answers.before + job.answers.lines;
        let part = Job {
            answers: core::mem::take(&mut job.answers),
            ..Job::default()
        };
        job.answers.before = before;
        if parts.send(part).is_err() || was_written.recv().is_err() {
            return false;
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::batch::{LONGEST_ANSWERS, OnError, Options, run};
    use crate::joints::Cut;
    use crate::number::Precision;
    use std::io::Read;

    fn answered(input: impl Read + Send + 'static, jobs: usize, count: usize) -> String {
        let options = Options {
            jobs,
            cut: Cut::Count(count),
            precision: Some(Precision::Full),
            on_error: OnError::Report,
            ..Options::default()
        };
        let mut out = Vec::new();
        run(input, &mut out, &options, |_, _| ()).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn long_answers_come_in_parts_and_in_order() {
        // The answer to one of them is longer than what is written at once.
        let lines = "circle 0 0 1\nbad\ncircle 0 0 2\nbad\n";
        let input = || {
            (&b"bad\n#\n"[..])
                .chain(lines.as_bytes())
                .chain(&b"bad\ncircle 0 0 3\nbad"[..])
        };
        let alone = answered(input(), 1, 15_000);
        assert!(alone.len() > 3 * (LONGEST_ANSWERS + 1));
        let numbers = |text: &str| -> Vec<u64> {
            let reports = text.lines().filter(|line| line.starts_with('{'));
            let report = |line| serde_json::from_str::<serde_json::Value>(line).unwrap();
            reports
                .map(|line| report(line)["line"].as_u64().unwrap())
                .collect()
        };
        assert_eq!(numbers(&alone), [1, 4, 6, 7, 9]);
        assert!(answered(input(), 3, 15_000) == alone);
    }
}
