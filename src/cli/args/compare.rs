//! The words of `compare`.

use clap::builder::PossibleValue;
use clap::{ArgAction, Args, ValueEnum};
use curveto::compare::{Comparison, Criterion};
use curveto::method::Quadrature;
use curveto::picture::size::Size;
use curveto::write::Image;
use curveto::{Angle, Method, Rule};

use super::approximation::no_arc_length;
use super::values::{self, MethodList};
use super::{FileArgs, QuietArgs};
use crate::cli::failure::Failure;
use crate::cli::formats::{self, FileFormat};

/// Methods by numbers of segments, on the full circle of radius 1 or an ellipse, or by the angle of one segment.
#[derive(Debug, Args)]
pub(crate) struct CompareArgs {
    /// Methods by id or alias, or all
    #[arg(short, long, value_name = "ID,ID|all", default_value = "all", value_parser = values::METHODS, hide_possible_values = true, action = ArgAction::Set)]
    pub(crate) method: Vec<MethodList>,
    /// Numbers of segments
    #[arg(short = 'n', long, value_name = "N,N", value_parser = super::values::count, value_delimiter = ',', action = ArgAction::Set, default_values_t = [2, 3, 4, 5, 6, 8])]
    pub(crate) segments: Vec<usize>,
    /// Angles of one segment in place of numbers of segments
    #[arg(long, value_name = "A,B,...", value_parser = super::values::angle, value_delimiter = ',', allow_hyphen_values = true, action = ArgAction::Set, conflicts_with_all = ["segments", "ellipse"])]
    pub(crate) spans: Vec<Angle>,
    /// Compare on the ellipse with the semi-axes 1 and B, cut at equal parametric angles
    #[arg(long, value_name = "B", value_parser = values::positive, allow_hyphen_values = true)]
    pub(crate) ellipse: Option<f64>,
    /// What to compare; a table, JSON and a page take several [possible values: peak, square, mean, rms, area, length]
    #[arg(long, value_name = "BY,BY", default_value = "peak", value_delimiter = ',', action = ArgAction::Set, value_parser = values::CRITERION, hide_possible_values = true)]
    pub(crate) by: Vec<Criterion>,
    /// How chen-2 integrates arc length
    #[arg(long, value_enum, value_name = "RULE", default_value_t)]
    pub(crate) quadrature: Quadrature,
    /// The format [default: by the extension of -o, else table]
    #[arg(short, long, value_enum, value_name = "F", ignore_case = true)]
    pub(crate) format: Option<ComparisonFormat>,
    #[command(flatten)]
    pub(crate) output: FileArgs,
    /// The size of a plot: pixels in svg and png, points in eps and pdf, or mm, cm, in, pt
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub(crate) size: Option<Size>,
    #[command(flatten)]
    quiet: QuietArgs,
}

/// How a comparison is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum ComparisonFormat {
    #[default]
    Table,
    Csv,
    Json,
    Html,
    /// A plot, both axes logarithmic.
    Plot(Image),
}

impl ValueEnum for ComparisonFormat {
    fn value_variants<'a>() -> &'a [Self] {
        const ALL: [ComparisonFormat; 8] = [
            ComparisonFormat::Table,
            ComparisonFormat::Csv,
            ComparisonFormat::Json,
            ComparisonFormat::Html,
            ComparisonFormat::Plot(Image::Svg),
            ComparisonFormat::Plot(Image::Eps),
            ComparisonFormat::Plot(Image::Png),
            ComparisonFormat::Plot(Image::Pdf),
        ];
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, about) = match self {
            Self::Table => ("table", "For people, 80 columns wide up to six counts"),
            Self::Csv => ("csv", "A line a method"),
            Self::Json => ("json", "docs/schema/comparison.json describes it"),
            Self::Html => ("html", "A page to look at: choose, magnify, sort, copy"),
            Self::Plot(image) => (image.name(), "A plot, both axes logarithmic"),
        };
        Some(PossibleValue::new(name).help(about))
    }
}

impl FileFormat for ComparisonFormat {
    fn extensions(&self) -> &'static [&'static str] {
        match self {
            Self::Table => &["txt"],
            Self::Csv => &["csv"],
            Self::Json => &["json"],
            Self::Html => &["html", "htm"],
            Self::Plot(image) => image.extensions(),
        }
    }
}

impl CompareArgs {
    /// The comparison by one criterion.
    pub(crate) fn comparison(&self, by: Criterion) -> curveto::Result<Comparison> {
        let rules = self.rules();
        if self.spans.is_empty() {
            return Comparison::new(&rules, &self.segments, by, self.ellipse);
        }
        let spans: Vec<f64> = self.spans.iter().map(|span| span.degrees()).collect();
        Comparison::by_span(&rules, &spans, by)
    }

    /// Refuses a size where the format is no plot.
    pub(crate) fn check_size(&self, format: ComparisonFormat) -> Result<(), Failure> {
        if self.size.is_none() || matches!(format, ComparisonFormat::Plot(_)) {
            return Ok(());
        }
        let name = format.to_possible_value();
        let name = name.as_ref().map_or("", PossibleValue::get_name);
        Err(Failure::request_with_hint(
            format!("--size says nothing in the format {name}, which is no plot"),
            format!(
                "leave it out, or take a plot with -f or the extension of -o: {}",
                formats::list::<Image>()
            ),
        ))
    }

    /// Refuses a quadrature that none of the methods has.
    pub(crate) fn check_quadrature(&self) -> Result<(), Failure> {
        let methods = || self.method.iter().flatten();
        match methods().next() {
            Some(first)
                if self.quadrature == Quadrature::Gauss2
                    && methods().all(|method| *method != Method::Chen2) =>
            {
                Err(no_arc_length(first.id(), false))
            }
            _ => Ok(()),
        }
    }

    /// The rules of the methods.
    pub(crate) fn rules(&self) -> Vec<Rule> {
        let rule = |&method: &Method| match (method, self.quadrature) {
            (Method::Chen2, Quadrature::Gauss2) => Rule::CHEN_2_GAUSS_2,
            _ => Rule::Method(method),
        };
        self.method.iter().flatten().map(rule).collect()
    }
}
