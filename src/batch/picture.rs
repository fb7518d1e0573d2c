//! All lines as one picture.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::io::{self, BufRead as _, BufReader, Read};

use kurbo::Affine;

use super::lines::text_of;
use super::spec::{LineContent, Spec};
use super::{BYTE_ORDER_MARK, LONGEST_LINE, OnError, Options, Summary, too_long, too_much, worsen};
use crate::approximate::{self, approximate};
use crate::arcs;
use crate::contour::{BezierTarget, Contour, Step, draw};
use crate::course::Course;
use crate::error::{Error, FormatError, PictureError, Remedy, Result};
use crate::joints::Cut;
use crate::method::Rule;
use crate::number::Precision;
use crate::picture::figure::{Approximated, Figure, Layer};
use crate::shape::Shape;
use crate::write::dxf::{self, Trace};
use crate::write::{self, Format, Image, Writable};

/// The most shapes of one picture.
pub const MOST_SHAPES: usize = 100_000;

/// The most segments of one picture, and of one of its shapes.
const MOST_SEGMENTS: usize = 1_000_000;

/// All lines as one picture, in their order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Picture {
    /// The shapes, each a layer.
    pub figure: Figure,
    /// The lines and circular arcs of each shape that is an arc or a path of such, and whose line and options ask for no Béziers.
    pub courses: Vec<Option<Vec<Course>>>,
    /// How the run went.
    pub summary: Summary,
}

impl Writable for Picture {
    fn figure(&self) -> Figure {
        self.figure.clone()
    }

    #[cfg(feature = "serde")]
    fn json(&self) -> Result<String> {
        Err(Error::Format {
            format: Format::Json.name(),
            why: FormatError::Picture,
            remedy: Remedy::LineByLine,
        })
    }
}

impl Picture {
    /// Adds what the last line that was read draws; so many curves stand before it.
    fn add(&mut self, found: LineDrawing, curves: &mut usize) {
        let counted = |truth: Approximated| Approximated {
            curve: *curves + truth.curve,
            ..truth
        };
        self.figure
            .truths
            .extend(found.truths.into_iter().map(counted));
        *curves += found.layer.curves.len();
        worsen(&mut self.summary.worst, self.summary.lines, found.peak);
        self.courses.push(found.courses);
        self.figure.layers.push(found.layer);
    }

    /// A DXF file, each shape on a layer of its id: lines, arcs and bulges themselves where [`Picture::courses`] has them.
    #[must_use]
    pub fn dxf(&self) -> String {
        let shapes = self.figure.layers.iter().zip(&self.courses);
        let traces = shapes.flat_map(|(layer, courses)| {
            let id = layer.id.as_deref();
            let traces: Vec<Trace> = match courses {
                Some(courses) => courses.iter().cloned().map(Trace::Course).collect(),
                None => layer.curves.iter().map(Trace::Curve).collect(),
            };
            traces.into_iter().map(move |trace| (id, trace))
        });
        let traces: Vec<_> = traces.collect();
        dxf::drawing(&self.figure.title, &traces)
    }
}

