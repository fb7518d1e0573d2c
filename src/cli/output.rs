//! Where output goes: standard output, or a file that is either whole and new or untouched.

use std::fs::{self, File, Permissions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use anyhow::Context;
use curveto::write::{Figure, Format};

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

/// Writes a figure in its format, JSON from `json`.
pub(crate) fn write_figure(
    figure: &Figure,
    json: impl FnOnce() -> Result<String, Failure>,
    format: Format,
    args: &OutputArgs,
) -> Result<(), Failure> {
    let style = args.style(format)?;
    let target = args.target();
    if format == Format::Png {
        target.refuse_terminal()?;
    }
    let bytes = match format {
        Format::Json => (json()? + "\n").into_bytes(),
        _ => curveto::write::write(figure, format, &style)?,
    };
    target.write(&bytes)
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
                out.write_all(bytes)?;
                out.flush()?;
                Ok(())
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
    // Asked first for its plain message: the error of the file that is made there names a file that nobody knows.
    fs::metadata(folder)?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".curveto-");
    let mode = existing.map_or_else(new_file_mode, |data| Some(data.permissions()));
    if let Some(mode) = &mode {
        builder.permissions(mode.clone());
    }
    let mut file = builder
        .tempfile_in(folder)
        .map_err(|error| io::Error::from(error.kind()))?;
    file.write_all(bytes)?;
    if let Some(mode) = mode.filter(|_| path.exists()) {
        // The mask of the process does not apply to a mode that was there.
        file.as_file().set_permissions(mode)?;
    }
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

/// What a new file may be, before the mask of the process.
#[cfg(unix)]
#[expect(clippy::unnecessary_wraps, reason = "other systems have no such mode")]
fn new_file_mode() -> Option<Permissions> {
    use std::os::unix::fs::PermissionsExt;
    Some(Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn new_file_mode() -> Option<Permissions> {
    None
}
