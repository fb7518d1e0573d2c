//! DXF of AutoCAD 2000 (AC1015): a SPLINE with the very control points for each curve, and lines and circular arcs as what they are.
//!
//! A chain of n Béziers of degree d is the B-spline of the same degree whose knots are 0 and n, d + 1 times each, and 1 ... n - 1, d
//! times each: its control points are those of the Béziers, shared ends once.

use core::fmt::Write as _;
use std::borrow::Cow;
use std::collections::HashSet;

use kurbo::{ParamCurve as _, PathSeg, Point, Rect};

use crate::angle::Angle;
use crate::course::{CircularArc, Course, CourseStep, within_a_turn};
use crate::curve::{Curve, control_points};
use crate::number::{round, text};

/// What a reader needs around the entities, a code and its value a line: the tables, the blocks and the layouts of a drawing.
const FRAME: &str = include_str!("dxf/frame.txt");

/// The first handle that the frame leaves free.
const FIRST_HANDLE: u32 = 0x1C;

/// The block record of the model space, to which entities belong.
const MODEL_SPACE: &str = "11";
/// The table of layers.
const LAYER_TABLE: &str = "7";
/// The layer that every drawing has.
const FIRST_LAYER: &str = "0";

/// Decimals of a bulge: it is computed to one or two units of the last place of 1.
const BULGE_DECIMALS: u8 = 15;

/// An angle of more decimals is not given in so many.
const FEW_DECIMALS: u8 = 10;

/// What an entity, or several of them, draw.
#[derive(Debug, Clone, PartialEq)]
pub enum Trace<'a> {
    /// Béziers, as SPLINE.
    Curve(&'a Curve),
    /// Lines and circular arcs, as LINE, LWPOLYLINE, ARC or CIRCLE; lines in place of elliptical arcs.
    Course(Course),
}