/// Draws every line of `input` into one picture; `complain` gets the number of each line that cannot be drawn. With
/// [`OnError::Stop`] the first of them ends the run.
///
/// # Errors
///
/// Where reading fails, and [`io::ErrorKind::InvalidData`] for a line longer than 4 MiB and for more than [`MOST_SHAPES`] shapes or a
/// million segments: its message begins with the number of the line.
///
/// ```
/// use curveto::batch::{Options, figure};
/// let lines = "circle 0 0 5\n{\"id\": \"a\", \"circle\": {\"radius\": 2}, \"fill\": \"red\"}\n";
/// let picture = figure(lines.as_bytes(), &Options::default(), |_, _| ())?;
/// assert_eq!(picture.figure.layers[1].id.as_deref(), Some("a"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn figure(
    input: impl Read,
    options: &Options,
    mut complain: impl FnMut(u64, &Error),
) -> io::Result<Picture> {
    let exact = options.rule == Rule::default() && options.cut == Cut::Quarters;
    let mut picture = Picture::default();
    let mut input = BufReader::new(input);
    let (mut line, mut curves, mut segments) = (Vec::new(), 0, 0);
    let mut ids = HashMap::new();
    loop {
        line.clear();
        let most = LONGEST_LINE as u64 + 1;
        if input.by_ref().take(most).read_until(b'\n', &mut line)? == 0 {
            break;
        }
        if line.len() > LONGEST_LINE {
            return Err(too_long(picture.summary.lines + 1));
        }
        let bytes = match line.strip_prefix(BYTE_ORDER_MARK) {
            Some(rest) if picture.summary.lines == 0 => rest,
            _ => &line,
        };
        picture.summary.lines += 1;
        let found = shape(bytes, options, exact).and_then(|found| {
            if options.format == Format::Image(Image::Svg) {
                check_id(&mut ids, found.as_ref(), picture.summary.lines)?;
            }
            Ok(found)
        });
        match found {
            Ok(Some(found)) => {
                let drawn = &found.layer.curves;
                segments += drawn.iter().map(|c| c.segments.len()).sum::<usize>();
                picture.add(found, &mut curves);
            }
            Ok(None) => {}
            Err(error) => {
                complain(picture.summary.lines, &error);
                picture.summary.failed += 1;
                if options.on_error == OnError::Stop {
                    break;
                }
            }
        }
        if picture.figure.layers.len() > MOST_SHAPES || segments > MOST_SEGMENTS {
            return Err(too_much(
                picture.summary.lines,
                "a picture has at most 100000 shapes and 1000000 segments; path data has no such limit",
            ));
        }
    }
    let worst = picture.summary.worst.map_or(0.0, |(_, peak)| peak);
    describe(&mut picture.figure, worst);
    Ok(picture)
}

/// Refuses the id of an earlier line; `ids` holds these with their lines.
fn check_id(ids: &mut HashMap<String, u64>, found: Option<&LineDrawing>, line: u64) -> Result<()> {
    let Some(id) = found.and_then(|found| found.layer.id.clone()) else {
        return Ok(());
    };
    match ids.entry(id) {
        Entry::Vacant(free) => {
            free.insert(line);
            Ok(())
        }
        Entry::Occupied(taken) => Err(Error::Picture(PictureError::SameId {
            id: taken.key().clone(),
            line: *taken.get(),
        })),
    }
}

fn describe(figure: &mut Figure, worst: f64) {
    use crate::number::{counted, rounded_up, significant};
    let shapes = counted(figure.layers.len(), "shape");
    figure.name = "batch";
    figure.title.clone_from(&shapes);
    figure.description = if worst > 0.0 {
        let peak = significant(rounded_up(worst, 3), 3);
        format!("{shapes}, each within {peak} of its true shape")
    } else {
        shapes + ", exact"
    };
}

/// What a line draws.
struct LineDrawing {
    layer: Layer,
    peak: f64,
    /// The true shapes of its curves, counted among themselves.
    truths: Vec<Approximated>,
    /// Its lines and circular arcs, where it is such.
    courses: Option<Vec<Course>>,
}

/// Draws a line; `None` for a blank one.
fn shape(line: &[u8], options: &Options, exact: bool) -> Result<Option<LineDrawing>> {
    let Some(text) = text_of(line)? else {
        return Ok(None);
    };
    let spec = Spec::parse(text)?;
    let exact = exact && spec.method.is_none() && spec.cut.is_none();
    let how = approximate::Options {
        rule: spec.method.map_or(options.rule, Rule::Method),
        cut: spec.cut.unwrap_or_else(|| options.cut.clone()),
        precision: options.precision,
        transform: Affine::IDENTITY,
    };
    let (curves, peak, truths, courses) = match &spec.subject {
        LineContent::Shape(shape) => {
            let drawing = approximate(shape, &how)?;
            let course = match (shape, &drawing.outline) {
                (Shape::Arc(_), Some(outline)) => Course::of_arc(outline),
                _ => None,
            };
            let courses = course.filter(|_| exact).map(|course| vec![course]);
            let truths = Approximated::of_drawing(&drawing).into_iter().collect();
            (vec![drawing.curve], drawing.error.peak(), truths, courses)
        }
        LineContent::Path(contours) => {
            let drawing = draw(contours, BezierTarget::Beziers, &how)?;
            let courses = (exact && contours.iter().all(is_course))
                .then(|| arcs::arcs(contours, &arcs::Options::default()).ok())
                .flatten()
                .map(|found| found.courses().cloned().collect());
            let peak = drawing.error().peak();
            let truths = Approximated::of_path(&drawing).collect();
            (drawing.curves().cloned().collect(), peak, truths, courses)
        }
    };
    let (courses, moved) = courses
        .and_then(|courses: Vec<Course>| rounded(&courses, options.precision))
        .unzip();
    // The error of what the file holds.
    let peak = match moved {
        Some(moved) if options.format == Format::Dxf => moved,
        _ => peak,
    };
    let layer = Layer {
        curves,
        joined: true,
        id: spec.id.map(name),
        look: spec.look,
        ..Layer::default()
    };
    Ok(Some(LineDrawing {
        layer,
        peak,
        truths,
        courses,
    }))
}

