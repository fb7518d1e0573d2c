//! Path data: every arc command becomes cubics in place, all other bytes stay.
//!
//! What has to be minded: a smooth `S` behind an arc takes the current point for its first control point, but behind a cubic it
//! would reflect; a repetition without a letter must not change its command; numbers are rounded on a grid that begins at
//! the arc's own start, so nothing accumulates; the end point keeps the text that the file gave it.

use core::ops::Range;

use kurbo::{Point, Vec2};

use super::bezier::{self, Beziers};
use super::curve_text::{Body, absolute, relative};
use super::memo::Memo;
use super::number::{After, Decimal};
use super::path_data::{Segment, Segments};
use super::{Options, Reason};
use crate::Angle;
use crate::shape::endpoint::SvgArc;

/// What a path may not lose, and how it is drawn.
#[derive(Debug, Clone, Copy)]
pub(super) struct Context<'a> {
    pub(super) options: &'a Options,
    /// Whether a marker may stand on inner vertices, so that none may be added.
    pub(super) vertices_show: bool,
}

/// What became of one path.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Outcome {
    /// Arc commands replaced.
    pub(super) arcs: usize,
    /// Smooth commands that had to be spelled out.
    pub(super) smooth: usize,
}

/// Receives the edits, in order, and the notes with their place in the data.
pub(super) trait Sink {
    /// The bytes of `range` become `text`.
    fn edit(&mut self, range: Range<usize>, text: &[u8]);
    /// The arc at `at` is left.
    fn note(&mut self, at: usize, reason: Reason);
}

/// Buffers that outlive one path.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    text: Vec<u8>,
    pub(super) body: Body,
    pub(super) beziers: Beziers,
    pub(super) memo: Memo,
}

/// Rewrites the arcs of `data`.
pub(super) fn rewrite(
    data: &str,
    context: Context<'_>,
    scratch: &mut Scratch,
    sink: &mut impl Sink,
) -> Outcome {
    let mut segments = Segments::new(data);
    let mut writer = Writer {
        data,
        context,
        scratch,
        sink,
        // Relative arcs need no current point, and most paths have no other ones.
        follows_point: memchr::memchr3(b'A', b'S', b'T', data.as_bytes()).is_some(),
        point: Vec2::ZERO,
        subpath: Vec2::ZERO,
        previous: None,
        effective: 0,
        after: After::Letter,
        respell: 0,
        outcome: Outcome::default(),
    };
    while let Some(segment) = segments.next() {
        writer.segment(&segment, &segments);
    }
    if let Some(at) = segments.error()
        && data.as_bytes()[at..]
            .iter()
            .any(|b| matches!(b, b'a' | b'A'))
    {
        writer.sink.note(at, Reason::PathError);
    }
    writer.outcome
}

struct Writer<'a, 'b, S> {
    data: &'a str,
    context: Context<'a>,
    scratch: &'b mut Scratch,
    sink: &'b mut S,
    /// Whether the current point is followed.
    follows_point: bool,
    /// The current point and the start of the subpath, as a renderer adds them up.
    point: Vec2,
    subpath: Vec2,
    previous: Option<Segment>,
    /// The command letter that a number without one would repeat in the output; 0 where the letter has to be written.
    effective: u8,
    after: After,
    /// The smooth command that would take up a control point of the Bézier that was an arc, if the output ends with one.
    respell: u8,
    outcome: Outcome,
}

impl<S: Sink> Writer<'_, '_, S> {
    fn segment(&mut self, segment: &Segment, behind: &Segments<'_>) {
        match segment.kind() {
            b'a' => self.arc(segment, behind),
            kind if kind == self.respell => self.smooth(segment),
            _ => self.keep(segment),
        }
        if self.follows_point {
            self.advance(segment);
        }
        self.previous = Some(*segment);
    }

    /// Moves the current point.
    fn advance(&mut self, segment: &Segment) {
        let base = if segment.is_relative() {
            self.point
        } else {
            Vec2::ZERO
        };
        if segment.kind() == b'z' {
            self.point = self.subpath;
            return;
        }
        // What is beyond numbers here is so for every arc behind it: they are left.
        let [x, y] = segment.end_values(self.data).unwrap_or([f64::NAN; 2]);
        self.point = match segment.kind() {
            b'h' => Vec2::new(base.x + x, self.point.y),
            b'v' => Vec2::new(self.point.x, base.y + x),
            _ => base + Vec2::new(x, y),
        };
        if segment.kind() == b'm' {
            self.subpath = self.point;
        }
    }

