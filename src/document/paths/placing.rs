//! Where the coordinates of an element lie: viewports, and transforms of attributes and of style attributes.

use kurbo::{Affine, Vec2};

use super::tag::Tag;
use super::view_box::ViewBox;
use crate::document::shape::length::{self, LengthAttribute};
use crate::error::{Error, Result, ShapeError, TextError, finite};
use crate::number::read as number;
use crate::path::{self, shortened};
use crate::shape::flattens;

/// Where the coordinates of an element lie.
#[derive(Debug, Clone)]
pub(in crate::document) struct Coordinates {
    /// The map to the coordinates of the outermost element, or why it is not known.
    pub(in crate::document) map: Result<Affine>,
    /// The size of the viewport, where it is known.
    viewport: Option<[f64; 2]>,
    /// Whether it is within an `svg` element.
    nested: bool,
}

impl Coordinates {
    /// Outside of everything.
    pub(in crate::document) const OUTSIDE: Self = Self {
        map: Ok(Affine::IDENTITY),
        viewport: None,
        nested: false,
    };

    /// That of an element in here.
    pub(in crate::document) fn within(&self, tag: &Tag<'_>) -> Self {
        let is_svg = tag.name == "svg";
        let mut place = self.clone();
        place.map = self.map.clone().and_then(|map| {
            let mut map = map * self.own(tag)?;
            if is_svg && self.is_empty(tag) {
                return Err(Error::Text(TextError::NoViewport));
            }
            if is_svg && self.nested {
                map *= self.viewport(tag, &mut place.viewport)?;
            }
            for number in map.as_coeffs() {
                finite("number in the transform", number)?;
            }
            if flattens(map) {
                return Err(Error::Shape(ShapeError::Flattened));
            }
            Ok(map)
        });
        if is_svg && !self.nested {
            place.nested = true;
            let size = ["width", "height"].map(|name| self.length(tag, name, None).ok());
            let size = match size {
                [Some(width), Some(height)] => Some([width, height]),
                _ => None,
            };
            let view_box = ViewBox::of(tag).ok().flatten();
            place.viewport = view_box.map(|view_box| view_box.size).or(size);
        }
        place
    }

    /// Whether an `svg` element in here has a size of zero, so that nothing in it is rendered.
    fn is_empty(&self, tag: &Tag<'_>) -> bool {
        let is_zero = |name| self.optional_length(tag, name) == Ok(Some(0.0));
        is_zero("width") || is_zero("height") || ViewBox::is_empty(tag)
    }

    /// The transform of an element itself, about its origin.
    fn own(&self, tag: &Tag<'_>) -> Result<Affine> {
        for name in ["translate", "rotate", "scale", "offset-path", "offset"] {
            if let Some(value) = tag.styled(name)?.filter(|value| value != "none") {
                return Err(unread(name, &value));
            }
        }
        let Some(text) = tag
            .property("transform")?
            .filter(|text| text.trim() != "none")
        else {
            return Ok(Affine::IDENTITY);
        };
        let own = path::transform(&without_units(&text)).map_err(|error| {
            Error::Text(TextError::ElementTransform {
                text: shortened(&text),
                why: Box::new(error),
            })
        })?;
        if own == Affine::IDENTITY {
            return Ok(own);
        }
        // Without an origin too: a box has its own corner.
        if let Some(value) = tag
            .property("transform-box")?
            .filter(|value| value != "view-box")
        {
            return Err(unread("transform-box", &value));
        }
        let Some(origin) = tag.property("transform-origin")? else {
            return Ok(own);
        };
        let origin = self.origin(&origin)?;
        Ok(Affine::translate(origin) * own * Affine::translate(-origin))
    }

