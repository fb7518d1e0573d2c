//! The current point of path data.

use core::ops::Range;

use kurbo::Vec2;

use crate::path_data::{Segment, Segments};
use crate::shape::endpoint::SvgArc;

/// A chord of so small a part of the radius makes the larger arc nearly a whole ellipse.
const SMALL_CHORD: f64 = 1.0 / 32.0;

/// The current point and the start of the subpath, as a renderer adds them up.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(in crate::document) struct Position {
    pub(in crate::document) point: Vec2,
    subpath: Vec2,
}

impl Position {
    /// The start of a subpath.
    pub(in crate::document) const fn at(point: Vec2) -> Self {
        Self {
            point,
            subpath: point,
        }
    }

    /// Moves on after a segment, which has been read with its end.
    pub(in crate::document) fn advance(&mut self, segment: &Segment) {
        let base = if segment.is_relative() {
            self.point
        } else {
            Vec2::ZERO
        };
        if segment.kind() == b'z' {
            self.point = self.subpath;
            return;
        }
        // What is beyond numbers here is so for every arc after it: they are left.
        let [x, y] = if segment.is_finite() {
            segment.to
        } else {
            [f64::NAN; 2]
        };
        self.point = match segment.kind() {
            b'h' => Vec2::new(base.x + x, self.point.y),
            b'v' => Vec2::new(self.point.x, base.y + x),
            _ => base + Vec2::new(x, y),
        };
        if segment.kind() == b'm' {
            self.subpath = self.point;
        }
    }
}

/// The current point of a few segments among many: the way to one begins at the one before.
#[derive(Debug)]
pub(in crate::document) struct Trail<'a> {
    segments: Segments<'a>,
    next: Option<Segment>,
    at: Position,
}

impl<'a> Trail<'a> {
    pub(in crate::document) const fn new(text: &'a str, span: Range<usize>) -> Self {
        Self {
            segments: Segments::new(text, span).with_ends(true),
            next: None,
            at: Position::at(Vec2::ZERO),
        }
    }

    /// The current point before the segment that begins at this byte; segments are asked for in their order.
    pub(in crate::document) fn before(&mut self, start: usize) -> Vec2 {
        loop {
            match self.next.take().or_else(|| self.segments.next()) {
                Some(segment) if segment.start < start => self.at.advance(&segment),
                next => {
                    self.next = next;
                    return self.at.point;
                }
            }
        }
    }
}

/// Whether an arc goes nearly all around.
pub(in crate::document) fn is_nearly_whole(arc: &SvgArc) -> bool {
    let chord = arc.to - arc.from;
    let radius = arc.radii.x.abs().min(arc.radii.y.abs());
    arc.large_arc && chord.x.abs().max(chord.y.abs()) <= SMALL_CHORD * radius
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_trail_follows_relative_and_absolute_commands() {
        let text = "M1 2l3 4h1v1H9zm1 1a1 1 0 0 1 2 2A1 1 0 0 1 7 7";
        let mut trail = Trail::new(text, 0..text.len());
        assert_eq!(trail.before(text.find('l').unwrap()), Vec2::new(1.0, 2.0));
        assert_eq!(trail.before(text.find('z').unwrap()), Vec2::new(9.0, 7.0));
        assert_eq!(trail.before(text.find('A').unwrap()), Vec2::new(4.0, 5.0));
        assert_eq!(trail.before(text.len()), Vec2::new(7.0, 7.0));
    }
}