    /// The segment stays; its letter is written where the output's last command is another one.
    fn keep(&mut self, segment: &Segment) {
        if !segment.explicit && self.effective != segment.letter {
            let range = self.behind_previous(segment)..segment.arguments;
            self.sink.edit(range, &[segment.letter]);
        }
        self.effective = match segment.letter {
            b'm' => b'l',
            b'M' => b'L',
            letter => letter,
        };
        self.respell = 0;
    }

    fn behind_previous(&self, segment: &Segment) -> usize {
        self.previous
            .as_ref()
            .map_or(segment.start, |previous| previous.end)
    }

    /// `S` behind what was an arc: its first control point is the current point, which only `C` can say now. (`T` and `Q` for a
    /// method that draws quadratics.)
    fn smooth(&mut self, segment: &Segment) {
        let text = &mut self.scratch.text;
        text.clear();
        let full = if segment.kind() == b's' { b'c' } else { b'q' };
        let full = if segment.is_relative() {
            full
        } else {
            full.to_ascii_uppercase()
        };
        text.push(full);
        let mut after = After::Letter;
        match &self.previous {
            _ if segment.is_relative() => after.push_text(text, b"0 0"),
            Some(arc) if !arc.is_relative() => {
                after.push_text(text, &self.data.as_bytes()[arc.tail..arc.end]);
            }
            _ => {
                let size = self.point.x.abs().max(self.point.y.abs()).max(1e-9);
                let decimals = (12 - size.log10().ceil() as i32).max(0).unsigned_abs();
                after.push(text, Decimal::round(self.point.x, decimals));
                after.push(text, Decimal::round(self.point.y, decimals));
            }
        }
        after.push_text(
            text,
            &self.data.as_bytes()[segment.arguments..=segment.arguments],
        );
        self.sink.edit(segment.start..segment.arguments + 1, text);
        self.outcome.smooth += 1;
        self.effective = full;
        self.respell = 0;
    }

    fn arc(&mut self, segment: &Segment, behind: &Segments<'_>) {
        let range = if segment.explicit {
            segment.start
        } else {
            self.behind_previous(segment)
        }..segment.end;
        let replaced = if may_be_smooth(&self.data.as_bytes()[segment.end..]) && is_broken(behind) {
            Err(Reason::PathErrorBehindArc)
        } else if self.recall(segment) {
            self.join(segment)
        } else {
            self.draw(segment, behind)
        };
        match replaced {
            Ok(respell) => {
                self.sink.edit(range, &self.scratch.text);
                self.outcome.arcs += 1;
                self.respell = respell;
            }
            Err(reason) => {
                self.sink.note(segment.start, reason);
                self.keep(segment);
            }
        }
    }

    /// Works out what an arc becomes.
    fn draw(&mut self, segment: &Segment, behind: &Segments<'_>) -> Result<u8, Reason> {
        let v = segment.values(self.data).ok_or(Reason::TooLarge)?;
        // A relative arc is rounded on a grid that begins at its own start, an absolute one on the whole plane's.
        let from = if segment.is_relative() {
            Point::ZERO
        } else {
            self.point.to_point()
        };
        let arc = SvgArc {
            from,
            radii: Vec2::new(v[0], v[1]),
            rotation: Angle::from_degrees(v[2]),
            large_arc: v[3] != 0.0,
            sweep: v[4] != 0.0,
            to: Point::new(v[5], v[6]),
        };
        if arc.to == arc.from {
            return self.nothing(behind);
        }
        if arc.radii.x == 0.0 || arc.radii.y == 0.0 {
            self.line(segment);
            return Ok(0);
        }
        self.beziers(segment, &arc)?;
        self.join(segment)
    }

