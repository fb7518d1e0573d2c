//! `compare`.

use std::path::Path;
use std::process::ExitCode;

use curveto::compare::Comparison;
use curveto::picture::plot::{Chart, PictureFormat};
use curveto::write::comparison::{csv, html, table};
use curveto::write::json;

use super::Outcome;
use super::args::CompareArgs;
use super::args::compare::ComparisonFormat;
use super::failure::Failure;
use super::output::Target;

pub(super) fn run(args: &CompareArgs) -> Outcome {
    let rules = args.rules();
    let comparisons: Vec<Comparison> = args
        .by
        .iter()
        .map(|&by| Comparison::new(&rules, &args.segments, by))
        .collect::<Result<_, _>>()?;
    let target = Target::new(args.output.as_deref());
    let bytes = match (args.format(), comparisons.as_slice()) {
        (ComparisonFormat::Table, all) => {
            let tables: Vec<String> = all.iter().map(table).collect();
            tables.join("\n").into_bytes()
        }
        (ComparisonFormat::Json, [one]) => (json::to_string(one)? + "\n").into_bytes(),
        (ComparisonFormat::Json, all) => (json::to_string(&all)? + "\n").into_bytes(),
        (format, [one]) => one_only(format, one, args, &target)?,
        _ => {
            return Err(Failure::request_with_hint(
                "a plot, a page or CSV shows one criterion",
                "-f table and -f json take several",
            ));
        }
    };
    target.write(&bytes)?;
    Ok(ExitCode::SUCCESS)
}

/// A comparison in a format that shows one criterion only.
fn one_only(
    format: ComparisonFormat,
    comparison: &Comparison,
    args: &CompareArgs,
    target: &Target,
) -> Result<Vec<u8>, Failure> {
    let picture = |format| Chart::comparison(comparison).picture(format, args.size);
    Ok(match format {
        ComparisonFormat::Svg => picture(PictureFormat::Svg)?,
        ComparisonFormat::Png => {
            target.refuse_terminal()?;
            picture(PictureFormat::Png)?
        }
        ComparisonFormat::Html => {
            let svg = picture(PictureFormat::Svg)?;
            html(comparison, &String::from_utf8_lossy(&svg)).into_bytes()
        }
        _ => csv(comparison).into_bytes(),
    })
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
