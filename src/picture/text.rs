//! Lines of words, and their outlines: a part of the font `DejaVu` Sans (its licence stands beside it) that holds what plots say.

use kurbo::{Affine, CubicBez, Line, PathSeg, Point, QuadBez};
use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, GlyphId, MetadataProvider as _};

use crate::curve::Curve;

/// The fonts that a format asks for that sets words itself: the one whose outlines the others draw, and what is like it.
pub(crate) const FAMILY: &str = "DejaVu Sans, Verdana, Arial, sans-serif";

/// `DejaVu` Sans 2.37, cut down by `pyftsubset` of fonttools to the characters of plots.
static FONT: &[u8] = include_bytes!("font/DejaVuSans-subset.ttf");

/// The units of the font in an em.
const EM: f64 = 2048.0;

/// A quarter turn against the clock on a page whose +y is down.
const UPWARDS: Affine = Affine::new([0.0, -1.0, 1.0, 0.0, 0.0, 0.0]);

/// Which point of a line of words stands at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Where it starts.
    Start,
    /// Its middle.
    Middle,
    /// Where it ends.
    End,
}

/// A line of words on a page whose +y is down.
#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    /// Where it stands, on the base line.
    pub at: Point,
    /// What it says.
    pub words: String,
    /// The size of the font.
    pub size: f64,
    /// Which point of it stands there.
    pub anchor: Anchor,
    /// Whether it runs upwards.
    pub upwards: bool,
}

impl Text {
    /// The outlines of its letters in their place, in cubics, which every format can draw.
    #[must_use]
    pub fn outlines(&self) -> Vec<Curve> {
        let shift = width(&self.words, self.size)
            * match self.anchor {
                Anchor::Start => 0.0,
                Anchor::Middle => 0.5,
                Anchor::End => 1.0,
            };
        let turn = if self.upwards {
            UPWARDS
        } else {
            Affine::IDENTITY
        };
        let scale = self.size / EM;
        let place = Affine::translate(self.at.to_vec2())
            * turn
            * Affine::translate((-shift, 0.0))
            * Affine::scale_non_uniform(scale, -scale);
        letters(&self.words)
            .iter()
            .map(|contour| contour.transformed(place))
            .collect()
    }
}

/// The width of a line of words at this size.
pub(super) fn width(words: &str, size: f64) -> f64 {
    let units: f64 = with_font(advance, words).sum();
    units * size / EM
}

/// What `of` makes of the glyph of each character; nothing where the font cannot be read, which a test excludes.
fn with_font<T>(
    of: impl Fn(&FontRef<'static>, GlyphId) -> T,
    words: &str,
) -> impl Iterator<Item = T> {
    FontRef::new(FONT).into_iter().flat_map(move |font| {
        let map = font.charmap();
        let glyphs = words.chars().map(|c| map.map(c).unwrap_or_default());
        glyphs.map(|glyph| of(&font, glyph)).collect::<Vec<T>>()
    })
}

fn advance(font: &FontRef<'static>, glyph: GlyphId) -> f64 {
    let metrics = font.glyph_metrics(Size::unscaled(), LocationRef::default());
    f64::from(metrics.advance_width(glyph).unwrap_or(0.0))
}

/// The contours of a line of words in the units of the font, its base line from the origin, +y up.
fn letters(words: &str) -> Vec<Curve> {
    let mut pen = Contours::default();
    let glyphs = with_font(
        |font, glyph| (font.outline_glyphs().get(glyph), advance(font, glyph)),
        words,
    );
    for (outline, advance) in glyphs {
        if let Some(outline) = outline {
            let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
            // A glyph that cannot be drawn leaves its place free.
            let _ = outline.draw(settings, &mut pen);
        }
        pen.left += advance;
    }
    pen.curves
}

/// Takes down contours.
#[derive(Default)]
struct Contours {
    curves: Vec<Curve>,
    /// Where the glyph begins.
    left: f64,
    start: Point,
    at: Point,
}

impl Contours {
    fn point(&self, x: f32, y: f32) -> Point {
        Point::new(self.left + f64::from(x), f64::from(y))
    }

    fn push(&mut self, segment: PathSeg, to: Point) {
        if let Some(curve) = self.curves.last_mut() {
            curve.segments.push(segment);
        }
        self.at = to;
    }
}

impl OutlinePen for Contours {
    fn move_to(&mut self, x: f32, y: f32) {
        self.start = self.point(x, y);
        self.at = self.start;
        self.curves.push(Curve {
            segments: Vec::new(),
            closed: true,
        });
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let to = self.point(x, y);
        self.push(PathSeg::Line(Line::new(self.at, to)), to);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let to = self.point(x, y);
        let quadratic = QuadBez::new(self.at, self.point(x1, y1), to);
        self.push(PathSeg::Cubic(quadratic.raise()), to);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let to = self.point(x, y);
        let cubic = CubicBez::new(self.at, self.point(x1, y1), self.point(x2, y2), to);
        self.push(PathSeg::Cubic(cubic), to);
    }

    fn close(&mut self) {
        if self.at != self.start {
            self.push(PathSeg::Line(Line::new(self.at, self.start)), self.start);
        }
    }
}

#[cfg(test)]
mod tests {
    use kurbo::Shape as _;

    use super::*;

    #[test]
    fn the_font_holds_what_plots_say() {
        let font = FontRef::new(FONT).unwrap();
        let said = "κ′″²³°−×·√ε⁰¹⁴⁵⁶⁷⁸⁹⁻ éABCabc0123456789(+),.:;/%=<>–\"'";
        for c in said.chars() {
            assert!(font.charmap().map(c).is_some(), "{c}");
        }
        assert_eq!(
            f64::from(
                font.metrics(Size::unscaled(), LocationRef::default())
                    .units_per_em
            ),
            EM
        );
        assert!(width("mm", 10.0) > 1.9 * width("m", 10.0));
    }

    #[test]
    fn letters_stand_upright_where_they_were_put() {
        let text = |anchor, upwards| Text {
            at: Point::new(100.0, 50.0),
            words: "L".to_owned(),
            size: 20.0,
            anchor,
            upwards,
        };
        let bounds = |text: Text| {
            text.outlines()
                .iter()
                .filter_map(Curve::bounding_box)
                .reduce(|a, b| a.union(b))
                .unwrap()
        };
        let plain = bounds(text(Anchor::Start, false));
        assert!(plain.x0 > 100.0 && plain.x1 < 120.0 && plain.y1 == 50.0 && plain.y0 < 40.0);
        let ending = bounds(text(Anchor::End, false));
        assert!(ending.x1 < 100.0);
        let upwards = bounds(text(Anchor::Start, true));
        assert!((upwards.x1 - 100.0).abs() < 1e-9 && upwards.y1 < 50.0 && upwards.x0 < 90.0);
        // The stem of the L is at its left: more ink there.
        let area: f64 = text(Anchor::Start, false)
            .outlines()
            .iter()
            .map(|c| kurbo::BezPath::from_path_segments(c.segments.iter().copied()).area())
            .sum();
        assert!(area.abs() > 10.0);
    }
}
