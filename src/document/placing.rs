//! Where the coordinates of an element lie: viewports, and transforms of attributes and of style attributes.

use kurbo::{Affine, Vec2};
use quick_xml::events::BytesStart;

use super::length::{self, Reading};
use crate::error::{Error, Result, TextError, finite};
use crate::path::{self, shortened};

/// Where the coordinates of an element lie.
#[derive(Debug, Clone)]
pub(super) struct Place {
    /// The map to the coordinates of the outermost element, or why it is not known.
    pub(super) map: Result<Affine>,
    /// The size of the viewport, where it is known.
    viewport: Option<[f64; 2]>,
    /// Whether it is within an `svg` element.
    nested: bool,
}

impl Place {
    /// Outside of everything.
    pub(super) const OUTSIDE: Self = Self {
        map: Ok(Affine::IDENTITY),
        viewport: None,
        nested: false,
    };

    /// That of an element in here.
    pub(super) fn within(&self, element: &BytesStart) -> Self {
        let is_svg = element.local_name().as_ref() == "svg";
        let mut place = self.clone();
        place.map = self.map.clone().and_then(|map| {
            let mut map = map * self.own(element)?;
            if is_svg && self.nested {
                map *= self.viewport(element, &mut place.viewport)?;
            }
            for number in map.as_coeffs() {
                finite("number in the transform", number)?;
            }
            Ok(map)
        });
        if is_svg && !self.nested {
            place.nested = true;
            let size = ["width", "height"].map(|name| self.length(element, name, None).ok());
            let size = match size {
                [Some(width), Some(height)] => Some([width, height]),
                _ => None,
            };
            place.viewport = view_box(element).map(|[_, _, w, h]| [w, h]).or(size);
        }
        place
    }

    /// The transform of an element itself, about its origin.
    fn own(&self, element: &BytesStart) -> Result<Affine> {
        for name in ["translate", "rotate", "scale", "offset-path"] {
            if let Some(value) = styled(element, name).filter(|value| value != "none") {
                return Err(unread(name, &value));
            }
        }
        let Some(text) = property(element, "transform").filter(|text| text.trim() != "none") else {
            return Ok(Affine::IDENTITY);
        };
        let plain = text.replace("px", "").replace("deg", "");
        let own = path::transform(&plain).map_err(|error| {
            Error::Text(TextError::ElementTransform {
                text: shortened(&text),
                why: Box::new(error),
            })
        })?;
        let Some(origin) = property(element, "transform-origin") else {
            return Ok(own);
        };
        if let Some(value) = property(element, "transform-box").filter(|value| value != "view-box")
        {
            return Err(unread("transform-box", &value));
        }
        let origin = self.origin(&origin)?;
        Ok(Affine::translate(origin) * own * Affine::translate(-origin))
    }

    fn origin(&self, text: &str) -> Result<Vec2> {
        let wrong = || unread("transform-origin", text);
        let words: Vec<&str> = text.split_ascii_whitespace().collect();
        let [x, y] = match words[..] {
            [x] => [x, "center"],
            [x, y] => [x, y],
            _ => return Err(wrong()),
        };
        let one = |word: &str, axis: usize| {
            let share = match word {
                "left" | "top" => 0.0,
                "center" => 0.5,
                "right" | "bottom" => 1.0,
                _ => return self.measure(word, axis).ok_or_else(wrong),
            };
            match self.viewport {
                Some(size) => Ok(share * size[axis]),
                None if share == 0.0 => Ok(0.0),
                None => Err(wrong()),
            }
        };
        // Words may stand in either order.
        if matches!(x, "top" | "bottom") || matches!(y, "left" | "right") {
            return Ok(Vec2::new(one(y, 0)?, one(x, 1)?));
        }
        Ok(Vec2::new(one(x, 0)?, one(y, 1)?))
    }

    /// A length in user units, or a part of the viewport.
    fn measure(&self, text: &str, axis: usize) -> Option<f64> {
        if let Some(percent) = text.trim().strip_suffix('%') {
            let share: f64 = percent.parse().ok()?;
            return Some(share / 100.0 * self.viewport?[axis]);
        }
        match length::read(text) {
            Reading::Length(length) => Some(length.value),
            _ => None,
        }
    }

