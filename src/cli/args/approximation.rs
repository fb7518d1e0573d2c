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
    #[arg(
        long,
        requires = "segments",
        conflicts_with = "joints",
        hide_short_help = true
    )]
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
        let iteration = Iteration {
            quadrature: self.quadrature,
            stop: self.stop.unwrap_or(0.0),
        };
        if iteration != Iteration::default() {
            return match (self.handle, method) {
                (None, Method::Chen2) => Ok(Rule::Chen2(iteration)),
                (None, _) => Err(no_arc_length(method.id(), self.stop.is_some())),
                (Some(_), _) => Err(no_arc_length("a literal handle", self.stop.is_some())),
            };
        }
        if let Some(k) = self.handle {
            let rule = Rule::Handle(k);
            rule.check()?;
            return Ok(rule);
        }
        Ok(Rule::Method(method))
    }

    /// The tolerance of what is no Bézier, such as lines; refuses what only Béziers have.
    pub(crate) fn only_tolerance(&self, what: &str) -> Result<Option<Tolerance>, Failure> {
        match self.cut() {
            Cut::Tolerance(tolerance) if self.has_default_rule() && !self.extremes => {
                Ok(Some(tolerance))
            }
            Cut::Quarters if self.has_default_rule() && !self.extremes => Ok(None),
            _ => Err(Failure::request_with_hint(
                format!("{what} no method of Béziers: of these options only -t has a say"),
                "-t gives the distance from what was given",
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

/// Why a choice of how arc length is found has no say beside what finds none.
pub(crate) fn no_arc_length(name: &str, is_stop: bool) -> Failure {
    let (why, hint) = if is_stop {
        (
            "iterates no arc length, so that --stop",
            "--stop goes with -m chen-2; an arc ends at its --end",
        )
    } else {
        (
            "integrates no arc length, so that --quadrature",
            "--quadrature gauss2 goes with -m chen-2",
        )
    };
    Failure::request_with_hint(format!("{name} {why} has nothing to say"), hint)
}
