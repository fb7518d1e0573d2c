//! Where output goes: standard output, or a file that is either whole and new or untouched.

use std::fs::{self, File, Permissions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use anyhow::Context;
use curveto::course::Course;
use curveto::write::{Format, Image, Options, Writable, write};

use super::args::OutputArgs;
use super::failure::Failure;
#[cfg(unix)]
use super::signals;

/// Where output goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum OutputTarget {
    /// Standard output.
    Stdout,
    /// A file.
    File(PathBuf),
}

/// Writes what was drawn, in its format, to where it was asked to go.
pub(crate) fn write_drawn(
    work: &impl Writable,
    format: Format,
    options: &Options,
    words: &OutputArgs,
) -> Result<(), Failure> {
    let target = words.target();
    if format == Format::Image(Image::Png) {
        target.refuse_terminal()?;
    }
    let bytes = write(work, format, options)?;
    target.write(&bytes)?;
    words.talk.state(|| stated(work, format, options, &bytes));
    Ok(())
}

/// What was written and how closely: an arc that a format has itself is not the curve that approximates it.
fn stated(work: &impl Writable, format: Format, options: &Options, bytes: &[u8]) -> String {
    let is_exact = || {
        let figure = work.figure();
        let arc = figure.truth(0).and_then(Course::of_arc);
        (options.exact && arc.is_some()).then_some(figure.title)
    };
    match format {
        // Its first line is a comment that says so.
        Format::Gcode => {
            let first = bytes
                .split(|&byte| byte == b'\n')
                .next()
                .unwrap_or_default();
            let text = String::from_utf8_lossy(first);
            text.trim_matches(['(', ')']).to_owned()
        }
        Format::Dxf => is_exact().map_or_else(|| work.summary(), |title| title + ", exact"),
        _ => work.summary(),
    }
}

impl OutputTarget {
    /// The target of `-o`: a file, or standard output for `-` and without it.
    pub(crate) fn new(output: Option<&Path>) -> Self {
        match output {
            Some(path) if !is_stdout(path) => Self::File(path.to_owned()),
            _ => Self::Stdout,
        }
    }

    /// What a glyph in this file is called: as the file, in whose name font editors set an underscore after each capital.
    pub(crate) fn glyph(&self) -> Option<String> {
        let Self::File(path) = self else {
            return None;
        };
        let mut name = String::new();
        for c in path.file_stem()?.to_str()?.chars() {
            if c != '_' || !name.ends_with(char::is_uppercase) {
                name.push(c);
            }
        }
        Some(name)
    }

    /// Refuses pixels on a terminal.
    pub(crate) fn refuse_terminal(&self) -> Result<(), Failure> {
        if *self == Self::Stdout && io::stdout().is_terminal() {
            return Err(Failure::request_with_hint(
                "a png file is not for a terminal",
                "name a file with -o FILE.png, or redirect standard output",
            ));
        }
        Ok(())
    }

    /// Writes everything at once.
    pub(crate) fn write(&self, bytes: &[u8]) -> Result<(), Failure> {
        match self {
            Self::Stdout => {
                let mut out = io::stdout().lock();
                Ok(out
                    .write_all(bytes)
                    .and_then(|()| out.flush())
                    .context("cannot write to standard output")?)
            }
            Self::File(path) => Ok(write_file(path, bytes)
                .with_context(|| format!("cannot write {}", path.display()))?),
        }
    }
}

/// Where a path leads by its links, also where nothing is there yet.
fn followed(path: &Path) -> PathBuf {
    let mut path = path.to_owned();
    // As many as Linux follows.
    for _ in 0..40 {
        if let Ok(real) = fs::canonicalize(&path) {
            return real;
        }
        let Ok(target) = fs::read_link(&path) else {
            break;
        };
        path = folder_of(&path).join(target);
    }
    path
}

/// The same by one name for one place, however it is spelled.
pub(crate) fn place_of(path: &Path) -> PathBuf {
    let path = followed(path);
    let folder = folder_of(&path);
    match path.file_name() {
        Some(name) if folder != path && !path.exists() => place_of(folder).join(name),
        _ => path,
    }
}

/// The folder in which a file lies.
pub(crate) fn folder_of(path: &Path) -> &Path {
    let folder = path.parent().unwrap_or(path);
    if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    }
}

/// Whether a path names standard output, which is written through and never replaced, whatever it leads to.
fn is_stdout(path: &Path) -> bool {
    ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"]
        .iter()
        .any(|name| path.as_os_str() == *name)
}

/// What the names of files begin with that are being made.
pub(crate) const TEMPORARY: &str = ".curveto-";

/// Writes a file atomically: it is made beside its place and moved there when it is whole. The mode and the owner of a file that
/// was there are kept; a link is followed; what is no plain file, such as a device or a pipe, is written to directly, and so is
/// what the process has open already.
pub(crate) fn write_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    write_file_unless(path, bytes, Durability::System, |_| false).map(drop)
}

