//! The layout of a chart: axes, lines, names.

use kurbo::{Affine, Circle, Line, PathSeg, Point, Rect, Vec2};

use super::scale::{Axis, power_of_ten};
use super::spread::spread;
use super::{Chart, Names, Series};
use crate::curve::Curve;
use crate::number::{Precision, round};
use crate::picture::paint::Paint;
use crate::picture::scene::{Group, Mark, Pen};
use crate::picture::text::{Anchor, Text, width};

/// The sizes of words.
const TITLE: f64 = 15.0;
const BODY: f64 = 12.0;

/// How far apart the words at the ends of lines stand.
pub(super) const LABEL_STEP: f64 = 14.0;

/// Hundredths of a pixel are enough.
pub(super) const DECIMALS: u8 = 2;

const DOT_RADIUS: f64 = 2.5;
const LEADER_WIDTH: f64 = 0.8;

const INK: Paint = Paint::rgb(0x22, 0x22, 0x22);
const FRAME: Paint = Paint::rgb(0x55, 0x55, 0x55);
const GRID: Paint = Paint::rgb(0xe4, 0xe4, 0xe4);
const ZERO: Paint = Paint::rgb(0x99, 0x99, 0x99);
const JOINT: Paint = Paint::rgb(0xb0, 0xb0, 0xb0);
const JOINT_DASH: [f64; 2] = [2.0, 3.0];

/// What a chart of this size shows.
pub(super) fn groups(chart: &Chart, size: Vec2) -> Vec<Group> {
    let lines = || chart.series.iter().flat_map(Series::points);
    let points = || lines().chain(chart.control_points.iter().flatten());
    let mut sheet = ChartSheet {
        chart,
        x: Axis::new(chart.x_kind.clone(), points().map(|p| p.0), size.x / 90.0),
        y: Axis::new(chart.y_kind.clone(), points().map(|p| p.1), size.y / 70.0),
        size,
        frame: Rect::ZERO,
        groups: Vec::new(),
        words: Vec::new(),
    };
    sheet.draw();
    sheet.finish()
}

/// A group that much farther down.
pub(super) fn lowered(mut group: Group, by: f64) -> Group {
    if by == 0.0 {
        return group;
    }
    let down = Vec2::new(0.0, by);
    for mark in &mut group.marks {
        match mark {
            Mark::Curve(curve) => {
                let moved = curve.transformed(Affine::translate(down));
                *curve = moved.rounded(Precision::Fixed(DECIMALS), &[]);
            }
            Mark::Dot(dot) => dot.center = tidy(dot.center + down),
            Mark::Text(text) => text.at = tidy(text.at + down),
            Mark::Truth(_) | Mark::Path(_) | Mark::Arcs(_) => {}
        }
    }
    group
}

/// A chart while it is laid out.
struct ChartSheet<'a> {
    chart: &'a Chart,
    x: Axis,
    y: Axis,
    size: Vec2,
    /// The rectangle of the data.
    frame: Rect,
    groups: Vec<Group>,
    /// What stands above everything else.
    words: Vec<Mark>,
}

