//! Path data: every arc command becomes cubics in place, all other bytes stay.
//!
//! What has to be minded: a smooth `S` after an arc takes the current point for its first control point, but after a cubic it
//! would reflect; a repetition without a letter must not change its command; numbers are rounded on a grid that begins at
//! the arc's own start, so nothing accumulates; the end point keeps the text that the file gave it.

mod sink;

use core::ops::Range;

use kurbo::{Point, Vec2};

use super::{bezier, collapse};
use crate::Angle;
use crate::approximate::approximate_between;
use crate::document::path::curve_text::{CurveFacts, absolute, relative};
use crate::document::path::position::{Position, Trail, is_nearly_whole};
use crate::document::path::scratch::Scratch;
use crate::document::style::property::Markers;
use crate::document::{Options, Reason};
use crate::number::decimal::{After, BelowOne, Decimal};
use crate::number::decimals_for;
use crate::path::PathText;
use crate::path_data::{Segment, Segments};
use crate::shape::endpoint::SvgArc;
pub(in crate::document) use sink::Sink;

/// What a path may not lose, and how it is drawn.
#[derive(Debug, Clone, Copy)]
pub(in crate::document) struct Context<'a> {
    pub(in crate::document) options: &'a Options,
    /// The markers that may be drawn: on inner vertices none may be added then, and an arc without an extent gives directions.
    pub(in crate::document) markers: Markers,
}

/// What became of one path.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(in crate::document) struct PathOutcome {
    /// Arc commands replaced.
    pub(in crate::document) arcs: usize,
    /// Smooth commands that had to be spelled out.
    pub(in crate::document) smooth: usize,
    /// The largest peak error of their curves, where it is measured.
    pub(in crate::document) strayed: f64,
}

/// Rewrites the arcs of the path data in `text[span]`, after which the text ends or goes on with a quote.
pub(in crate::document) fn rewrite(
    text: &str,
    span: Range<usize>,
    context: Context<'_>,
    scratch: &mut Scratch,
    sink: &mut impl Sink,
) -> PathOutcome {
    let data = &text.as_bytes()[span.clone()];
    let Some(last) = memchr::memrchr2(b'a', b'A', data) else {
        return PathOutcome::default();
    };
    let last = span.start + last;
    // Relative arcs need no current point, and most paths have no other ones.
    let follows_point = memchr::memchr3(b'A', b'S', b'T', data).is_some();
    let mut segments = Segments::new(text, span.clone()).with_ends(follows_point);
    let mut writer = ArcWriter {
        text,
        context,
        scratch,
        sink,
        follows_point,
        at: Position::default(),
        trail: Trail::new(text, span),
        collapses: false,
        previous: None,
        end: PathText::new(BelowOne::Short),
        respell: 0,
        outcome: PathOutcome::default(),
    };
    while let Some((segment, known)) = writer.next(&mut segments) {
        writer.segment(&segment, known, &segments);
        // After the last arc nothing changes but the command that follows it.
        if segment.start > last && segment.kind() != b'a' && writer.end.letter == segment.letter
            || writer.sink.is_full()
        {
            break;
        }
    }
    if let Some(at) = segments.number_at_error() {
        writer.stray_number(at);
    }
    if let Some(at) = segments.error()
        && at <= last
    {
        writer.sink.note(at, Reason::PathError);
    }
    writer.outcome
}

/// Writes the letter of what an arc becomes, where it is needed.
fn lettered(end: &mut PathText, out: &mut Vec<u8>, arc: &Segment, small: u8) {
    if arc.explicit {
        end.letter = 0;
    }
    let large = if arc.is_relative() { 0 } else { 0x20 };
    end.letter(out, small ^ large);
}

struct ArcWriter<'a, 'b, S> {
    text: &'a str,
    context: Context<'a>,
    scratch: &'b mut Scratch,
    sink: &'b mut S,
    /// Whether the current point is followed.
    follows_point: bool,
    /// The current point, where it is followed.
    at: Position,
    /// The way to it, where it is asked for once.
    trail: Trail<'a>,
    /// Whether the precision would leave nothing of the subpath.
    collapses: bool,
    previous: Option<Segment>,
    end: PathText,
    /// The smooth command that would take up a control point of the Bézier that was an arc, if the output ends with one.
    respell: u8,
    outcome: PathOutcome,
}

impl<S: Sink> ArcWriter<'_, '_, S> {
    /// The next segment, and where the memo has it, if it is an arc that was met before.
    fn next(&self, segments: &mut Segments<'_>) -> Option<(Segment, Option<usize>)> {
        let memo = &self.scratch.memo;
        let known = segments.next_known(|key| {
            let index = memo.find(key)?;
            Some((index, memo.curve(index).facts.to?))
        });
        match known {
            Some((segment, index)) => Some((segment, Some(index))),
            None => segments.next().map(|segment| (segment, None)),
        }
    }

