//! The words for how a shape is approximated.

use clap::{ArgAction, Args};
use curveto::method::{Iteration, Quadrature};
use curveto::{Angle, Cut, Method, Rule, Tolerance};

use super::values;
use crate::cli::failure::Failure;

#[derive(Debug, Args)]
#[command(next_help_heading = "How it is approximated")]
pub(crate) struct ApproximationArgs {
    /// The method, by id or alias [default: minimax]
    ///
    /// 'curveto methods' lists them.
    #[arg(short, long, value_name = "ID", value_delimiter = ',', value_parser = values::METHOD, hide_possible_values = true, action = ArgAction::Set)]
    method: Vec<Method>,
    /// Exactly N segments, of equal parametric angle
    #[arg(short = 'n', long, value_name = "N", value_delimiter = ',', value_parser = values::count, allow_hyphen_values = true, action = ArgAction::Set, conflicts_with_all = ["tolerance", "joints"])]
    segments: Vec<usize>,
    /// The fewest segments within T of the true shape
    ///
    /// T is a distance in user units, or a percentage of the larger radius. The curve is judged as it is printed: where rounding takes a segment more, more decimals (-p) may save it.
    #[arg(short, long, value_name = "T", value_parser = values::tolerance, allow_hyphen_values = true, conflicts_with = "joints")]
    tolerance: Option<Tolerance>,
    /// Joints at these angles instead; for an arc, inside its sweep
    #[arg(long, value_name = "A,B,...", hide_short_help = true, value_delimiter = ',', value_parser = values::angle, allow_hyphen_values = true, action = ArgAction::Set)]
    joints: Vec<Angle>,
    /// A literal handle length on the unit circle in place of a method
    #[arg(long, value_name = "K", hide_short_help = true, value_parser = values::number, allow_hyphen_values = true, conflicts_with = "method")]
    handle: Option<f64>,
    /// With -n on an ellipse: joints that equalise the true error instead of equal angles
    #[arg(long, requires = "segments", hide_short_help = true)]
    adaptive: bool,
    /// Joints at every horizontal and vertical extreme
    ///
    /// -n and -t then cut the pieces between them; an explicit --start is a joint too.
    #[arg(long, conflicts_with_all = ["joints", "adaptive"])]
    pub(crate) extremes: bool,
    /// How chen-2 integrates arc length
    #[arg(
        long,
        value_enum,
        value_name = "RULE",
        hide_short_help = true,
        default_value_t
    )]
    quadrature: Quadrature,
    /// The iteration of chen-2 ends when its arc length changes by less than this part of itself [default: when it no longer changes]
    #[arg(long, value_name = "E", hide_short_help = true, value_parser = values::positive, allow_hyphen_values = true)]
    stop: Option<f64>,
}

/// Far more than any curve could use; the measure stays finite below it.
const LARGEST_HANDLE: f64 = 1e9;

impl ApproximationArgs {
    /// What gives the control points of a drawing.
    pub(crate) fn rule(&self) -> Result<Rule, Failure> {
        self.check_count()?;
        match self.rules()?.as_slice() {
            &[rule] => Ok(rule),
            _ => Err(Failure::request_with_hint(
                "a drawing has one method",
                "'curveto measure' takes several, and 'curveto compare' all of them",
            )),
        }
    }

    /// What gives the control points of a drawing, where it was asked for.
    pub(crate) fn named_rule(&self) -> Result<Option<Rule>, Failure> {
        self.check_count()?;
        if self.has_default_rule() {
            return Ok(None);
        }
        self.rule().map(Some)
    }

    /// Refuses several numbers of segments.
    fn check_count(&self) -> Result<(), Failure> {
        if self.segments.len() <= 1 {
            return Ok(());
        }
        Err(Failure::request_with_hint(
            "a drawing has one number of segments",
            "'curveto measure' takes several, and so does 'curveto compare'",
        ))
    }

    /// What gives the control points, where several methods may be asked for.
    pub(crate) fn rules(&self) -> Result<Vec<Rule>, Failure> {
        if self.method.is_empty() {
            return Ok(vec![self.rule_of(Method::default())?]);
        }
        self.method
            .iter()
            .map(|&method| self.rule_of(method))
            .collect()
    }

    fn rule_of(&self, method: Method) -> Result<Rule, Failure> {
        if let Some(k) = self.handle {
            return if k.abs() <= LARGEST_HANDLE {
                Ok(Rule::Handle(k))
            } else {
                Err(Failure::request(format!(
                    "a handle is a length on the unit circle, at most {LARGEST_HANDLE:e}, not {k:e}"
                )))
            };
        }
        let iteration = Iteration {
            quadrature: self.quadrature,
            stop: self.stop.unwrap_or(0.0),
        };
        match method {
            _ if iteration == Iteration::default() => Ok(Rule::Method(method)),
            Method::Chen2 => Ok(Rule::Chen2(iteration)),
            _ if self.stop.is_some() => Err(Failure::request_with_hint(
                format!("{method} iterates no arc length, so that --stop has nothing to say"),
                "--stop goes with -m chen-2; an arc ends at its --end",
            )),
            _ => Err(Failure::request_with_hint(
                format!(
                    "{method} integrates no arc length, so that --quadrature has nothing to say"
                ),
                "--quadrature gauss2 goes with -m chen-2",
            )),
        }
    }

    /// Whether no method was asked for.
    pub(crate) fn has_default_rule(&self) -> bool {
        self.method.is_empty()
            && self.handle.is_none()
            && self.quadrature == Quadrature::Adaptive
            && self.stop.is_none()
    }

    /// Whether nothing was asked for.
    pub(crate) fn is_silent(&self) -> bool {
        self.method.is_empty()
            && self.handle.is_none()
            && !self.extremes
            && self.cut() == Cut::Quarters
    }

    /// Where the sweep is cut: by the first number of segments, where there are several.
    pub(crate) fn cut(&self) -> Cut {
        match (self.segments.first(), self.tolerance) {
            (Some(&count), _) => self.count(count),
            (None, Some(tolerance)) => Cut::Tolerance(tolerance),
            (None, None) if self.joints.is_empty() => Cut::Quarters,
            (None, None) => Cut::At(self.joints.clone()),
        }
    }

    /// Where the sweep is cut, once for each number of segments that was asked for.
    pub(crate) fn cuts(&self) -> Vec<Cut> {
        if self.segments.is_empty() {
            return vec![self.cut()];
        }
        self.segments
            .iter()
            .map(|&count| self.count(count))
            .collect()
    }

    fn count(&self, count: usize) -> Cut {
        if self.adaptive {
            Cut::Adaptive(count)
        } else {
            Cut::Count(count)
        }
    }
}
