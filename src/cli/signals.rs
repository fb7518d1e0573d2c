//! Signals that ask for an end: they leave no file behind that was being made.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::PathBuf;
#[cfg(unix)]
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicI32, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

#[cfg(unix)]
use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};

/// The names of the files that are being made.
static MAKING: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
/// Whether the files at hand are finished before an end.
static FINISHES: AtomicBool = AtomicBool::new(false);
/// The signal that was heard last, or 0.
static HEARD: AtomicI32 = AtomicI32::new(0);

/// How many threads wait for what may never come.
static WAITING: AtomicUsize = AtomicUsize::new(0);

/// The names of the files that are being made, for who makes one or moves it to its place: after a signal nobody does.
pub(super) fn making() -> io::Result<MutexGuard<'static, BTreeSet<PathBuf>>> {
    static WATCHED: AtomicBool = AtomicBool::new(false);
    let making = MAKING.lock().unwrap_or_else(PoisonError::into_inner);
    if !WATCHED.swap(true, Ordering::Relaxed) {
        watch()?;
    }
    Ok(making)
}

/// From now on a file that grows beyond the limit of the process is an error of its writing like any other. Where that cannot be had, the
/// signal ends the program.
pub(super) fn take_limits_as_errors() {
    #[cfg(unix)]
    let _ = signal_hook::flag::register(SIGXFSZ, Arc::<AtomicBool>::default());
}

/// From now on a signal ends nothing by itself: who makes many files asks for it between them.
pub(super) fn finish_files_first() -> io::Result<()> {
    FINISHES.store(true, Ordering::Relaxed);
    making().map(drop)
}

/// Does what may wait forever, such as reading a FIFO that nobody writes to: a signal does not wait for it.
pub(super) fn waiting<T>(act: impl FnOnce() -> T) -> T {
    WAITING.fetch_add(1, Ordering::SeqCst);
    // One that was heard just before did not see that somebody waits.
    if let Some(signal) = heard() {
        end(signal.into());
    }
    let done = act();
    WAITING.fetch_sub(1, Ordering::SeqCst);
    done
}

/// The signal that was heard, where files are finished first.
pub(super) fn heard() -> Option<u8> {
    let signal = HEARD.load(Ordering::SeqCst);
    u8::try_from(signal).ok().filter(|&signal| signal > 0)
}

/// Removes what is being made and ends the program as a shell tells it: by 129, 130 or 143.
fn end(signal: i32) -> ! {
    // Nothing is made or moved any more until the end, so that no failure of that is told either.
    let making = MAKING.lock().unwrap_or_else(PoisonError::into_inner);
    for path in making.iter() {
        let _ = fs::remove_file(path);
    }
    std::process::exit(128 + signal);
}

/// Waits for signals that ask for an end.
#[cfg(unix)]
fn watch() -> io::Result<()> {
    let mut signals = signal_hook::iterator::Signals::new(of_end())?;
    std::thread::Builder::new().spawn(move || {
        for signal in signals.forever() {
            let is_first = HEARD.swap(signal, Ordering::SeqCst) == 0;
            // Files at hand are finished, but where one waits for what may never come; a second signal waits for nothing.
            let is_waiting = WAITING.load(Ordering::SeqCst) > 0;
            if is_first && !is_waiting && FINISHES.load(Ordering::Relaxed) {
                continue;
            }
            end(signal);
        }
    })?;
    Ok(())
}

#[cfg(not(unix))]
#[allow(clippy::unnecessary_wraps)]
fn watch() -> io::Result<()> {
    Ok(())
}

/// Those that are not ignored: `nohup` and a shell's background jobs ignore some, and mean it.
#[cfg(unix)]
fn of_end() -> impl Iterator<Item = i32> {
    let ignored = ignored();
    [SIGINT, SIGTERM, SIGHUP]
        .into_iter()
        .filter(move |signal| ignored >> (signal - 1) & 1 == 0)
}

/// The signals that this process ignores, a bit each from signal 1 on, as Linux tells them; none where nothing does.
#[cfg(unix)]
fn ignored() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mut masks = status
        .lines()
        .filter_map(|line| line.strip_prefix("SigIgn:"));
    let mask = masks
        .next()
        .map(|mask| u64::from_str_radix(mask.trim(), 16));
    mask.and_then(Result::ok).unwrap_or(0)
}
