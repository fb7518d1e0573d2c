//! Arguments of a command that are declared only when it is called: declaring those of all commands takes longer than drawing a circle.

use crate::cli::examples;
use clap::builder::Resettable;
use clap::{ArgMatches, Args, Command, Error, FromArgMatches, Id};

/// A command's arguments, declared when they are first asked for. Where the command `HAS_COMMANDS` of its own, `help` and the completion
/// scripts list those beforehand, and only other commands leave them for later.
#[derive(Debug)]
pub(crate) struct Deferred<T, const HAS_COMMANDS: bool = false>(pub(crate) T);

impl<T: FromArgMatches, const HAS_COMMANDS: bool> FromArgMatches for Deferred<T, HAS_COMMANDS> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        T::from_arg_matches(matches).map(Self)
    }

    fn from_arg_matches_mut(matches: &mut ArgMatches) -> Result<Self, Error> {
        T::from_arg_matches_mut(matches).map(Self)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        self.0.update_from_arg_matches(matches)
    }
}

impl<T: Args, const HAS_COMMANDS: bool> Args for Deferred<T, HAS_COMMANDS> {
    fn group_id() -> Option<Id> {
        T::group_id()
    }

    fn augment_args(command: Command) -> Command {
        if HAS_COMMANDS && !draws() {
            return T::augment_args(command);
        }
        command.defer(declare::<T>)
    }

    fn augment_args_for_update(command: Command) -> Command {
        T::augment_args_for_update(command)
    }
}

/// Whether the first word is a command that asks for no other one.
fn draws() -> bool {
    let word = std::env::args_os().nth(1);
    word.is_some_and(|word| {
        [
            "circle", "ellipse", "arc", "conic", "path", "batch", "convert",
        ]
        .iter()
        .any(|own| word == *own)
    })
}

/// Declares the arguments. What the command says of itself stays: a type's own words are about the type.
fn declare<T: Args>(command: Command) -> Command {
    let about = command.get_about().cloned();
    let long_about = command.get_long_about().cloned();
    examples::ended(
        T::augment_args(command)
            .about(Resettable::from(about))
            .long_about(Resettable::from(long_about)),
    )
}
