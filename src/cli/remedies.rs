//! What the library refuses, in the words of the command line.

use curveto::Error;
use curveto::error::{JointsError, PictureError, Remedy, RuleName, ShapeError, UnmeasurableError};
use curveto::number::{rounded_up, text};

use super::args::MOST_DECIMALS;

/// The message of an error.
pub(crate) fn message(error: &Error) -> String {
    match error {
        Error::Impossible { method, .. } | Error::ToleranceOutOfReach { method, .. }
            if *method == RuleName::Handle =>
        {
            let name = RuleName::Handle.to_string();
            error.to_string().replacen(&name, "--handle", 1)
        }
        Error::Shape(ShapeError::RuleOfEllipses) => {
            "a literal handle and --quadrature are for circles and ellipses, not for a hyperbola or a parabola".to_owned()
        }
        Error::Joints(JointsError::NoAngles) => {
            "the joints cannot be used: a hyperbola and a parabola have no angles; -n and -t cut them".to_owned()
        }
        _ => error.to_string(),
    }
}

/// What the user can do about it, where there is something to say.
pub(crate) fn hint(error: &Error) -> Option<String> {
    let hint = match error {
        Error::UnknownMethod { name, nearest } => return Some(known_methods(name, nearest)),
        Error::ToleranceOutOfReach {
            method,
            remedy: Remedy::LargerTolerance(other) | Remedy::LargerToleranceOrOrder(other),
            ..
        } if *method == RuleName::Method(other) => "take a larger tolerance",
        Error::Impossible { remedy, .. }
        | Error::ToleranceOutOfReach { remedy, .. }
        | Error::Format { remedy, .. } => return Some(advice(remedy)),
        Error::TooFine { finest, .. } => {
            return Some(format!("take a larger tolerance, as -t {}", text(*finest)));
        }
        Error::TooManySegments { enough, .. } if enough.is_finite() => {
            return Some(format!("take a larger tolerance, as -t {}", text(*enough)));
        }
        Error::TooManySegments { .. } => "take a larger tolerance",
        Error::Collapsed {
            decimals: MOST_DECIMALS..,
        } => "draw it larger, as with --transform 'scale(1e6)'",
        Error::Collapsed { .. } => "give more decimals",
        Error::Picture(PictureError::SameId { .. }) => {
            "give each line an id of its own; -f dxf and eps take one id for several"
        }
        Error::Shape(ShapeError::Sweep(_)) => {
            "a whole turn is a sweep of 360; 'curveto circle' and 'curveto ellipse' draw it too"
        }
        Error::Shape(ShapeError::SmallRadius { distance, .. }) => {
            let least = rounded_up(distance / 2.0, 6);
            return Some(format!("the radius is at least {}", text(least)));
        }
        Error::Shape(ShapeError::StraightConic) => {
            "move the control point off the line between the ends, or draw the line: curveto path 'M0 0L5 5'"
        }
        Error::Unmeasurable(UnmeasurableError::Entangled) => {
            "compare parts of them: every subpath is compared with one other"
        }
        Error::Rounding { .. } => "give more decimals or a larger tolerance",
        Error::TooFewPoints { cyclic: true, .. } => "--ends free takes two points and more",
        Error::RepeatedPoint { second: 0, .. } => {
            "leave the last point out: cyclic ends close the curve by themselves"
        }
        Error::RepeatedPoint { .. } => {
            "leave one of the two out: a segment between equal points has no direction"
        }
        Error::Unsettled { .. } => {
            "the parameter is arc length, so that end derivatives are of length 1; --unit-tangents makes them so, --parametrization chord iterates nothing"
        }
        _ => return None,
    };
    Some(hint.to_owned())
}

/// The same for a line of a batch, whose ellipses start on an axis.
pub(crate) fn hint_of_line(error: &Error) -> Option<String> {
    match error {
        Error::Impossible {
            remedy: Remedy::Quarters(methods),
            ..
        } => Some(format!(
            "take -m {}; a line 'ellipse CX CY RX RY' takes -n 4",
            one_of(methods)
        )),
        _ => hint(error),
    }
}

fn known_methods(name: &str, nearest: &[&str]) -> String {
    let before = match name {
        "ahn-kim" => "Ahn and Kim 1997 is cited by Apprich et al. without a formula; ".to_owned(),
        "degen" => "Degen 2005 is cited by Apprich et al. as an overview; ".to_owned(),
        _ if nearest.is_empty() => String::new(),
        _ => format!("did you mean {}? ", nearest.join(", ")),
    };
    before + "'curveto methods' lists them all"
}

