//! The words of `methods`.

use clap::{Args, ValueEnum};
use curveto::Method;

use super::values;

#[derive(Debug, Args)]
pub(crate) struct MethodsArgs {
    /// One method, by id or alias: its whole card
    #[arg(value_name = "ID", value_parser = values::METHOD, hide_possible_values = true)]
    pub(crate) id: Option<Method>,
    /// The format
    #[arg(short, long, value_enum, value_name = "F", default_value_t)]
    pub(crate) format: CatalogueFormat,
}

/// How the catalogue is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum CatalogueFormat {
    /// For people
    #[default]
    Table,
    /// Everything, for programs
    Json,
    /// A line a method
    Csv,
}
