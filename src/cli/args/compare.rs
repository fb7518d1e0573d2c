//! The words of `compare`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use curveto::compare::Criterion;
use curveto::{Method, Rule};

use super::approximation::Quadrature;
use super::values;

/// Methods by numbers of segments, on the full circle of radius 1.
#[derive(Debug, Args)]
pub(crate) struct CompareArgs {
    /// Methods by id or alias, or all
    #[arg(short, long, value_name = "ID,ID|all", default_value = "all", value_parser = methods)]
    pub(crate) method: MethodList,
    /// Numbers of segments
    #[arg(short = 'n', long, value_name = "N,N", value_delimiter = ',', default_values_t = [2, 3, 4, 5, 6, 8])]
    pub(crate) segments: Vec<usize>,
    /// What to compare; a table and JSON take several [possible values: peak, mean, rms, area, length]
    #[arg(long, value_name = "BY", default_value = "peak", value_delimiter = ',', value_parser = |text: &str| text.parse::<Criterion>())]
    pub(crate) by: Vec<Criterion>,
    /// How chen-2 integrates arc length
    #[arg(long, value_enum, value_name = "RULE", default_value_t)]
    pub(crate) quadrature: Quadrature,
    /// The format [default: by the extension of -o, else table]
    #[arg(short, long, value_enum, value_name = "F")]
    pub(crate) format: Option<ComparisonFormat>,
    /// Write to FILE, atomically; - is standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// The size of a plot in pixels
    #[arg(long, value_name = "WxH", value_parser = values::pixels)]
    pub(crate) size: Option<[f64; 2]>,
}

/// The methods that were named; a name of its own, since clap reads a plain `Vec` value by value.
pub(crate) type MethodList = Vec<Method>;

/// How a comparison is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ComparisonFormat {
    /// For people, 80 columns wide
    Table,
    /// A line a method
    Csv,
    /// docs/schema/comparison.json describes it
    Json,
    /// A plot, both axes logarithmic
    Svg,
    /// The same in pixels
    Png,
    /// A page with the table and the plot
    Html,
}

/// Reads a list of methods, or `all`.
fn methods(text: &str) -> Result<MethodList, String> {
    if text == "all" {
        return Ok(Method::ALL.to_vec());
    }
    text.split(',')
        .map(|name| values::method(name.trim()))
        .collect()
}

impl CompareArgs {
    /// The rules behind the methods.
    pub(crate) fn rules(&self) -> Vec<Rule> {
        let rule = |&method: &Method| match (method, self.quadrature) {
            (Method::Chen2, Quadrature::Gauss2) => Rule::Chen2Gauss2,
            _ => Rule::Method(method),
        };
        self.method.iter().map(rule).collect()
    }
}