/// A remedy by the flags that bring it.
fn advice(remedy: &Remedy) -> String {
    match remedy {
        Remedy::MoreSegments { degrees, methods } => more_segments(*degrees, methods),
        Remedy::ThreeSegments(methods) => {
            format!("take at least three segments, or -m {}", one_of(methods))
        }
        Remedy::Segments(counts, methods) => {
            let counts: Vec<String> = counts.iter().map(usize::to_string).collect();
            format!(
                "take -m {}, which serve every angle, or for a full turn -n {}",
                one_of(methods),
                one_of(&counts)
            )
        }
        Remedy::EveryEllipse(method) => format!("take -m {method}, which serves every ellipse"),
        Remedy::Quarters(methods) => format!(
            "take -m {}; a whole ellipse takes -n 4 and --start on an axis",
            one_of(methods)
        ),
        Remedy::Joints(angles) => {
            let angles: Vec<String> = angles.iter().map(|&angle| text(angle)).collect();
            format!("take nearer joints, as --joints {}", angles.join(","))
        }
        Remedy::NearerJointsBy(methods) => format!(
            "take more segments or nearer joints, by -m {}",
            one_of(methods)
        ),
        Remedy::Methods(methods) => format!("take -m {}", one_of(methods)),
        Remedy::OnCircle(methods) => {
            format!("take -m {}, whose ends lie on the circle", one_of(methods))
        }
        Remedy::FinestTolerance(finest) => {
            format!("the finest tolerance at this size is about {finest:.1e}")
        }
        Remedy::LargerTolerance(method) => format!("take a larger tolerance, or -m {method}"),
        Remedy::LargerToleranceOrOrder(method) => format!(
            "take a larger tolerance, or -m {method}, whose error falls with the sixth power of the angle"
        ),
        Remedy::Scale(factor) => {
            format!(
                "--transform 'scale({})' makes it small enough",
                text(*factor)
            )
        }
        _ => plain_advice(remedy).to_owned(),
    }
}

/// `a, b or c`.
fn one_of<T: AsRef<str>>(names: &[T]) -> String {
    in_a_sentence(names, "or")
}

/// `a, b and c`, or with another word for the `and`.
pub(crate) fn in_a_sentence<T: AsRef<str>>(names: &[T], word: &str) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.split_last() {
        Some((last, others)) if !others.is_empty() => {
            format!("{} {word} {last}", others.join(", "))
        }
        _ => names.concat(),
    }
}

/// A remedy in which nothing varies.
const fn plain_advice(remedy: &Remedy) -> &'static str {
    match remedy {
        Remedy::LargerToleranceAlone => "take a larger tolerance",
        Remedy::NearerJoints => "take more segments or nearer joints",
        Remedy::MoreDecimals => "give more decimals with -p, or leave the precision to -p auto",
        Remedy::MoreDecimalsOrTolerance => "give more decimals with -p, or take a larger tolerance",
        Remedy::LineByLine => "batch -f json answers line by line",
        Remedy::SmallerPage => "name fewer methods or counts: -m minimax,midpoint,apprich -n 3,4,8",
        Remedy::CircularArcs => {
            "leave out --elliptic, so that circular arcs take the place of elliptical ones"
        }
        Remedy::FormatsOfArcs => {
            "-f path, svg, json, dxf and gcode have them, and eps, pdf and png draw them; --to beziers and --to lines go with every format"
        }
        Remedy::Arcs => {
            "draw a circle or an arc of one, or make arcs of a path by 'curveto path --to arcs'; -f dxf takes every curve"
        }
        _ => "another method or another number of segments may serve",
    }
}

fn more_segments(degrees: Option<f64>, methods: &[&str]) -> String {
    let each = degrees.map(|degrees| format!(", at least one for every {degrees} degrees"));
    let serve = if methods.len() == 1 {
        "serves"
    } else {
        "serve"
    };
    let others = match one_of(methods) {
        ids if ids.is_empty() => ids,
        ids => format!(", or -m {ids}, which {serve} 180 degrees"),
    };
    format!("take more segments{}{others}", each.unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use curveto::Method;

    #[test]
    fn cited_works_without_a_method_are_named() {
        for name in ["ahn-kim", "degen"] {
            let hint = hint(&name.parse::<Method>().unwrap_err()).unwrap();
            assert!(hint.contains("cited by Apprich et al."), "{hint}");
        }
    }
}