    /// The length of a property; the default stands where the element lacks it.
    pub(super) fn length(
        &self,
        element: &BytesStart,
        name: &'static str,
        default: Option<f64>,
    ) -> Result<f64> {
        let length = self.optional_length(element, name)?.or(default);
        length.ok_or(Error::Text(TextError::NoProperty(name)))
    }

    /// The same, where the element has it and it is not `auto`.
    pub(super) fn optional_length(
        &self,
        element: &BytesStart,
        name: &'static str,
    ) -> Result<Option<f64>> {
        let axis = usize::from(matches!(name, "y" | "height" | "cy" | "ry" | "y1" | "y2"));
        let Some(text) = property(element, name).filter(|text| text != "auto") else {
            return Ok(None);
        };
        let is_known = name != "r" || !text.ends_with('%');
        let length = is_known.then(|| self.measure(&text, axis)).flatten();
        length.map(Some).ok_or_else(|| unread(name, &text))
    }

    /// The map of a nested viewport, and its size for what is in it.
    fn viewport(&self, element: &BytesStart, size: &mut Option<[f64; 2]>) -> Result<Affine> {
        let outer = self.viewport.map_or([None; 2], |size| size.map(Some));
        let x = self.length(element, "x", Some(0.0))?;
        let y = self.length(element, "y", Some(0.0))?;
        let at = Affine::translate((x, y));
        let width = self.length(element, "width", outer[0]);
        let height = self.length(element, "height", outer[1]);
        let Some([left, top, w, h]) = view_box(element) else {
            *size = width
                .ok()
                .zip(height.ok())
                .map(|(width, height)| [width, height]);
            return Ok(at);
        };
        *size = Some([w, h]);
        let (width, height) = (width?, height?);
        let [x_scale, y_scale] = [width / w, height / h];
        let words = property(element, "preserveAspectRatio").unwrap_or_default();
        let mut words = words.split_ascii_whitespace();
        let align = words.next().unwrap_or("xMidYMid");
        if align == "none" {
            return Ok(at
                * Affine::scale_non_uniform(x_scale, y_scale)
                * Affine::translate((-left, -top)));
        }
        let scale = if words.next() == Some("slice") {
            x_scale.max(y_scale)
        } else {
            x_scale.min(y_scale)
        };
        let share = |axis: char| match align.split_once(axis).map(|(_, rest)| rest.get(..3)) {
            Some(Some("Min")) => 0.0,
            Some(Some("Max")) => 1.0,
            _ => 0.5,
        };
        let moved = Vec2::new(
            share('x') * (width - w * scale),
            share('Y') * (height - h * scale),
        );
        Ok(at * Affine::translate(moved) * Affine::scale(scale) * Affine::translate((-left, -top)))
    }
}

fn unread(name: &str, value: &str) -> Error {
    Error::Text(TextError::Property {
        name: name.to_owned(),
        value: shortened(value),
    })
}

fn view_box(element: &BytesStart) -> Option<[f64; 4]> {
    let text = attribute(element, "viewBox")?;
    let numbers = text
        .split([' ', ',', '\t', '\n'])
        .filter(|word| !word.is_empty());
    let numbers: Vec<f64> = numbers.map(str::parse).collect::<Result<_, _>>().ok()?;
    let numbers: [f64; 4] = numbers.try_into().ok()?;
    (numbers[2] > 0.0 && numbers[3] > 0.0).then_some(numbers)
}

/// A property, of the style attribute or as an attribute.
pub(super) fn property(element: &BytesStart, name: &str) -> Option<String> {
    styled(element, name).or_else(|| attribute(element, name))
}

/// A declaration of the style attribute, the last of its name.
fn styled(element: &BytesStart, name: &str) -> Option<String> {
    let style = attribute(element, "style")?;
    let declarations = style.rsplit(';').filter_map(|one| one.split_once(':'));
    let mut values =
        declarations.filter(|(property, _)| property.trim().eq_ignore_ascii_case(name));
    let value = values.next()?.1.trim();
    Some(value.trim_end_matches("!important").trim().to_owned())
}

pub(super) fn attribute(element: &BytesStart, name: &str) -> Option<String> {
    let attribute = element.try_get_attribute(name).ok().flatten()?;
    match quick_xml::escape::unescape(&attribute.value) {
        Ok(plain) => Some(plain.into_owned()),
        Err(_) => Some(attribute.value.into_owned()),
    }
}