/// A drawing of traces, each on the layer of this name or, without one, on layer 0.
#[must_use]
pub fn drawing(title: &str, traces: &[(Option<&str>, Trace<'_>)]) -> String {
    let mut out = Tags {
        text: String::new(),
        handle: FIRST_HANDLE,
    };
    let mut layers = vec![FIRST_LAYER];
    let mut known = HashSet::from([FIRST_LAYER]);
    let mut bounds: Option<Rect> = None;
    let names = traces
        .iter()
        .map(|(layer, _)| layer.map_or(Cow::Borrowed(FIRST_LAYER), legal));
    let names: Vec<_> = names.collect();
    for (layer, (_, trace)) in names.iter().zip(traces) {
        let layer: &str = layer;
        if known.insert(layer) {
            layers.push(layer);
        }
        match trace {
            Trace::Curve(curve) => out.curve(layer, curve),
            Trace::Course(course) => out.course(layer, course),
        }
        bounds = union(bounds, extent(trace));
    }
    let entities = core::mem::take(&mut out.text);
    for layer in &layers {
        out.layer(layer);
    }
    let values = values(bounds.unwrap_or_default(), layers.len(), out.handle);
    let mut file = tags(&format!("999 {title}\n"));
    for line in FRAME.lines() {
        match line {
            "@LAYERS@" => file.push_str(&out.text),
            "@ENTITIES@" => file.push_str(&entities),
            _ => file.push_str(&tags(&fill(line, &values))),
        }
    }
    file
}

/// The name of a layer, with _ for what AutoCAD 2000 takes in none.
fn legal(name: &str) -> Cow<'_, str> {
    let wrong = |c: char| !(' '..='~').contains(&c) || "<>/\\\":;?*|,=`".contains(c);
    match name {
        "" => Cow::Borrowed(FIRST_LAYER),
        _ if name.contains(wrong) => Cow::Owned(name.replace(wrong, "_")),
        _ => Cow::Borrowed(name),
    }
}

/// What the frame says of the drawing: its extent, how many layers it has, the next free handle.
fn values(bounds: Rect, layers: usize, free: u32) -> [(&'static str, String); 9] {
    let height = bounds.height().max(bounds.width() / 1.5);
    [
        ("@X0@", real(bounds.x0)),
        ("@Y0@", real(bounds.y0)),
        ("@X1@", real(bounds.x1)),
        ("@Y1@", real(bounds.y1)),
        ("@CX@", real(bounds.center().x)),
        ("@CY@", real(bounds.center().y)),
        ("@HEIGHT@", real(if height > 0.0 { height } else { 1.0 })),
        ("@LAYERCOUNT@", layers.to_string()),
        ("@SEED@", format!("{free:X}")),
    ]
}

/// The line with values in the place of their names.
fn fill(line: &str, values: &[(&str, String)]) -> String {
    let found = values.iter().find(|(name, _)| line.ends_with(name));
    found.map_or_else(
        || line.to_owned(),
        |(name, value)| line.replace(name, value),
    )
}

/// Codes and values, which stand on one line each here, as the file has them: a line each.
fn tags(text: &str) -> String {
    let pair = |line: &str| {
        let (code, value) = line.split_once(' ').unwrap_or((line, ""));
        format!("{code:>3}\n{value}\n")
    };
    text.lines().map(pair).collect()
}

/// Entities while they are written.
struct Tags {
    text: String,
    /// The next handle.
    handle: u32,
}

impl Tags {
    fn tag(&mut self, code: u16, value: impl core::fmt::Display) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "{code:>3}\n{value}");
    }

    /// A number with its code.
    fn real(&mut self, code: u16, value: f64) {
        self.tag(code, real(value));
    }

    fn point(&mut self, p: Point) {
        self.real(10, p.x);
        self.real(20, p.y);
        self.real(30, 0.0);
    }

    fn begin(&mut self, name: &str, owner: &str) {
        let handle = self.handle;
        self.handle += 1;
        self.tag(0, name);
        self.tag(5, format_args!("{handle:X}"));
        self.tag(330, owner);
    }

    fn entity(&mut self, name: &str, layer: &str, class: &str) {
        self.begin(name, MODEL_SPACE);
        self.tag(100, "AcDbEntity");
        self.tag(8, layer);
        self.tag(100, class);
    }

    fn layer(&mut self, name: &str) {
        self.begin("LAYER", LAYER_TABLE);
        self.tag(100, "AcDbSymbolTableRecord");
        self.tag(100, "AcDbLayerTableRecord");
        self.tag(2, name);
        self.tag(70, 0);
        self.tag(62, 7);
        self.tag(6, "Continuous");
    }

    /// A SPLINE for each run of segments of one degree; runs of lines as lines.
    fn curve(&mut self, layer: &str, curve: &Curve) {
        if let Some(course) = Course::of_lines(curve) {
            return self.course(layer, &course);
        }
        let same = |a: &PathSeg, b: &PathSeg| degree(a) == degree(b);
        for run in curve.segments.chunk_by(same) {
            let lines = Curve {
                segments: run.to_vec(),
                closed: false,
            };
            match Course::of_lines(&lines) {
                Some(course) => self.course(layer, &course),
                None => self.spline(layer, run),
            }
        }
    }

    fn spline(&mut self, layer: &str, segments: &[PathSeg]) {
        let Some(first) = segments.first() else {
            return;
        };
        let (degree, count) = (degree(first), segments.len());
        self.entity("SPLINE", layer, "AcDbSpline");
        for (code, value) in [(210, 0.0), (220, 0.0), (230, 1.0)] {
            self.real(code, value);
        }
        // Planar. A closed one is not marked as such: readers take that for a periodic spline, which has other knots.
        self.tag(70, 8);
        self.tag(71, degree);
        self.tag(72, degree * (count + 1) + 2);
        self.tag(73, degree * count + 1);
        self.tag(74, 0);
        self.real(40, 0.0);
        for knot in 0..=count {
            for _ in 0..degree {
                self.real(40, knot as f64);
            }
        }
        self.real(40, count as f64);
        self.point(first.start());
        for p in segments
            .iter()
            .flat_map(|segment| control_points(segment).into_iter().skip(1))
        {
            self.point(p);
        }
    }

    fn course(&mut self, layer: &str, course: &Course) {
        match course.steps.as_slice() {
            [] => {}
            [CourseStep::Line(to)] => {
                self.entity("LINE", layer, "AcDbLine");
                self.point(course.start);
                for (code, value) in [(11, to.x), (21, to.y), (31, 0.0)] {
                    self.real(code, value);
                }
            }
            [CourseStep::Arc(arc)] if arc.is_circle() => {
                self.entity("CIRCLE", layer, "AcDbCircle");
                self.circle(arc);
            }
            [CourseStep::Arc(arc)] if !arc.ends_given => {
                self.entity("ARC", layer, "AcDbCircle");
                self.circle(arc);
                self.tag(100, "AcDbArc");
                // Always counter-clockwise.
                let (start, sweep) = (arc.start.degrees(), arc.sweep.degrees());
                for (code, angle) in [
                    (50, start.min(start + sweep)),
                    (51, start.max(start + sweep)),
                ] {
                    self.real(code, without_noise(within_a_turn(angle)));
                }
            }
            steps => self.polyline(layer, course, steps),
        }
    }

    fn circle(&mut self, arc: &CircularArc) {
        self.point(arc.center);
        self.real(40, arc.radius);
    }

    /// A LWPOLYLINE, the bulge of each arc at its first vertex; a whole turn within it becomes two halves.
    fn polyline(&mut self, layer: &str, course: &Course, steps: &[CourseStep]) {
        let mut vertices = vec![(course.start, 0.0)];
        let mut leave = |bulge: f64, to: Point| {
            if let Some(last) = vertices.last_mut() {
                last.1 = bulge;
            }
            vertices.push((to, 0.0));
        };
        for step in steps {
            match step {
                CourseStep::Line(_) | CourseStep::Elliptical(_) => leave(0.0, step.to()),
                CourseStep::Arc(arc) if arc.is_circle() => {
                    let half = arc.sweep.degrees().signum();
                    leave(half, arc.point(0.5));
                    leave(half, arc.to);
                }
                CourseStep::Arc(arc) => leave(round(arc.bulge(), BULGE_DECIMALS), arc.to),
            }
        }
        let closed = course.closed && vertices.len() > 2;
        if closed {
            vertices.pop();
        }
        self.entity("LWPOLYLINE", layer, "AcDbPolyline");
        self.tag(90, vertices.len());
        self.tag(70, u8::from(closed));
        for (p, bulge) in vertices {
            self.real(10, p.x);
            self.real(20, p.y);
            if bulge != 0.0 {
                self.real(42, bulge);
            }
        }
    }
}

