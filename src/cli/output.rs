//! Where output goes: standard output, or a file that is either whole and new or untouched.

use std::fs::{self, File, Metadata};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use anyhow::Context;
use curveto::picture::words::within;
use curveto::write::{Format, Image, Options, Writable, write};

use super::args::OutputArgs;
use super::failure::Failure;
use super::new_file::{NewFile, folder_of};
use super::signals;

/// Where output goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum OutputTarget {
    Stdout,
    Stderr,
    /// A file, or what else has a name.
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
    let itself = || {
        let figure = work.figure();
        let (_, moved) = options.arc_itself(figure.truth(0)?)?;
        Some(format!("{}, {}", figure.title, within(moved)))
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
        Format::Dxf => itself().unwrap_or_else(|| work.summary()),
        _ => work.summary(),
    }
}

impl OutputTarget {
    /// The target of `-o`: standard output for `-` and without it.
    pub(crate) fn new(output: Option<&Path>) -> Self {
        let Some(path) = output.filter(|path| path.as_os_str() != "-") else {
            return Self::Stdout;
        };
        match followed(path) {
            Ok(LinkTarget::Open(1)) => Self::Stdout,
            Ok(LinkTarget::Open(2)) => Self::Stderr,
            _ => Self::File(path.to_owned()),
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
        let is_terminal = match self {
            Self::Stdout => io::stdout().is_terminal(),
            Self::Stderr => io::stderr().is_terminal(),
            Self::File(_) => false,
        };
        if is_terminal {
            return Err(Failure::request_with_hint(
                "a png file is not for a terminal",
                "name a file with -o FILE.png, or redirect standard output",
            ));
        }
        Ok(())
    }

    /// What an error says that hinders to write.
    pub(crate) fn cannot(&self) -> String {
        match self {
            Self::Stdout => "cannot write to standard output".to_owned(),
            Self::Stderr => "cannot write to standard error".to_owned(),
            Self::File(path) => format!("cannot write {}", path.display()),
        }
    }

    /// Writes everything at once.
    pub(crate) fn write(&self, bytes: &[u8]) -> Result<(), Failure> {
        self.stream(|out| {
            let written = out.write_all(bytes).and_then(|()| out.flush());
            written.with_context(|| self.cannot())?;
            Ok(true)
        })
    }

    /// Writes bit by bit. Where `write` says that it is not to be, a plain file stays as it was.
    pub(crate) fn stream(
        &self,
        write: impl FnOnce(&mut dyn Write) -> Result<bool, Failure>,
    ) -> Result<(), Failure> {
        match self {
            Self::Stdout => write(&mut io::stdout().lock()).map(drop),
            // Without its lock, since messages go there too.
            Self::Stderr => write(&mut io::stderr()).map(drop),
            Self::File(path) => match followed(path).and_then(LinkTarget::open) {
                Ok(Opened::Through(mut file)) => write(&mut file).map(drop),
                Ok(Opened::New(mut file)) => {
                    if write(file.file())? {
                        file.take_place().with_context(|| self.cannot())?;
                    }
                    Ok(())
                }
                Err(error) => Err(error).with_context(|| self.cannot())?,
            },
        }
    }
}

/// Puts a result in the place of the input that it was made from, on its disk before; where `changed` says of the input that it is
/// another by now, it stays and the answer is no.
pub(crate) fn replace_input(
    path: &Path,
    bytes: &[u8],
    changed: impl FnOnce(&Metadata) -> bool,
) -> io::Result<bool> {
    match followed(path)?.open()? {
        Opened::Through(mut file) => file.write_all(bytes)?,
        Opened::New(mut file) => {
            file.file().write_all(bytes)?;
            file.file().sync_all()?;
            if fs::metadata(path).is_ok_and(|now| changed(&now)) {
                return Ok(false);
            }
            file.take_place()?;
        }
    }
    Ok(true)
}

/// Where a path leads by its links.
enum LinkTarget {
    /// What this process has open already, by its number.
    Open(i32),
    /// What has to be written to and is never replaced: a device, a FIFO, what another process has open.
    Through(PathBuf),
    /// A plain file, also where none is yet.
    File(PathBuf),
}

/// What is written to.
enum Opened {
    Through(File),
    New(Box<NewFile>),
}

impl LinkTarget {
    fn open(self) -> io::Result<Opened> {
        Ok(match self {
            Self::Open(number) => Opened::Through(open_already(number)?),
            // A FIFO is not open before somebody reads it.
            Self::Through(path) => Opened::Through(signals::waiting(|| {
                File::options().append(true).open(path)
            })?),
            Self::File(path) => Opened::New(NewFile::beside(path)?.into()),
        })
    }
}

/// What this process has open by this number, to go on where that is; where the system does not hand it out, at its end.
fn open_already(number: i32) -> io::Result<File> {
    let path = format!("/dev/fd/{number}");
    #[cfg(target_os = "linux")]
    {
        use rustix::process::{PidfdFlags, PidfdGetfdFlags, getpid, pidfd_getfd, pidfd_open};
        // Else a number that is free would be that of the next line.
        fs::symlink_metadata(&path)?;
        let own = pidfd_open(getpid(), PidfdFlags::empty());
        let same = own.and_then(|own| pidfd_getfd(own, number, PidfdGetfdFlags::empty()));
        if let Ok(same) = same {
            return Ok(same.into());
        }
    }
    File::options().append(true).open(path)
}

/// The most links that lead from one to the next, as in Linux.
const MOST_LINKS: usize = 40;

/// Where a path leads by its links, also where nothing is there yet.
fn followed(path: &Path) -> io::Result<LinkTarget> {
    let mut path = path.to_owned();
    for _ in 0..=MOST_LINKS {
        if let Some(place) = descriptor(&path) {
            return Ok(place);
        }
        let Ok(target) = fs::read_link(&path) else {
            let path = fs::canonicalize(&path).unwrap_or(path);
            return Ok(match fs::metadata(&path) {
                Ok(data) if !data.is_file() => LinkTarget::Through(path),
                _ => LinkTarget::File(path),
            });
        };
        path = folder_of(&path).join(target);
    }
    Err(io::Error::other("too many links lead from one to the next"))
}

/// What some process has open already, where a path is its name. That looks like a link, but what is read from it may be the name of
/// nothing, or of a file that others write to.
fn descriptor(path: &Path) -> Option<LinkTarget> {
    let number = path.file_name()?.to_str()?.parse().ok()?;
    let folder = folder_of(path);
    let real = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
    let own = fs::canonicalize("/proc/self").unwrap_or_else(|_| "/proc/self".into());
    if real == Path::new("/dev/fd") || (real.starts_with(own) && real.ends_with("fd")) {
        return Some(LinkTarget::Open(number));
    }
    (real.starts_with("/proc") && real.ends_with("fd"))
        .then(|| LinkTarget::Through(path.to_owned()))
}

/// Where a path leads by its links, by one name for one place, however it is spelled.
pub(crate) fn place_of(path: &Path) -> PathBuf {
    let path = match followed(path) {
        Ok(LinkTarget::File(real) | LinkTarget::Through(real)) => real,
        _ => path.to_owned(),
    };
    let folder = folder_of(&path);
    match path.file_name() {
        Some(name) if folder != path && !path.exists() => place_of(folder).join(name),
        _ => path,
    }
}