    fn segment(&mut self, segment: &Segment, known: Option<usize>, after: &Segments<'_>) {
        match segment.kind() {
            b'a' => {
                if self.context.options.precision.is_some() && self.begins_subpath() {
                    let options = self.context.options;
                    self.collapses =
                        collapse::collapses(options, self.text, segment, after, self.at.point);
                }
                self.arc(segment, known, after);
            }
            kind if kind == self.respell => self.smooth(segment),
            _ => self.keep(segment),
        }
        if self.follows_point {
            self.at.advance(segment);
        }
        self.previous = Some(*segment);
    }

    /// The segment stays; its letter is written where the output's last command is another one.
    fn keep(&mut self, segment: &Segment) {
        if !segment.explicit && self.end.letter != segment.letter {
            let range = self.text_start(segment)..segment.arguments;
            self.sink.edit(range).push(segment.letter);
        }
        self.end.letter = match segment.letter {
            b'm' => b'l',
            b'M' => b'L',
            letter => letter,
        };
        self.respell = 0;
    }

    /// Numbers after the last arc that are too few for another one are not drawn, but after the curve or the line that the arc
    /// became they could be enough for a further one. The arc's own letter in front of them keeps them an error.
    fn stray_number(&mut self, at: usize) {
        if let Some(arc) = &self.previous
            && arc.kind() == b'a'
            && self.end.letter != arc.letter
        {
            self.sink.edit(at..at).push(arc.letter);
        }
    }

    /// Where the text of a segment begins: with what parts it from the one before, unless its own letter does.
    fn text_start(&self, segment: &Segment) -> usize {
        match &self.previous {
            Some(previous) if !segment.explicit => previous.end,
            _ => segment.start,
        }
    }

    /// `S` after what was an arc: its first control point is the current point, which only `C` can say now. (`T` and `Q` for a
    /// method that draws quadratics.)
    fn smooth(&mut self, segment: &Segment) {
        let bytes = self.text.as_bytes();
        let full = if segment.kind() == b's' { b'c' } else { b'q' };
        let full = if segment.is_relative() {
            full
        } else {
            full.to_ascii_uppercase()
        };
        let text = self.sink.edit(segment.start..segment.arguments + 1);
        text.push(full);
        let mut after = After::Letter;
        match &self.previous {
            _ if segment.is_relative() => after.push_text(text, b"0 0"),
            Some(arc) if !arc.is_relative() => after.push_text(text, &bytes[arc.tail..arc.end]),
            _ => {
                let size = self.at.point.x.abs().max(self.at.point.y.abs());
                let decimals = decimals_for(size, 12);
                for x in [self.at.point.x, self.at.point.y] {
                    after.push(text, Decimal::round(x, decimals), BelowOne::Short);
                }
            }
        }
        after.push_text(text, &bytes[segment.arguments..=segment.arguments]);
        self.outcome.smooth += 1;
        self.end.letter = full;
        self.respell = 0;
    }

    fn arc(&mut self, segment: &Segment, known: Option<usize>, after: &Segments<'_>) {
        let replaced = if after.is_broken_smooth() {
            Err(Reason::PathErrorAfterArc)
        } else if self.collapses {
            Err(Reason::Collapses)
        } else {
            self.replace(segment, known, after)
        };
        match replaced {
            Ok(()) => self.outcome.arcs += 1,
            Err(reason) => {
                self.sink.note(segment.start, reason);
                self.keep(segment);
            }
        }
    }

    /// Replaces an arc by a curve, or by what it is without an extent.
    fn replace(
        &mut self,
        segment: &Segment,
        known: Option<usize>,
        after: &Segments<'_>,
    ) -> Result<(), Reason> {
        // Only relative arcs depend on nothing but their text.
        let key = segment
            .is_relative()
            .then(|| &self.text.as_bytes()[segment.arguments..segment.end]);
        let known = known.or_else(|| self.scratch.memo.find(key?));
        if known.is_none() {
            let arc = self.parameters(segment)?;
            if arc.to == arc.from {
                return self.nothing(segment, after);
            }
            if arc.is_straight() {
                self.line(segment);
                return Ok(());
            }
            // Whether it is depends on where it lies, so that such an arc is not kept.
            let nearly_whole = is_nearly_whole(&arc);
            if nearly_whole && self.ends_coincide(segment, &arc) {
                Reason::NearlyWhole.stop(self.context.options.trust)?;
            }
            self.draw(segment, &arc)?;
            if let Some(key) = key.filter(|_| !nearly_whole) {
                let Scratch { body, memo, .. } = &mut *self.scratch;
                memo.keep(key, &body.curve());
            }
        }
        let Scratch { body, memo, .. } = &*self.scratch;
        let curve = known.map_or_else(|| body.curve(), |index| memo.curve(index));
        if self.context.markers.middle && curve.facts.segments > 1 {
            Reason::MarkerOnVertices.stop(self.context.options.trust)?;
        }
        let (letter, respell) = if curve.facts.quadratic {
            (b'q', b't')
        } else {
            (b'c', b's')
        };
        let out = self.sink.edit(self.text_start(segment)..segment.end);
        lettered(&mut self.end, out, segment, letter);
        self.end.after.part(out, curve.text);
        out.extend_from_slice(curve.text);
        self.end.after = curve.facts.after;
        self.outcome.strayed = self.outcome.strayed.max(curve.facts.strayed);
        self.respell = respell;
        Ok(())
    }

