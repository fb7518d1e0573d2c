//! Curves in Lancaster's equation space, as our JSON has it, back in graph space.

use kurbo::Point;
use serde::Deserialize;

use super::read::shortened;
use crate::contour::{Contour, Step};
use crate::curve::segment_of;
use crate::error::json::{column, in_plain_words};
use crate::error::{Error, Result, finite};
use crate::number::{decimals_of, round};
use crate::power::control_points;

/// Ends of segments that differ by less than this part of the largest coordinate are one point.
const SAME_POINT: f64 = 1e-9;

/// The most decimals that coefficients are taken to have been printed with.
const MOST_DECIMALS: u8 = 12;

/// What may hold coefficients: the JSON of a drawing, of a path, of a sphere, or of segments alone.
#[derive(Deserialize)]
#[serde(untagged)]
enum Coefficients {
    Path {
        subpaths: Vec<ChainCoefficients>,
    },
    Drawing(ChainCoefficients),
    Sphere {
        outline: Option<ChainCoefficients>,
        #[serde(default)]
        back: Vec<ChainCoefficients>,
        front: Vec<ChainCoefficients>,
    },
    Segments(Vec<SegmentCoefficients>),
    Segment(SegmentCoefficients),
}

impl Coefficients {
    /// The chains, in the order of the path data.
    fn chains(self) -> Vec<ChainCoefficients> {
        match self {
            Self::Path { subpaths } => subpaths,
            Self::Drawing(chain) => vec![chain],
            Self::Sphere {
                outline,
                back,
                front,
            } => outline.into_iter().chain(back).chain(front).collect(),
            Self::Segments(segments) => vec![open(segments)],
            Self::Segment(segment) => vec![open(vec![segment])],
        }
    }
}