/// As [`write_file`], of what is written bit by bit; where `write` says that it is not to be, the file that was there stays.
pub(crate) fn stream_file(
    path: &Path,
    write: impl FnOnce(&mut File) -> Result<bool, Failure>,
) -> Result<(), Failure> {
    let cannot = || format!("cannot write {}", path.display());
    let open_already = path.starts_with("/dev") || path.starts_with("/proc");
    let path = &followed(path);
    let existing = fs::metadata(path).ok();
    if open_already || existing.as_ref().is_some_and(|data| !data.is_file()) {
        let mut file = File::options()
            .append(true)
            .open(path)
            .with_context(cannot)?;
        return write(&mut file).map(drop);
    }
    let mut file = beside(path, existing.as_ref()).with_context(cannot)?;
    #[cfg(unix)]
    remove_on_signal(file.path()).with_context(cannot)?;
    if write(file.as_file_mut())? {
        take_over(file.as_file(), path, existing.as_ref()).with_context(cannot)?;
        file.persist(path)
            .map_err(|error| error.error)
            .with_context(cannot)?;
    }
    Ok(())
}

/// Where a signal asks for an end, removes the file that is being made and ends the program as a shell tells it: by 129, 130 or 143.
#[cfg(unix)]
fn remove_on_signal(path: &Path) -> io::Result<()> {
    let mut signals = signal_hook::iterator::Signals::new(signals::of_end())?;
    let path = path.to_owned();
    std::thread::Builder::new().spawn(move || {
        if let Some(signal) = signals.forever().next() {
            // Once it has taken its place, it has this name no longer.
            let _ = fs::remove_file(path);
            std::process::exit(128 + signal);
        }
    })?;
    Ok(())
}

/// A new file in the folder of another, whose place it is to take.
fn beside(
    path: &Path,
    existing: Option<&fs::Metadata>,
) -> io::Result<tempfile::NamedTempFile<File>> {
    let folder = folder_of(path);
    let mode = existing.map(fs::Metadata::permissions);
    // Opened and written here and not by tempfile, whose errors name a file that nobody knows.
    let file = tempfile::Builder::new()
        .prefix(TEMPORARY)
        .make_in(folder, |path| create(path, mode.as_ref()))?;
    // A lock ends with its process, so that a later run knows a file that was left. Not every file system has locks.
    let _ = file.as_file().try_lock();
    Ok(file)
}

/// Gives a new file the owner, the extended attributes and the mode of the one that was there.
fn take_over(file: &File, path: &Path, existing: Option<&fs::Metadata>) -> io::Result<()> {
    if let Some(existing) = existing {
        keep_owner(file, existing)?;
        keep_attributes(file, path);
        // The mask of the process does not apply to a mode that was there; a change of owner takes bits away, so that this comes last.
        file.set_permissions(existing.permissions())?;
    }
    Ok(())
}

/// Whether a file is to be on its disk when the call ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Durability {
    /// When the system sees fit.
    System,
    /// Before it takes the place of the old one.
    Synced,
}

/// As [`write_file`], but where `changed` says of the file that was there that it is another by now, it stays and the answer is no.
pub(crate) fn write_file_unless(
    path: &Path,
    bytes: &[u8],
    durability: Durability,
    changed: impl Fn(&fs::Metadata) -> bool,
) -> io::Result<bool> {
    let open_already = path.starts_with("/dev") || path.starts_with("/proc");
    let path = &followed(path);
    let existing = fs::metadata(path).ok();
    if open_already || existing.as_ref().is_some_and(|data| !data.is_file()) {
        File::options().append(true).open(path)?.write_all(bytes)?;
        return Ok(true);
    }
    let mut file = beside(path, existing.as_ref())?;
    file.as_file_mut().write_all(bytes)?;
    take_over(file.as_file(), path, existing.as_ref())?;
    if durability == Durability::Synced {
        file.as_file().sync_all()?;
    }
    if fs::metadata(path).is_ok_and(|now| changed(&now)) {
        return Ok(false);
    }
    file.persist(path).map_err(|error| error.error)?;
    Ok(true)
}

/// Gives a new file the extended attributes of the old one, access lists among them, as far as the file system and the rights of the
/// process allow: some belong to the system alone.
fn keep_attributes(file: &File, old: &Path) {
    use xattr::FileExt;
    for name in xattr::list(old).into_iter().flatten() {
        if let Ok(Some(value)) = xattr::get(old, &name) {
            let _ = file.set_xattr(&name, &value);
        }
    }
}

/// Gives a new file the owner and the group of the old one, where they differ.
#[cfg(unix)]
fn keep_owner(file: &File, old: &fs::Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt, fchown};
    let new = file.metadata()?;
    if (new.uid(), new.gid()) == (old.uid(), old.gid()) {
        return Ok(());
    }
    fchown(file, Some(old.uid()), Some(old.gid()))
        .map_err(|error| io::Error::new(error.kind(), format!("its owner cannot be kept: {error}")))
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &fs::Metadata) -> io::Result<()> {
    Ok(())
}

/// Makes a file that nobody may read who may not read the one whose place it takes.
#[cfg(unix)]
fn create(path: &Path, mode: Option<&Permissions>) -> io::Result<File> {
    use std::os::unix::fs::{OpenOptionsExt, PermissionsExt};
    let mode = mode.map_or(0o666, |mode| mode.mode() & 0o777);
    File::options()
        .write(true)
        .create_new(true)
        .mode(mode)
        .open(path)
}

#[cfg(not(unix))]
fn create(path: &Path, _: Option<&Permissions>) -> io::Result<File> {
    File::create_new(path)
}
