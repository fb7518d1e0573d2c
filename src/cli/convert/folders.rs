//! The folders that were written to: on the disk as their files are, and without what killed runs left.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::tree::{Destination, FileJob};
use crate::cli::new_file::TEMPORARY;

/// A file that is made takes its lock at once, but not in the same moment: a younger one is left alone.
const YOUNGEST: Duration = Duration::from_secs(60);

/// The folders where these jobs put their files.
pub(super) fn written(jobs: &[FileJob]) -> BTreeSet<PathBuf> {
    let place = |job: &FileJob| match &job.destination {
        Destination::InPlace(path) | Destination::OutDir(path) => {
            let path = fs::canonicalize(path).unwrap_or_else(|_| path.clone());
            path.parent().map(Path::to_owned)
        }
        _ => None,
    };
    jobs.iter().filter_map(place).collect()
}

/// Has the names of the files in a folder on the disk; where the system cannot, it does so when it sees fit.
pub(super) fn sync(folder: &Path) {
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}

/// Removes the files that were being made when their process was killed. One that is being made has a lock, which ends with its
/// process. What cannot be removed stays for a later run.
pub(super) fn remove_left_overs(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if is_temporary(&entry.file_name().to_string_lossy()) && is_left_over(&entry.path()) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Whether a name is one that [`crate::cli::new_file::NewFile`] has.
fn is_temporary(name: &str) -> bool {
    name.strip_prefix(TEMPORARY).is_some_and(|rest| {
        rest.len() == 6 && rest.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

fn is_left_over(path: &Path) -> bool {
    let is_old = |data: &fs::Metadata| {
        let age = data.modified().ok().and_then(|time| time.elapsed().ok());
        data.is_file() && age.is_some_and(|age| age > YOUNGEST)
    };
    fs::symlink_metadata(path).is_ok_and(|data| is_old(&data))
        && File::open(path).is_ok_and(|file| file.try_lock().is_ok())
}