/// The number of few decimals that an angle within a turn is but for the noise of sums.
fn without_noise(angle: f64) -> f64 {
    let few = round(angle, FEW_DECIMALS);
    if (few - angle).abs() <= 2.0 * 360.0 * f64::EPSILON {
        few
    } else {
        angle
    }
}

const fn degree(segment: &PathSeg) -> usize {
    match segment {
        PathSeg::Line(_) => 1,
        PathSeg::Quad(_) => 2,
        PathSeg::Cubic(_) => 3,
    }
}

/// A number as readers of DXF expect it: with a point.
fn real(x: f64) -> String {
    let digits = text(x);
    if digits.contains('.') {
        digits
    } else {
        digits + ".0"
    }
}

/// The rectangle around what is drawn.
fn extent(trace: &Trace<'_>) -> Option<Rect> {
    match trace {
        Trace::Curve(curve) => curve.bounding_box(),
        Trace::Course(course) => {
            let start = Rect::from_points(course.start, course.start);
            let steps = course.steps.iter().map(|step| match step {
                CourseStep::Line(_) | CourseStep::Elliptical(_) => {
                    Rect::from_points(step.to(), step.to())
                }
                CourseStep::Arc(arc) => around(arc),
            });
            Some(steps.fold(start, |all, step| all.union(step)))
        }
    }
}

/// The rectangle around an arc, but for its start: around its end and where it turns back in x and in y.
fn around(arc: &CircularArc) -> Rect {
    let (start, sweep) = (arc.start.degrees(), arc.sweep.degrees());
    let turns = [0.0, 90.0, 180.0, 270.0].into_iter().filter(|angle| {
        let ahead = (angle - start) * sweep.signum();
        ahead.rem_euclid(360.0) <= sweep.abs()
    });
    let end = Rect::from_points(arc.to, arc.to);
    turns.fold(end, |all, angle| {
        all.union_pt(arc.center + arc.radius * Angle::from_degrees(angle).direction())
    })
}

fn union(a: Option<Rect>, b: Option<Rect>) -> Option<Rect> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.union(b)),
        (a, b) => a.or(b),
    }
}

#[cfg(test)]
mod tests;