    /// Equal end points: the arc is left out, unless a zero-length subpath, a marker or a reflected control point could show it.
    fn nothing(&mut self, behind: &Segments<'_>) -> Result<u8, Reason> {
        let alone = |kind: Option<u8>| matches!(kind, None | Some(b'm' | b'z'));
        let before = self.previous.as_ref().map(Segment::kind);
        let smooth = matches!(
            behind.clone().next().map(|segment| segment.kind()),
            Some(b's' | b't')
        );
        // Of several such arcs in a row the first decides for all.
        let shows = || {
            alone(before)
                && matches!(
                    self.first_drawn(behind),
                    None | Some(b'm' | b'z' | b's' | b't')
                )
        };
        if self.context.vertices_show || smooth || shows() {
            return Err(Reason::EmptyArc);
        }
        self.scratch.text.clear();
        self.effective = 0;
        Ok(0)
    }

    /// The command behind an arc that draws nothing, further ones like it skipped.
    fn first_drawn(&self, behind: &Segments<'_>) -> Option<u8> {
        let is_empty = |segment: &Segment| {
            let here = if segment.is_relative() {
                Vec2::ZERO
            } else {
                self.point
            };
            segment.kind() == b'a' && segment.end_values(self.data) == Some([here.x, here.y])
        };
        let mut segments = behind.clone();
        segments
            .find(|segment| !is_empty(segment))
            .map(|segment| segment.kind())
    }

    /// A zero radius: a straight line.
    fn line(&mut self, segment: &Segment) {
        self.scratch.text.clear();
        self.letter(segment, if segment.is_relative() { b'l' } else { b'L' });
        self.tail(segment);
    }

    /// Writes the command letter where it is needed.
    fn letter(&mut self, segment: &Segment, letter: u8) {
        if segment.explicit || self.effective != letter {
            self.scratch.text.push(letter);
            self.after = After::Letter;
        }
        self.effective = letter;
    }

    /// Writes the end point as the file spells it.
    fn tail(&mut self, segment: &Segment) {
        let text = &self.data.as_bytes()[segment.tail..segment.end];
        self.after.push_text(&mut self.scratch.text, text);
    }

    /// Takes the curve of an arc that was spelled like that before.
    fn recall(&mut self, segment: &Segment) -> bool {
        let Scratch { body, memo, .. } = &mut *self.scratch;
        segment.is_relative()
            && memo.recall(&self.data.as_bytes()[segment.arguments..segment.end], body)
    }

    /// Works out the curve of an arc.
    fn beziers(&mut self, segment: &Segment, arc: &SvgArc) -> Result<(), Reason> {
        let Scratch {
            body,
            beziers,
            memo,
            ..
        } = &mut *self.scratch;
        bezier::arc(arc, self.context.options, memo, beziers)?;
        body.text.clear();
        (body.quadratic, body.segments) = (beziers.is_quadratic(), beziers.segments().len());
        if segment.is_relative() {
            body.after = relative(self.data, segment, beziers, &mut body.text)?;
            memo.keep(&self.data.as_bytes()[segment.arguments..segment.end], body);
        } else {
            body.after = absolute(self.data, segment, self.point, beziers, &mut body.text)?;
        }
        Ok(())
    }

    /// Joins the curve to what stands before it; returns the smooth command that would reflect its last control point.
    fn join(&mut self, segment: &Segment) -> Result<u8, Reason> {
        let Body {
            quadratic,
            segments,
            ..
        } = self.scratch.body;
        if self.context.vertices_show && segments > 1 {
            return Err(Reason::MarkerOnVertices);
        }
        let (letter, respell) = if quadratic {
            (b'q', b't')
        } else {
            (b'c', b's')
        };
        self.scratch.text.clear();
        self.letter(
            segment,
            if segment.is_relative() {
                letter
            } else {
                letter.to_ascii_uppercase()
            },
        );
        let Scratch { text, body, .. } = &mut *self.scratch;
        self.after.push_text(text, &body.text);
        self.after = body.after;
        Ok(respell)
    }
}

/// Whether a reader that forgives an error here would find a smooth command: then the arc before it must stay an arc.
fn may_be_smooth(rest: &[u8]) -> bool {
    let skipped = |b: &&u8| matches!(b, b' ' | b'\t' | b'\n' | b'\r' | b',');
    matches!(
        rest.iter().find(|b| !skipped(b)),
        Some(b's' | b'S' | b't' | b'T')
    )
}

/// Whether the data have an error right behind a segment.
fn is_broken(behind: &Segments<'_>) -> bool {
    let mut behind = behind.clone();
    behind.next().is_none() && behind.error().is_some()
}