    /// Whether the arc is the first segment of its subpath.
    fn begins_subpath(&self) -> bool {
        let before = self.previous.as_ref().map(Segment::kind);
        matches!(before, None | Some(b'm' | b'z'))
    }

    /// Whether the ends of an arc are one point in single precision.
    fn ends_coincide(&mut self, segment: &Segment, arc: &SvgArc) -> bool {
        let from = self.trail.before(segment.start);
        let to = if segment.is_relative() {
            from + arc.to.to_vec2()
        } else {
            arc.to.to_vec2()
        };
        from.x as f32 == to.x as f32 && from.y as f32 == to.y as f32
    }

    /// The arc as its text gives it. A relative one is rounded on a grid that begins at its own start, an absolute one on the
    /// whole plane's.
    fn parameters(&self, segment: &Segment) -> Result<SvgArc, Reason> {
        let from = if segment.is_relative() {
            Point::ZERO
        } else {
            self.at.point.to_point()
        };
        let v = segment
            .arc_values(self.text)
            .filter(|values| values.iter().all(|value| value.is_finite()))
            .ok_or(Reason::TooLarge)?;
        Ok(SvgArc {
            from,
            radii: Vec2::new(v[0], v[1]),
            rotation: Angle::from_degrees(v[2]),
            large_arc: v[3] != 0.0,
            sweep: v[4] != 0.0,
            to: Point::new(v[5], v[6]),
        })
    }

    /// Equal end points: the arc is left out, unless a zero-length subpath, a marker or a reflected control point could show it.
    fn nothing(&mut self, segment: &Segment, after: &Segments<'_>) -> Result<(), Reason> {
        let smooth = matches!(
            after.clone().next().map(|segment| segment.kind()),
            Some(b's' | b't')
        );
        // Of several such arcs in a row the first decides for all.
        let shows = || {
            self.begins_subpath()
                && matches!(
                    self.first_drawn(after.clone()),
                    None | Some(b'm' | b'z' | b's' | b't')
                )
        };
        if smooth {
            return Err(Reason::EmptyArc);
        }
        if self.context.markers.any || shows() {
            Reason::EmptyArc.stop(self.context.options.trust)?;
        }
        self.sink.edit(self.text_start(segment)..segment.end);
        self.end.letter = 0;
        self.respell = 0;
        Ok(())
    }

    /// The command after an arc that draws nothing, further ones like it skipped.
    fn first_drawn(&self, after: Segments<'_>) -> Option<u8> {
        let is_empty = |segment: &Segment| {
            let here = if segment.is_relative() {
                Vec2::ZERO
            } else {
                self.at.point
            };
            segment.kind() == b'a' && segment.to == [here.x, here.y]
        };
        after
            .with_ends(true)
            .find(|segment| !is_empty(segment))
            .map(|segment| segment.kind())
    }

    /// A zero radius, or one beside which the chord is next to nothing: a straight line to the end point as the file spells it.
    fn line(&mut self, segment: &Segment) {
        let out = self.sink.edit(self.text_start(segment)..segment.end);
        lettered(&mut self.end, out, segment, b'l');
        let to = &self.text.as_bytes()[segment.tail..segment.end];
        self.end.after.push_text(out, to);
        self.respell = 0;
    }

    /// Works out the curve of an arc.
    fn draw(&mut self, segment: &Segment, arc: &SvgArc) -> Result<(), Reason> {
        let Scratch {
            body,
            beziers,
            memo,
        } = &mut *self.scratch;
        let options = self.context.options;
        bezier::arc(approximate_between, arc, options, memo, beziers)?;
        body.text.clear();
        let after = if segment.is_relative() {
            relative(self.text, segment, beziers, &mut body.text)?
        } else {
            absolute(self.text, segment, self.at.point, beziers, &mut body.text)?
        };
        body.facts = CurveFacts::new(arc, options, beziers, after);
        Ok(())
    }
}
