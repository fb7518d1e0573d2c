//! Text as outlines: a part of the font `DejaVu` Sans (its licence stands beside it) that holds what plots say.

use kurbo::{BezPath, Point};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// `DejaVu` Sans 2.37, cut down by `pyftsubset` of fonttools to the characters of plots.
static FONT: &[u8] = include_bytes!("font/DejaVuSans-subset.ttf");

/// The font, ready to use.
pub(super) struct Font {
    face: Option<Face<'static>>,
}

impl Font {
    pub(super) fn new() -> Self {
        Self {
            face: Face::parse(FONT, 0).ok(),
        }
    }

    fn glyphs<'a>(&'a self, text: &'a str) -> impl Iterator<Item = (&'a Face<'static>, GlyphId)> {
        self.face.iter().flat_map(move |face| {
            text.chars()
                .map(move |c| (face, face.glyph_index(c).unwrap_or(GlyphId(0))))
        })
    }

    /// The width of a line of text at this size.
    pub(super) fn width(&self, text: &str, size: f64) -> f64 {
        self.glyphs(text)
            .map(|(face, glyph)| advance(face, glyph, size))
            .sum()
    }

    /// The outlines of a line of text whose base line starts at the origin, y growing downwards.
    pub(super) fn outline(&self, text: &str, size: f64) -> BezPath {
        let mut pen = Pen {
            path: BezPath::new(),
            x: 0.0,
            scale: 0.0,
        };
        for (face, glyph) in self.glyphs(text) {
            pen.scale = size / f64::from(face.units_per_em());
            face.outline_glyph(glyph, &mut pen);
            pen.x += advance(face, glyph, size);
        }
        pen.path
    }
}

fn advance(face: &Face, glyph: GlyphId, size: f64) -> f64 {
    f64::from(face.glyph_hor_advance(glyph).unwrap_or(0)) * size / f64::from(face.units_per_em())
}

struct Pen {
    path: BezPath,
    x: f64,
    scale: f64,
}

impl Pen {
    fn at(&self, x: f32, y: f32) -> Point {
        Point::new(
            self.x + f64::from(x) * self.scale,
            -f64::from(y) * self.scale,
        )
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.path.move_to(self.at(x, y));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.path.line_to(self.at(x, y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.path.quad_to(self.at(x1, y1), self.at(x, y));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.path
            .curve_to(self.at(x1, y1), self.at(x2, y2), self.at(x, y));
    }

    fn close(&mut self) {
        self.path.close_path();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_holds_what_plots_say() {
        let font = Font::new();
        let face = font.face.as_ref().unwrap();
        let said = "κ′″²³°−×·√ε⁰¹⁴⁵⁶⁷⁸⁹⁻ éABCabc0123456789(+),.:;/%=<>–\"'";
        for c in said.chars() {
            assert!(face.glyph_index(c).is_some(), "{c}");
        }
        assert!(font.width("mm", 10.0) > 1.9 * font.width("m", 10.0));
    }
}
