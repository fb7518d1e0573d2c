//! What of its coordinates a viewport shows.

use kurbo::{Affine, Vec2};

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
        let found = numbers_of(tag)?.filter(|[_, _, w, h]| *w > 0.0 && *h > 0.0);
        Ok(found.map(|[left, top, w, h]| Self {
            corner: Vec2::new(left, top),
            size: [w, h],
        }))
    }

    /// Whether that of an element is there and has no size, so that nothing is rendered.
    pub(super) fn is_empty(tag: &Tag<'_>) -> bool {
        let is_empty = |[_, _, w, h]: [f64; 4]| w.min(h) == 0.0;
        numbers_of(tag).is_ok_and(|numbers| numbers.is_some_and(is_empty))
    }

    /// The map to a viewport of this size, as `preserveAspectRatio` has it.
    pub(super) fn fitted(&self, tag: &Tag<'_>, size: [f64; 2]) -> Result<Affine> {
        let ratio = tag.attribute("preserveAspectRatio")?.unwrap_or_default();
        let scales = Vec2::new(size[0] / self.size[0], size[1] / self.size[1]);
        let (scale, [x, y]) = match aspect_ratio(&ratio) {
            AspectRatio::Free => {
                let scale = Affine::scale_non_uniform(scales.x, scales.y);
                return Ok(scale * Affine::translate(-self.corner));
            }
            AspectRatio::Meet(align) => (scales.x.min(scales.y), align),
            AspectRatio::Slice(align) => (scales.x.max(scales.y), align),
        };
        let moved = Vec2::new(
            x * (size[0] - self.size[0] * scale),
            y * (size[1] - self.size[1] * scale),
        );
        Ok(Affine::translate(moved) * Affine::scale(scale) * Affine::translate(-self.corner))
    }
}

/// The numbers of a `viewBox`; `None` where these are no list of four.
fn numbers_of(tag: &Tag<'_>) -> Result<Option<[f64; 4]>> {
    let text = tag.attribute("viewBox")?;
    let numbers = text.and_then(|text| numbers::list(&text).ok());
    let four = numbers.and_then(|numbers| numbers.try_into().ok());
    Ok(four.filter(|four: &[f64; 4]| four.iter().all(|number| number.is_finite())))
}

/// How a `viewBox` fills a viewport: how much of what is left over stands before it, by axis.
enum AspectRatio {
    /// Stretched along each axis.
    Free,
    /// All of it is seen.
    Meet([f64; 2]),
    /// All of the viewport is covered.
    Slice([f64; 2]),
}

/// That of SVG 2; what is wrong counts as missing. svgtypes reads no more than its beginning, and the `defer` of SVG 1.1.
fn aspect_ratio(text: &str) -> AspectRatio {
    let words: Vec<&str> = text.split_ascii_whitespace().collect();
    let (align, is_slice) = match *words {
        [align] | [align, "meet"] => (align, false),
        [align, "slice"] => (align, true),
        _ => ("", false),
    };
    let part = |word: &str| match word {
        "Min" => Some(0.0),
        "Mid" => Some(0.5),
        "Max" => Some(1.0),
        _ => None,
    };
    let parts = align
        .strip_prefix('x')
        .and_then(|rest| rest.split_once('Y'));
    let parts = parts.and_then(|(x, y)| Some([part(x)?, part(y)?]));
    match parts {
        _ if align == "none" => AspectRatio::Free,
        Some(parts) if is_slice => AspectRatio::Slice(parts),
        parts => AspectRatio::Meet(parts.unwrap_or([0.5; 2])),
    }
}
