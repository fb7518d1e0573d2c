//! `compare`.

use std::io::IsTerminal;
use std::path::Path;
use std::process::ExitCode;

use curveto::compare::Comparison;
use curveto::write::comparison::{csv, html, table};
use curveto::write::json;
use curveto::write::plot::{Chart, PictureFormat};

use super::Outcome;
use super::args::CompareArgs;
use super::args::compare::ComparisonFormat;
use super::failure::Failure;
use super::output::Target;

pub(super) fn run(args: &CompareArgs) -> Outcome {
    let comparison = Comparison::new(&args.method, &args.segments, args.by)?;
    let picture = |format| Chart::comparison(&comparison).picture(format, args.size);
    let target = Target::new(args.output.as_deref());
    let bytes = match args.format() {
        ComparisonFormat::Table => table(&comparison).into_bytes(),
        ComparisonFormat::Csv => csv(&comparison).into_bytes(),
        ComparisonFormat::Json => (json::to_string(&comparison)? + "\n").into_bytes(),
        ComparisonFormat::Svg => picture(PictureFormat::Svg)?,
        ComparisonFormat::Png if target == Target::Stdout && std::io::stdout().is_terminal() => {
            return Err(Failure::request_with_hint(
                "a PNG does not belong on a terminal",
                "give -o FILE, or redirect standard output",
            ));
        }
        ComparisonFormat::Png => picture(PictureFormat::Png)?,
        ComparisonFormat::Html => {
            let svg = picture(PictureFormat::Svg)?;
            html(&comparison, &String::from_utf8_lossy(&svg)).into_bytes()
        }
    };
    target.write(&bytes)?;
    Ok(ExitCode::SUCCESS)
}

impl CompareArgs {
    /// The format that was asked for, or that the extension of the output file tells.
    fn format(&self) -> ComparisonFormat {
        let extension = self.output.as_deref().and_then(Path::extension);
        let extension = extension
            .and_then(|e| e.to_str())
            .map(str::to_ascii_lowercase);
        self.format.unwrap_or(match extension.as_deref() {
            Some("csv") => ComparisonFormat::Csv,
            Some("json") => ComparisonFormat::Json,
            Some("svg") => ComparisonFormat::Svg,
            Some("png") => ComparisonFormat::Png,
            Some("html" | "htm") => ComparisonFormat::Html,
            _ => ComparisonFormat::Table,
        })
    }
}
