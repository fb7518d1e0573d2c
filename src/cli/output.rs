//! Where output goes: standard output, or a file that is either whole and new or untouched.

use std::fs::{self, File, Permissions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use anyhow::Context;
use curveto::write::{Format, Image, Options, Writable, write};

use super::args::OutputArgs;
use super::failure::Failure;

/// Where output goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Target {
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
    target.write(&write(work, format, options)?)?;
    words.talk.state(|| work.summary());
    Ok(())
}

impl Target {
    /// The target of `-o`: a file, or standard output for `-` and without it.
    pub(crate) fn new(output: Option<&Path>) -> Self {
        match output {
            Some(path) if path.as_os_str() != "-" => Self::File(path.to_owned()),
            _ => Self::Stdout,
        }
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

/// Writes a file atomically: it is made beside its place and moved there when it is whole. The mode of a file that was there is
/// kept; a link is followed; what is no plain file, such as a device or a pipe, is written to directly.
pub(crate) fn write_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let path = &fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let existing = fs::metadata(path).ok();
    if existing.as_ref().is_some_and(|data| !data.is_file()) {
        return File::options().write(true).open(path)?.write_all(bytes);
    }
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."));
    let mode = existing.map(|data| data.permissions());
    // Opened here and not by tempfile, whose errors name a file that nobody knows.
    let mut file = tempfile::Builder::new()
        .prefix(".curveto-")
        .make_in(folder, |path| create(path, mode.as_ref()))?;
    file.write_all(bytes)?;
    if let Some(mode) = mode {
        // The mask of the process does not apply to a mode that was there.
        file.as_file().set_permissions(mode)?;
    }
    file.persist(path).map_err(|error| error.error)?;
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
