//! What of its coordinates a viewport shows.

use kurbo::{Affine, Vec2};
use svgtypes::{Align, AspectRatio};

use super::numbers;
use super::tag::Tag;
use crate::error::Result;

/// A `viewBox` with a positive size.
pub(super) struct ViewBox {
    corner: Vec2,
    pub(super) size: [f64; 2],
}

impl ViewBox {
    /// That of an element. What is no list of four numbers, or has no positive size, counts as missing.
    pub(super) fn of(tag: &Tag<'_>) -> Result<Option<Self>> {
        let text = tag.attribute("viewBox")?;
        let numbers = text.and_then(|text| numbers::list(&text).ok());
        let Some(&[left, top, w, h]) = numbers.as_deref() else {
            return Ok(None);
        };
        let is_finite = [left, top, w, h].into_iter().all(f64::is_finite);
        Ok((is_finite && w > 0.0 && h > 0.0).then_some(Self {
            corner: Vec2::new(left, top),
            size: [w, h],
        }))
    }

    /// The map to a viewport of this size, as `preserveAspectRatio` has it; where that is wrong, as if it were missing.
    pub(super) fn fitted(&self, tag: &Tag<'_>, size: [f64; 2]) -> Result<Affine> {
        let ratio = tag.attribute("preserveAspectRatio")?.unwrap_or_default();
        let ratio: AspectRatio = ratio.parse().unwrap_or_default();
        let scales = Vec2::new(size[0] / self.size[0], size[1] / self.size[1]);
        let scale = if ratio.slice {
            scales.x.max(scales.y)
        } else {
            scales.x.min(scales.y)
        };
        let (x, y) = match ratio.align {
            Align::None => {
                let scale = Affine::scale_non_uniform(scales.x, scales.y);
                return Ok(scale * Affine::translate(-self.corner));
            }
            Align::XMinYMin => (0.0, 0.0),
            Align::XMidYMin => (0.5, 0.0),
            Align::XMaxYMin => (1.0, 0.0),
            Align::XMinYMid => (0.0, 0.5),
            Align::XMidYMid => (0.5, 0.5),
            Align::XMaxYMid => (1.0, 0.5),
            Align::XMinYMax => (0.0, 1.0),
            Align::XMidYMax => (0.5, 1.0),
            Align::XMaxYMax => (1.0, 1.0),
        };
        let moved = Vec2::new(
            x * (size[0] - self.size[0] * scale),
            y * (size[1] - self.size[1] * scale),
        );
        Ok(Affine::translate(moved) * Affine::scale(scale) * Affine::translate(-self.corner))
    }
}