/// Courses as DXF holds them, and how far rounding moves them at most.
fn rounded(courses: &[Course], precision: Option<Precision>) -> Option<(Vec<Course>, f64)> {
    let precision = precision.unwrap_or(Precision::Full);
    let rounded = courses
        .iter()
        .map(|course| course.rounded_for_cad(precision));
    let (courses, moved): (_, Vec<f64>) = rounded.collect::<Option<Vec<_>>>()?.into_iter().unzip();
    Some((courses, moved.into_iter().fold(0.0, f64::max)))
}

/// Whether a contour is lines and circular arcs.
fn is_course(contour: &Contour) -> bool {
    contour.steps.iter().all(|step| match step {
        Step::Given(segment) => matches!(segment, kurbo::PathSeg::Line(_)),
        Step::Arc(arc) => Course::of_arc(&arc.outline()).is_some(),
    })
}

/// The text of an id: a string without its quotes, all else as it stands.
fn name(raw: &str) -> String {
    let text = serde_json::from_str::<String>(raw).unwrap_or_else(|_| raw.to_owned());
    write::name(&text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(lines: &str) -> Picture {
        figure(lines.as_bytes(), &Options::default(), |line, error| {
            panic!("{line}: {error}")
        })
        .unwrap()
    }

    #[test]
    fn a_picture_says_what_it_is() {
        for (lines, title, description) in [
            ("", "0 shapes", "0 shapes, exact"),
            ("path M0 0L1 1", "1 shape", "1 shape, exact"),
            (
                "circle 0 0 1\npath M0 0L1 1\ncircle 0 0 2",
                "3 shapes",
                "3 shapes, each within 0.000393 of its true shape",
            ),
        ] {
            let figure = drawn(lines).figure;
            assert_eq!(
                (figure.title.as_str(), figure.description.as_str()),
                (title, description)
            );
        }
        let refused = drawn("circle 0 0 1").json();
        assert!(matches!(
            refused,
            Err(Error::Format {
                format: "json",
                why: FormatError::Picture,
                remedy: Remedy::LineByLine,
            })
        ));
    }

    #[test]
    fn true_shapes_belong_to_their_curves() {
        let figure =
            drawn("circle 0 0 1\npath M0 0A1 1 0 0 1 1 1M5 5A1 1 0 0 1 6 6\ncircle 0 0 2").figure;
        let curves: Vec<usize> = figure.truths.iter().map(|truth| truth.curve).collect();
        assert_eq!(curves, [0, 1, 2, 3]);
    }

    #[test]
    fn courses_are_those_of_lines_and_circular_arcs() {
        let courses = |line: &str| drawn(line).courses[0].as_ref().map(Vec::len);
        assert_eq!(courses("arc 0 0 5 0 90"), Some(1));
        assert_eq!(courses("arc 0 0 5 4 0 0 90"), None);
        assert_eq!(courses("path M0 0A5 5 0 0 1 4 4L9 9"), Some(1));
        assert_eq!(courses("path M0 0A5 3 0 0 1 4 4L9 9"), None);
        assert_eq!(courses("path M0 0C1 1 2 1 3 0"), None);
        assert_eq!(courses("circle 0 0 5"), None);
    }

    #[test]
    fn a_line_has_its_limit_and_a_byte_order_mark_its_place() {
        let comment = |length: usize| {
            let mut line = vec![b'#'; length - 1];
            line.push(b'\n');
            figure(&line[..], &Options::default(), |_, _| ()).map(|picture| picture.summary.lines)
        };
        assert_eq!(comment(LONGEST_LINE).unwrap(), 1);
        assert_eq!(
            comment(LONGEST_LINE + 1).unwrap_err().kind(),
            io::ErrorKind::InvalidData
        );
        let mut failed = Vec::new();
        let lines = "\u{feff}#\n\u{feff}#\n";
        figure(lines.as_bytes(), &Options::default(), |line, _| {
            failed.push(line);
        })
        .unwrap();
        assert_eq!(failed, [2]);
    }
}
