//! The words of `diff`.

use std::ffi::OsString;

use clap::{Args, ValueEnum, ValueHint};

use super::values;

#[derive(Debug, Args)]
#[command(
    after_help = "A drawing is SVG path data, or a file with it, with SVG (paths and basic shapes, transforms applied), with our JSON (lines of batch too) or with PostScript path operators. Where a subpath begins and which way it runs make no difference. Without -t, segments have to be equal, number by number, and subpaths closed alike."
)]
pub(crate) struct DiffArgs {
    /// The one drawing: path data, or a file; - is standard input
    #[arg(value_name = "OLD", value_hint = ValueHint::AnyPath, allow_hyphen_values = true)]
    pub(crate) old: OsString,
    /// The other
    #[arg(value_name = "NEW", value_hint = ValueHint::AnyPath, allow_hyphen_values = true)]
    pub(crate) new: OsString,
    /// How far they may lie apart, in user units
    ///
    /// What the rounding of coordinates may have added, four units in the last place of the largest, counts for nothing.
    #[arg(
        short,
        long,
        value_name = "T",
        default_value_t = 0.0,
        hide_default_value = true,
        value_parser = values::distance,
        allow_hyphen_values = true
    )]
    pub(crate) tolerance: f64,
    /// The format of the report
    #[arg(
        short,
        long,
        value_enum,
        value_name = "F",
        default_value_t,
        ignore_case = true
    )]
    pub(crate) format: DiffFormat,
    /// Print nothing: the exit code says it
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

/// How a report is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum DiffFormat {
    /// A line for every subpath beyond T, and one for all
    #[default]
    Text,
    /// All subpaths; docs/schema/difference.json describes it
    Json,
}