impl ChartSheet<'_> {
    fn draw(&mut self) {
        let legend_height = self.legend();
        let widest = |texts: &mut dyn Iterator<Item = &str>| {
            texts.map(|text| width(text, BODY)).fold(0.0, f64::max)
        };
        let ticks = self.y.ticks();
        let left = 44.0 + widest(&mut ticks.iter().map(|tick| tick.label.as_str()));
        let right = match self.chart.names {
            Names::Legend => 24.0,
            Names::AtEnds => 52.0 + widest(&mut self.chart.series.iter().map(|s| s.name.as_str())),
        };
        let top = 54.0 + legend_height;
        self.frame = Rect::new(
            left,
            top,
            (self.size.x - right).max(left + 10.0),
            (self.size.y - 52.0).max(top + 10.0),
        );
        if !self.chart.control_points.is_empty() {
            let scale = self.frame.width() / self.x.length();
            let scale = scale.min(self.frame.height() / self.y.length());
            self.frame.x1 = left + scale * self.x.length();
            self.frame.y0 = self.frame.y1 - scale * self.y.length();
        }
        let title = self.chart.title.as_str();
        let size = TITLE.min(TITLE * (self.size.x - 32.0) / width(title, TITLE).max(1.0));
        self.text((16.0, 26.0), title, size, Anchor::Start);
        self.axes();
        self.control_points();
        self.lines();
        if self.chart.names == Names::AtEnds {
            self.end_labels();
        }
    }

    fn finish(mut self) -> Vec<Group> {
        self.groups.push(Group {
            id: None,
            class: Some("words"),
            pen: Pen::filled(INK),
            marks: self.words,
        });
        self.groups
    }

    fn text(&mut self, at: impl Into<Point>, words: &str, size: f64, anchor: Anchor) {
        self.words.push(Mark::Text(Text {
            at: tidy(at.into()),
            words: words.to_owned(),
            size,
            anchor,
            upwards: false,
        }));
    }

    /// Adds a mark, to the group before where that is drawn alike.
    fn add(&mut self, class: &'static str, pen: &Pen, mark: Mark) {
        match self.groups.last_mut() {
            Some(last) if last.class == Some(class) && last.pen == *pen => last.marks.push(mark),
            _ => self.groups.push(Group {
                id: None,
                class: Some(class),
                pen: pen.clone(),
                marks: vec![mark],
            }),
        }
    }

    fn line(&mut self, class: &'static str, pen: &Pen, points: &[Point]) {
        let points: Vec<Point> = points.iter().map(|&p| tidy(p)).collect();
        let segments = points.windows(2);
        let curve = Curve {
            segments: segments
                .map(|pair| PathSeg::Line(Line::new(pair[0], pair[1])))
                .collect(),
            closed: false,
        };
        self.add(class, pen, Mark::Curve(curve));
    }

    /// The point of the sheet for a point of the data.
    fn place(&self, (x, y): (f64, f64)) -> Point {
        Point::new(
            self.frame.x0 + self.frame.width() * self.x.position(x),
            self.frame.y1 - self.frame.height() * self.y.position(y),
        )
    }

    /// Draws the legend and returns its height.
    fn legend(&mut self) -> f64 {
        if self.chart.names != Names::Legend {
            return 0.0;
        }
        let (mut x, mut y) = (16.0, 46.0);
        for series in &self.chart.series {
            let width = 34.0 + width(&series.name, BODY) + 22.0;
            if x + width > self.size.x && x > 16.0 {
                (x, y) = (16.0, y + 18.0);
            }
            let line = [Point::new(x, y - 4.0), Point::new(x + 28.0, y - 4.0)];
            self.line("legend", &series.pen, &line);
            self.text((x + 34.0, y), &series.name, BODY, Anchor::Start);
            x += width;
        }
        y - 26.0
    }

    fn axes(&mut self) {
        self.grid();
        let frame = self.frame;
        let pen = Pen::stroked(FRAME, 1.0);
        for tick in self.x.ticks() {
            let x = self.place((tick.value, 1.0)).x;
            let mark = [Point::new(x, frame.y1), Point::new(x, frame.y1 + 5.0)];
            self.line("frame", &pen, &mark);
            self.text((x, frame.y1 + 19.0), &tick.label, BODY, Anchor::Middle);
        }
        for tick in self.y.ticks() {
            let y = self.place((1.0, tick.value)).y;
            let long = if tick.label.is_empty() { 3.0 } else { 5.0 };
            let mark = [Point::new(frame.x0 - long, y), Point::new(frame.x0, y)];
            self.line("frame", &pen, &mark);
            if !tick.label.is_empty() {
                self.text((frame.x0 - 9.0, y + 4.0), &tick.label, BODY, Anchor::End);
            }
        }
        let corners = [
            (frame.x0, frame.y0),
            (frame.x0, frame.y1),
            (frame.x1, frame.y1),
        ];
        self.line("frame", &pen, &corners.map(Point::from));
        self.axis_titles();
    }

    /// The lines beneath the data: round numbers, the zero, the joints.
    fn grid(&mut self) {
        let frame = self.frame;
        let upright = |x| [Point::new(x, frame.y0), Point::new(x, frame.y1)];
        let level = |y| [Point::new(frame.x0, y), Point::new(frame.x1, y)];
        let pen = Pen::stroked(GRID, 1.0);
        for tick in self.x.ticks() {
            let x = self.place((tick.value, 1.0)).x;
            self.line("grid", &pen, &upright(x));
        }
        let labelled = |tick: &super::scale::Tick| !tick.label.is_empty();
        let (zero, others): (Vec<_>, Vec<_>) = self
            .y
            .ticks()
            .into_iter()
            .filter(labelled)
            .partition(|tick| tick.value == 0.0);
        for (ticks, class, paint) in [(others, "grid", GRID), (zero, "zero", ZERO)] {
            for tick in ticks {
                let y = self.place((1.0, tick.value)).y;
                self.line(class, &Pen::stroked(paint, 1.0), &level(y));
            }
        }
        for &mark in &self.chart.marks {
            let x = self.place((mark, 1.0)).x;
            self.line("joints", &joint(), &upright(x));
        }
    }

    fn axis_titles(&mut self) {
        let frame = self.frame;
        let below = Point::new(frame.center().x, self.size.y - 12.0);
        self.text(below, &self.chart.x_title, BODY, Anchor::Middle);
        if self.y.exponent != 0 {
            let times = format!("×{}", power_of_ten(self.y.exponent));
            self.text((frame.x0, frame.y0 - 7.0), &times, BODY, Anchor::End);
        }
        // As high as there is room below the title and the legend, where it can stand beside the middle of the axis.
        let (top, bottom) = (frame.y0 - 16.0, self.size.y - 8.0);
        let long = width(&self.chart.y_title, BODY).max(1.0);
        let room = (bottom - top) / long;
        let half = long * room.min(1.0) / 2.0;
        let middle = frame.center().y.clamp(top + half, bottom - half + 1e-9);
        self.words.push(Mark::Text(Text {
            at: tidy(Point::new(20.0, middle)),
            words: self.chart.y_title.clone(),
            size: round(BODY * room.min(1.0), DECIMALS),
            anchor: Anchor::Middle,
            upwards: true,
        }));
    }

    fn control_points(&mut self) {
        for points in &self.chart.control_points {
            let points: Vec<Point> = points.iter().map(|&p| self.place(p)).collect();
            self.line("handles", &Pen::stroked(FRAME, LEADER_WIDTH), &points);
            for at in points {
                let dot = Circle::new(tidy(at), DOT_RADIUS);
                self.add("points", &Pen::filled(FRAME), Mark::Dot(dot));
            }
        }
    }

    fn lines(&mut self) {
        for series in &self.chart.series {
            for part in &series.parts {
                let shown = part.iter().filter(|p| self.y.shows(p.1));
                let points: Vec<Point> = shown.map(|&p| self.place(p)).collect();
                if points.len() > 1 {
                    self.line("line", &series.pen, &points);
                }
                if series.dots {
                    let pen = Pen::filled(series.pen.stroke);
                    for at in points {
                        let dot = Circle::new(tidy(at), DOT_RADIUS);
                        self.add("dots", &pen, Mark::Dot(dot));
                    }
                }
            }
        }
    }

    /// Names at the right ends of the lines, moved apart where they would cover one another, each led to its line.
    fn end_labels(&mut self) {
        let mut ends: Vec<(Point, &Series)> = self
            .chart
            .series
            .iter()
            .filter_map(|series| {
                let last = series.points().filter(|p| self.y.shows(p.1)).last()?;
                Some((self.place(*last), series))
            })
            .collect();
        ends.sort_by(|a, b| a.0.y.total_cmp(&b.0.y));
        let wished: Vec<f64> = ends.iter().map(|(end, _)| end.y).collect();
        let heights = spread(&wished, LABEL_STEP, self.frame.y0, self.frame.y1);
        let x = self.frame.x1;
        let ends_at = ends.iter().map(|(end, _)| end.x).fold(0.0, f64::max);
        for ((end, series), y) in ends.into_iter().zip(heights) {
            // A line that ends early is led far, and faintly.
            let leader = if end.x < ends_at - 1.0 {
                joint()
            } else {
                Pen::stroked(series.pen.stroke, LEADER_WIDTH)
            };
            let level = Point::new(end.x.max(x), end.y);
            let (from, to) = (Point::new(x + 20.0, y), Point::new(x + 40.0, y));
            self.line("leader", &leader, &[end, level, from]);
            self.line("legend", &series.pen, &[from, to]);
            self.text((x + 44.0, y + 4.0), &series.name, BODY, Anchor::Start);
        }
    }
}

/// The pen of the lines at joints, and of what leads far.
fn joint() -> Pen {
    Pen {
        dash: JOINT_DASH.to_vec(),
        ..Pen::stroked(JOINT, 1.0)
    }
}

fn tidy(p: Point) -> Point {
    Point::new(round(p.x, DECIMALS), round(p.y, DECIMALS))
}
