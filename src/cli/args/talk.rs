//! The words for how much is said on standard error.

use clap::Args;

use crate::cli::failure::tell;

#[derive(Debug, Clone, Copy, Default, Args)]
pub(crate) struct QuietArgs {
    /// Print no notes, only errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Clone, Copy, Default, Args)]
pub(crate) struct TalkArgs {
    /// State on standard error what was done and how closely
    #[arg(short, long)]
    pub(crate) verbose: bool,
    #[command(flatten)]
    pub(crate) notes: QuietArgs,
}

impl QuietArgs {
    /// Gives a note, unless it is not wanted.
    pub(crate) fn note(self, note: &str) {
        if !self.quiet {
            tell(&format!("note: {note}\n"));
        }
    }
}

impl TalkArgs {
    /// States what was done, where that was asked for.
    pub(crate) fn state(self, what_was_done: impl FnOnce() -> String) {
        if self.verbose {
            tell(&format!("{}\n", what_was_done()));
        }
    }

    /// Gives a note, unless it is not wanted.
    pub(crate) fn note(self, note: &str) {
        self.notes.note(note);
    }
}
