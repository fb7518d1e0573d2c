//! A file that is made beside its place and moved there when it is whole: until then the old one stays.

use std::fs::{self, File, Metadata, Permissions};
use std::io;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::signals;

/// What the names of files begin with that are being made.
pub(crate) const TEMPORARY: &str = ".curveto-";

/// A new file. It is removed where it does not take its place, be it that a signal ends the run.
pub(crate) struct NewFile {
    file: NamedTempFile<File>,
    place: PathBuf,
    /// What the file is like that is there already.
    old: Option<Metadata>,
}

impl NewFile {
    /// A new file in the folder of its place.
    pub(crate) fn beside(place: PathBuf) -> io::Result<Self> {
        let old = fs::metadata(&place).ok();
        let mode = old.as_ref().map(Metadata::permissions);
        let mut making = signals::making()?;
        // Opened and written here and not by tempfile, whose errors name a file that nobody knows.
        let file = tempfile::Builder::new()
            .prefix(TEMPORARY)
            .make_in(folder_of(&place), |path| create(path, mode.as_ref()))?;
        making.insert(file.path().to_owned());
        // A lock ends with its process, so that a later run knows a file that was left. Not every file system has locks.
        let _ = file.as_file().try_lock();
        Ok(Self { file, place, old })
    }

    /// What is written to.
    pub(crate) fn file(&mut self) -> &mut File {
        self.file.as_file_mut()
    }

    /// Moves it to its place, with the owner, the extended attributes and the mode of the one that was there.
    pub(crate) fn take_place(self) -> io::Result<()> {
        if let Some(old) = &self.old {
            let file = self.file.as_file();
            keep_owner(file, old)?;
            keep_attributes(file, &self.place);
            // The mask of the process does not apply to a mode that was there; a change of owner takes bits away, so that this comes last.
            file.set_permissions(old.permissions())?;
        }
        let mut making = signals::making()?;
        making.remove(self.file.path());
        self.file.persist(self.place).map_err(|error| error.error)?;
        Ok(())
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
fn keep_owner(file: &File, old: &Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt, fchown};
    let new = file.metadata()?;
    if (new.uid(), new.gid()) == (old.uid(), old.gid()) {
        return Ok(());
    }
    fchown(file, Some(old.uid()), Some(old.gid()))
        .map_err(|error| io::Error::new(error.kind(), format!("its owner cannot be kept: {error}")))
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &Metadata) -> io::Result<()> {
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