    fn origin(&self, text: &str) -> Result<Vec2> {
        let wrong = || unread("transform-origin", text);
        let small = text.to_ascii_lowercase();
        let words: Vec<&str> = small.split_ascii_whitespace().collect();
        // Words may stand in either order.
        let [x, y] = match words[..] {
            [y @ ("top" | "bottom")] => ["center", y],
            [x] => [x, "center"],
            [y @ ("top" | "bottom"), x @ ("left" | "center" | "right")]
            | [y @ "center", x @ ("left" | "right")]
            | [x, y] => [x, y],
            _ => return Err(wrong()),
        };
        let one = |word: &str, axis: usize| {
            let share = match (word, axis) {
                ("left", 0) | ("top", 1) => 0.0,
                ("center", _) => 0.5,
                ("right", 0) | ("bottom", 1) => 1.0,
                _ => return self.measure(word, axis).ok_or_else(wrong),
            };
            match self.viewport {
                Some(size) => Ok(share * size[axis]),
                None if share == 0.0 => Ok(0.0),
                None => Err(wrong()),
            }
        };
        Ok(Vec2::new(one(x, 0)?, one(y, 1)?))
    }

    /// A length in user units, or a part of the viewport: of its width (0), its height (1), or its diagonal over √2 (2).
    fn measure(&self, text: &str, axis: usize) -> Option<f64> {
        if let Some(percent) = text.trim().strip_suffix('%') {
            let (share, end) = number::read(percent.as_bytes(), 0)?;
            let is_whole = end == percent.len() && share.is_finite();
            let [width, height] = self.viewport?;
            let diagonal = f64::midpoint(width * width, height * height).sqrt();
            let whole = [width, height, diagonal][axis];
            return is_whole.then_some(share * whole / 100.0);
        }
        match length::read(text) {
            LengthAttribute::Length(length) => Some(length.value),
            _ => None,
        }
    }

    /// The length of a property; the default stands where the element lacks it.
    pub(in crate::document) fn length(
        &self,
        tag: &Tag<'_>,
        name: &'static str,
        default: Option<f64>,
    ) -> Result<f64> {
        let length = self.optional_length(tag, name)?.or(default);
        length.ok_or(Error::Text(TextError::NoProperty(name)))
    }

    /// The same, where the element has it and it is not `auto`.
    pub(in crate::document) fn optional_length(
        &self,
        tag: &Tag<'_>,
        name: &'static str,
    ) -> Result<Option<f64>> {
        let axis = match name {
            "y" | "height" | "cy" | "ry" | "y1" | "y2" => 1,
            "r" => 2,
            _ => 0,
        };
        let Some(text) = tag.property(name)?.filter(|text| text != "auto") else {
            return Ok(None);
        };
        let length = self.measure(&text, axis);
        length.map(Some).ok_or_else(|| unread(name, &text))
    }

    /// The map of a nested viewport, and its size for what is in it.
    fn viewport(&self, tag: &Tag<'_>, size: &mut Option<[f64; 2]>) -> Result<Affine> {
        let outer = self.viewport.map_or([None; 2], |size| size.map(Some));
        let x = self.length(tag, "x", Some(0.0))?;
        let y = self.length(tag, "y", Some(0.0))?;
        let at = Affine::translate((x, y));
        let width = self.length(tag, "width", outer[0]);
        let height = self.length(tag, "height", outer[1]);
        let Some(view_box) = ViewBox::of(tag)? else {
            *size = width
                .ok()
                .zip(height.ok())
                .map(|(width, height)| [width, height]);
            return Ok(at);
        };
        *size = Some(view_box.size);
        Ok(at * view_box.fitted(tag, [width?, height?])?)
    }
}

fn unread(name: &str, value: &str) -> Error {
    Error::Text(TextError::Property {
        name: name.to_owned(),
        value: shortened(value),
    })
}

/// A list of transforms without the units that CSS has in them: of lengths that are moved by, and of angles. The others stay, and are refused.
fn without_units(text: &str) -> String {
    let plain = |function: &str| {
        let name = function.split('(').next().unwrap_or_default();
        let unit = match name.trim_matches([' ', '\t', '\n', '\r', ',']) {
            "translate" => "px",
            "rotate" | "skewX" | "skewY" => "deg",
            _ => return function.to_owned(),
        };
        let parts: Vec<&str> = function.split(unit).collect();
        let is_number = |part: &&str| part.ends_with(|c: char| c.is_ascii_digit());
        match parts.split_last() {
            Some((_, numbers)) if numbers.iter().all(is_number) => parts.join(" "),
            _ => function.to_owned(),
        }
    };
    text.split_inclusive(')').map(plain).collect()
}

#[cfg(test)]
mod tests;
