//! `methods`: the catalogue as a table, a card, JSON and CSV. Every figure is computed when it is asked for.

mod card;
mod notes;
mod table;

use std::process::ExitCode;

use curveto::Method;
use curveto::write::catalogue::{CatalogueDocument, MethodDocument, csv};
use curveto::write::json;

use super::Outcome;
use super::args::methods::{CatalogueFormat, MethodsArgs};
use super::output::OutputTarget;

pub(super) fn run(args: &MethodsArgs) -> Outcome {
    let one = args.id;
    let methods = one.map_or_else(|| Method::ALL.to_vec(), |method| vec![method]);
    let entries = methods
        .iter()
        .map(|&method| MethodDocument::new(method))
        .collect::<Result<Vec<_>, _>>()?;
    let text = match (args.format, one) {
        (CatalogueFormat::Csv, _) => csv(&entries),
        (CatalogueFormat::Json, Some(_)) => json::to_string(&entries[0])? + "\n",
        (CatalogueFormat::Json, None) => {
            json::to_string(&CatalogueDocument {
                version: 1,
                methods: entries,
            })? + "\n"
        }
        (CatalogueFormat::Table, None) => table::render(&entries),
        (CatalogueFormat::Table, Some(method)) => card::render(method, &entries[0])?,
    };
    OutputTarget::Stdout.write(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
