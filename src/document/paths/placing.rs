//! Where the coordinates of an element lie: viewports, and transforms of attributes and of style attributes.

use kurbo::{Affine, Vec2};

use super::tag::Tag;
use super::view_box::ViewBox;
use crate::document::shape::length::{self, LengthAttribute};
use crate::error::{Error, Result, TextError, finite};
use crate::number::read as number;
use crate::path::{self, shortened};

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
            if is_svg && self.nested {
                map *= self.viewport(tag, &mut place.viewport)?;
            }
            for number in map.as_coeffs() {
                finite("number in the transform", number)?;
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

    /// A length in user units, or a part of the viewport.
    fn measure(&self, text: &str, axis: usize) -> Option<f64> {
        if let Some(percent) = text.trim().strip_suffix('%') {
            let (share, end) = number::read(percent.as_bytes(), 0)?;
            let is_whole = end == percent.len() && share.is_finite();
            return is_whole.then_some(share / 100.0 * self.viewport?[axis]);
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
        let axis = usize::from(matches!(name, "y" | "height" | "cy" | "ry" | "y1" | "y2"));
        let Some(text) = tag.property(name)?.filter(|text| text != "auto") else {
            return Ok(None);
        };
        let is_known = name != "r" || !text.ends_with('%');
        let length = is_known.then(|| self.measure(&text, axis)).flatten();
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
mod tests {
    use crate::document::svg_paths;
    use kurbo::Point;

    /// Where a file places the point (3, 4), which its path begins with.
    fn placed(text: &str) -> Option<Point> {
        let paths = svg_paths(text).unwrap().paths;
        let (_, map) = paths[0].contours.as_ref().ok()?;
        Some(*map * Point::new(3.0, 4.0))
    }

    fn near(text: &str, x: f64, y: f64) {
        let found = placed(text).unwrap();
        assert!(found.distance(Point::new(x, y)) < 1e-12, "{text}: {found}");
    }

    const PATH: &str = "<path d='M3 4L5 5'/>";

    /// A scale of 5 fits 10 by 10 into 100 by 50, one of 10 covers it.
    #[test]
    fn a_view_box_fits_as_it_is_asked_to() {
        for (how, x, y) in [
            ("", 40.0, 25.0),
            ("xMidYMid", 40.0, 25.0),
            ("xMinYMin", 15.0, 25.0),
            ("xMaxYMax meet", 65.0, 25.0),
            ("xMidYMid slice", 20.0, 5.0),
            ("xMaxYMin slice", 20.0, 30.0),
            ("xMinYMax slice", 20.0, -20.0),
            ("none", 20.0, 25.0),
            ("xMidYMid  slice", 20.0, 5.0),
            // No such words: as if there were none.
            ("defer xMinYMin", 40.0, 25.0),
            ("xMinYMin meet x", 40.0, 25.0),
            ("xMinYMin,slice", 40.0, 25.0),
            ("xMinYMi", 40.0, 25.0),
            ("xMinYMax cut", 40.0, 25.0),
            ("slice", 40.0, 25.0),
        ] {
            let text = format!(
                "<svg viewBox='0 0 200 100'><svg x='10' y='20' width='100' height='50' viewBox='2 3 10 10' preserveAspectRatio='{how}'>{PATH}</svg></svg>"
            );
            near(&text.replace(" preserveAspectRatio=''", ""), x, y);
        }
    }

    #[test]
    fn a_viewport_has_the_size_of_the_one_around_it() {
        let inner = format!("<svg viewBox='0 0 10 10' preserveAspectRatio='none'>{PATH}</svg>");
        for outer in [
            "viewBox='0 0 200 100'",
            "width='200' height='100'",
            "width='7' height='7' viewBox='5 5 200 100'",
            "viewBox=' 5-5,200 ,\n100 '",
        ] {
            near(&format!("<svg {outer}>{inner}</svg>"), 60.0, 40.0);
        }
        for unknown in [
            "",
            "width='200'",
            "viewBox='0 0 0 5'",
            "viewBox='0 0 5 0'",
            "viewBox='0 0 5'",
            "viewBox='0 0 5 5 5'",
            "viewBox='0 0 inf 5'",
            "viewBox='0 0 1e999 5'",
            "viewBox='0 0 5,,5'",
            "viewBox='0 0 5 5,'",
        ] {
            assert_eq!(
                placed(&format!("<svg {unknown}>{inner}</svg>")),
                None,
                "{unknown}"
            );
        }
        let between = "<svg width='100' height='50' viewBox='0 0 10 10'>";
        near(&format!("<svg>{between}{inner}</svg></svg>"), 40.0, 20.0);
        let without = "<svg x='10' y='20' width='100' height='50'>";
        near(&format!("<svg>{without}{PATH}</svg></svg>"), 13.0, 24.0);
        near(&format!("<svg>{without}{inner}</svg></svg>"), 40.0, 40.0);
        // The first `svg` is the outermost one, whatever stands around it.
        near(
            &format!("<g><svg x='9' width='100' height='50' viewBox='0 0 1 1'>{PATH}</svg></g>"),
            3.0,
            4.0,
        );
    }

    /// A quarter turn about (x, y) takes (3, 4) to (x + y - 4, y - x + 3).
    #[test]
    fn a_transform_has_its_origin() {
        let text = |origin: &str, size: &str| {
            format!(
                "<svg {size}><path transform='rotate(90)' transform-origin='{origin}' d='M3 4L5 5'/></svg>"
            )
        };
        for (origin, x, y) in [
            ("10 20", 10.0, 20.0),
            ("10px 20px", 10.0, 20.0),
            ("left top", 0.0, 0.0),
            ("top left", 0.0, 0.0),
            ("right bottom", 200.0, 100.0),
            ("bottom right", 200.0, 100.0),
            ("center", 100.0, 50.0),
            ("center left", 0.0, 50.0),
            ("top center", 100.0, 0.0),
            ("bottom", 100.0, 100.0),
            ("10", 10.0, 50.0),
            ("25% 10%", 50.0, 10.0),
            ("TOP", 100.0, 0.0),
            ("right 7px", 200.0, 7.0),
        ] {
            near(
                &text(origin, "viewBox='0 0 200 100'"),
                x + y - 4.0,
                y - x + 3.0,
            );
        }
        near(&text("left top", ""), -4.0, 3.0);
        for origin in ["center", "right top", "10", "50% 1", "1 2 3", "a b"] {
            assert_eq!(placed(&text(origin, "")), None, "{origin}");
        }
        for origin in [
            "left right",
            "top bottom",
            "top 7",
            "7 left",
            "inf% 0",
            "NaN% 0",
            "1e999 0",
            "5%% 0",
        ] {
            let sized = text(origin, "viewBox='0 0 200 100'");
            assert_eq!(placed(&sized), None, "{origin}");
        }
    }

    #[test]
    fn units_stand_where_css_has_them() {
        let path =
            |transform: &str| format!("<svg><path transform='{transform}' d='M3 4L5 5'/></svg>");
        for (transform, x, y) in [
            ("translate(5px, 6px)", 8.0, 10.0),
            ("rotate(90deg) , translate(1px)", -4.0, 4.0),
            ("skewX(45deg)scale(2)", 14.0, 8.0),
        ] {
            near(&path(transform), x, y);
        }
        for transform in [
            "scale(2deg)",
            "scale(2px)",
            "matrix(1 0 0 1 0 0px)",
            "translate(5deg)",
            "rotate(5px)",
            "translate(px5)",
            "rotate(1rad)",
        ] {
            assert_eq!(placed(&path(transform)), None, "{transform}");
        }
    }

    #[test]
    fn what_is_not_read_is_refused() {
        let style = |style: &str| format!("<svg><path style='{style}' d='M3 4L5 5'/></svg>");
        for said in [
            "translate:none",
            "rotate : none",
            "transform:none",
            "transform:scale(1);transform-box:fill-box",
        ] {
            near(&style(said), 3.0, 4.0);
        }
        near(
            &style("transform:scale(2);transform-origin:1px 1px;transform-box:view-box"),
            5.0,
            7.0,
        );
        for said in [
            "translate:1px",
            "rotate:5deg",
            "scale:2",
            "offset-path:none;offset-path:path(\"\")",
            "offset:path(\"M1 1\") 50%",
            "transform:scale(2);transform-box:fill-box",
            "transform:scale(2);transform-origin:1px 1px;transform-box:fill-box",
        ] {
            assert_eq!(placed(&style(said)), None, "{said}");
        }
    }
}
