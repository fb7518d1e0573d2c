//! The words of commands that go through many shapes: how each of them is approximated, by how many threads.

use std::num::NonZeroUsize;

use clap::Args;
use curveto::joints::MOST_SEGMENTS;
use curveto::{Cut, Error, Method, Rule, Tolerance};

use super::values;
use crate::cli::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct EachArgs {
    /// The method, by id or alias [default: minimax]
    ///
    /// 'curveto methods' lists them.
    #[arg(short, long, value_name = "ID", value_parser = values::METHOD, hide_possible_values = true)]
    method: Option<Method>,
    /// Exactly N segments for each shape and arc
    ///
    /// They are of equal parametric angle.
    #[arg(short = 'n', long, value_name = "N", value_parser = values::count, allow_hyphen_values = true, conflicts_with = "tolerance")]
    segments: Option<usize>,
    /// The fewest segments within T of the true shape
    ///
    /// T is a distance in user units, or a percentage of the larger radius. The curve is judged as it is printed: where rounding takes a segment more, more decimals (-p) may save it.
    #[arg(short, long, value_name = "T", value_parser = values::tolerance, allow_hyphen_values = true)]
    tolerance: Option<Tolerance>,
    /// Decimals after the point, or auto [default: auto]
    ///
    /// auto takes for each shape the fewest that add no more than a tenth of its error.
    #[arg(short, long, value_name = "P", value_parser = values::precision, allow_hyphen_values = true)]
    pub(crate) precision: Option<values::PrecisionWord>,
    /// How many threads [default: one for each processor]
    #[arg(short, long, value_name = "N", value_parser = values::count_from_one, allow_hyphen_values = true)]
    pub(crate) jobs: Option<NonZeroUsize>,
}

impl EachArgs {
    /// What gives the control points.
    pub(crate) fn rule(&self) -> Rule {
        Rule::Method(self.method.unwrap_or_default())
    }

    /// The tolerance, where no other option says how Béziers are made.
    pub(crate) fn only_tolerance(&self) -> Result<Option<Tolerance>, Failure> {
        let says = self.method.is_some() || self.segments.is_some() || self.precision.is_some();
        if says {
            return Err(Failure::request_with_hint(
                "arcs follow no method of Béziers, and their ends keep their digits: of these options only -t has a say",
                "-t gives the distance that an arc may have from its Béziers",
            ));
        }
        Ok(self.tolerance)
    }

    /// Where each shape is cut; refuses counts that none could have.
    pub(crate) fn cut(&self) -> Result<Cut, Failure> {
        Ok(match (self.segments, self.tolerance) {
            (Some(count), _) if count == 0 || count > MOST_SEGMENTS => {
                let most = MOST_SEGMENTS;
                return Err(Error::Count { count, most }.into());
            }
            (Some(count), _) => Cut::Count(count),
            (None, Some(tolerance)) => Cut::Tolerance(tolerance),
            (None, None) => Cut::Quarters,
        })
    }
}