#[derive(Deserialize)]
struct ChainCoefficients {
    #[serde(default)]
    closed: bool,
    segments: Vec<SegmentCoefficients>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum SegmentCoefficients {
    Named { power: CubicCoefficients },
    Bare(CubicCoefficients),
}

/// x = At³ + Bt² + Ct + D and y = Et³ + Ft² + Gt + H.
#[derive(Deserialize)]
struct CubicCoefficients {
    x: [f64; 4],
    y: [f64; 4],
}

/// The contours of equation-space coefficients: of every segment's `power` in the JSON that this program prints of drawings, a path or a
/// sphere, or of `{"x": [A,B,C,D], "y": [E,F,G,H]}`, alone or in an array. Segments without a third power are quadratics, those
/// without a second one too are lines.
///
/// # Errors
///
/// Where the text is no such JSON, and where a coefficient is not finite or beyond 1e150.
///
/// ```
/// use curveto::{path, contour::{BezierTarget, draw}};
/// let contours = path::contours_of_power(r#"{"x": [4,-3,6,2], "y": [0,0,3,1]}"#)?;
/// let drawing = draw(&contours, BezierTarget::Beziers, &curveto::Options::default())?;
/// assert_eq!(path::data(drawing.curves(), false), "M2 1C4 2 5 3 9 4");
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn contours_of_power(json: &str) -> Result<Vec<Contour>> {
    let wrong = |why: String, column: usize| Error::Syntax {
        what: "the coefficients",
        text: shortened(json),
        column,
        why,
    };
    // Broken JSON first, whose place is known; then JSON of another form.
    let broken = |e: serde_json::Error| wrong(in_plain_words(&e), column(json, &e));
    let values = serde_json::Deserializer::from_str(json).into_iter::<serde_json::Value>();
    let mut values = values.collect::<Result<Vec<_>, _>>().map_err(broken)?;
    if values.is_empty() {
        values.push(serde_json::from_str(json).map_err(broken)?);
    }
    let mut contours = Vec::new();
    for value in values {
        let document = Coefficients::deserialize(value).map_err(|_| {
            let form = r#"they are JSON of this program with "power" in every segment, or {"x": [A,B,C,D], "y": [E,F,G,H]}"#;
            wrong(form.to_owned(), 1)
        })?;
        for chain in &document.chains() {
            push_contours(&mut contours, chain)?;
        }
    }
    Ok(contours)
}

const fn open(segments: Vec<SegmentCoefficients>) -> ChainCoefficients {
    ChainCoefficients {
        closed: false,
        segments,
    }
}

/// Appends the contours of a chain: one, where each segment starts at the end of the one before it.
fn push_contours(contours: &mut Vec<Contour>, chain: &ChainCoefficients) -> Result<()> {
    let mut segments = Vec::with_capacity(chain.segments.len());
    for segment in &chain.segments {
        let (SegmentCoefficients::Named { power } | SegmentCoefficients::Bare(power)) = segment;
        segments.push(graph(power)?);
    }
    let reach = segments.iter().flatten().flat_map(|p| [p.x, p.y]);
    let near = SAME_POINT * reach.fold(0.0, |most: f64, x| most.max(x.abs()));
    let mut runs: Vec<Vec<Vec<Point>>> = Vec::new();
    for segment in segments {
        let joined = runs
            .last_mut()
            .and_then(|run| join(run, segment[0], near).then_some(run));
        match joined {
            Some(run) => run.push(segment),
            None => runs.push(vec![segment]),
        }
    }
    let whole = runs.len() == 1;
    for mut run in runs {
        let closed = whole && chain.closed && {
            let start = run[0][0];
            join(&mut run, start, near)
        };
        let steps = run
            .iter()
            .map(|points| Step::Given(segment_of(points)))
            .collect();
        contours.push(Contour { steps, closed });
    }
    Ok(())
}

/// Ends a run at this point, where that is its end but for rounding.
fn join(run: &mut [Vec<Point>], start: Point, near: f64) -> bool {
    let end = run.last_mut().and_then(|points| points.last_mut());
    let end = end.filter(|end| end.distance(start) <= near);
    end.map(|end| *end = start).is_some()
}

/// The control points: four, three without a third power, two without a second one too.
fn graph(equation: &CubicCoefficients) -> Result<Vec<Point>> {
    for c in equation.x.iter().chain(&equation.y) {
        finite("coefficient", *c)?;
    }
    let lacks = |power: usize| equation.x[power] == 0.0 && equation.y[power] == 0.0;
    let axis = |coefficients: &[f64; 4]| {
        let [a, b, c, d] = *coefficients;
        let cubic = control_points(*coefficients);
        let points = match (lacks(0), lacks(1)) {
            (true, true) => vec![d, cubic[3]],
            (true, false) => vec![d, d + c / 2.0, cubic[3]],
            _ => cubic.to_vec(),
        };
        let decimals = [a, b, c, d].map(decimals_of).into_iter().max().unwrap_or(0);
        let slack = 4.0
            * f64::EPSILON
            * coefficients
                .iter()
                .fold(0.0, |most: f64, x| most.max(x.abs()));
        // What is level with an end but for rounding is, as a handle of a quarter.
        let ends = [d, cubic[3]].map(|x| decimal(x, decimals, slack));
        let level = |x: f64| {
            let near = ends.into_iter().find(|end| (x - end).abs() <= slack);
            near.unwrap_or_else(|| decimal(x, decimals, slack))
        };
        points.into_iter().map(level).collect()
    };
    let (x, y): (Vec<f64>, Vec<f64>) = (axis(&equation.x), axis(&equation.y));
    Ok(x.into_iter().zip(y).map(Point::from).collect())
}

/// The number with this many decimals, where it is that one but for rounding: points with few decimals have coefficients with as few.
fn decimal(x: f64, decimals: u8, slack: f64) -> f64 {
    let rounded = round(x, decimals.min(MOST_DECIMALS));
    if decimals <= MOST_DECIMALS && (x - rounded).abs() <= slack {
        rounded
    } else {
        x
    }
}
