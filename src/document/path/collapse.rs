//! Dots: subpaths of nothing but arcs that a coarse precision would make a line.

use kurbo::Vec2;

use crate::document::Options;
use crate::document::path::position::Position;
use crate::numeric::functions::power;
use crate::path_data::{Segment, Segments};

/// Whether a radius is so small that every point between a centre and it rounds to that centre.
pub(in crate::document) fn is_too_small(radius: f64, precision: u8) -> bool {
    radius * power(10.0, i32::from(precision)) <= 0.5
}

/// Whether the precision asked for would leave nothing of a subpath: it is one of arcs alone that lies within one unit of the last
/// decimal, and each arc is too small. `first` is its first arc, `after` what follows, `from` the current point, of which absolute
/// arcs know.
pub(in crate::document) fn collapses(
    options: &Options,
    text: &str,
    first: &Segment,
    after: &Segments<'_>,
    from: Vec2,
) -> bool {
    let Some(precision) = options.precision else {
        return false;
    };
    // Relative arcs count from the start.
    let mut at = Position::at(from);
    let segments = core::iter::once(*first).chain(after.clone().with_ends(true));
    for segment in segments {
        match segment.kind() {
            b'm' | b'z' => return true,
            b'a' => {}
            _ => return false,
        }
        let Some([rx, ry, .., x, y]) = segment.arc_values(text) else {
            return true;
        };
        at.advance(&Segment {
            to: [x, y],
            ..segment
        });
        let chord = (at.point - from).hypot2().sqrt();
        // A radius that is too small for its chord grows to half of it, which is too small as well then.
        if !is_too_small(rx.abs().min(ry.abs()), precision) || !is_too_small(chord / 2.0, precision)
        {
            return false;
        }
    }
    true
}
