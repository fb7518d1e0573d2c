//! PNG previews, which draw the emitted Béziers themselves.

use kurbo::{Affine, ParamCurve, PathSeg, Point};
use tiny_skia::{
    FillRule, LineJoin, Paint as Ink, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

use crate::curve::{Curve, control_points};
use crate::error::{Error, PictureError, Result};
use crate::picture::paint::{Color, Paint};
use crate::picture::scene::{Mark, Pen, Scene};
use crate::picture::size::Size;

/// The pixels on the larger side where no size is asked for.
const LARGER_SIDE: f64 = 512.0;
/// The most pixels that a picture may have.
const MOST_PIXELS: f64 = 1e8;
/// The most pixels on a side.
const LONGEST_SIDE: f64 = 32_767.0;
/// The most segments in a picture.
const MOST_SEGMENTS: usize = 100_000;
/// The most segments times the pixels that their stroke is wide: each row of pixels meets every segment within half of that.
const MOST_STROKED: f64 = 1e7;
/// tiny-skia flattens a long curve so coarsely that it strays by a quarter of a pixel; it gets pieces about this many pixels long.
const PIECE: f64 = 16.0;
/// Strokes narrower than this many pixels are left to tiny-skia's hairlines, which do not break up; its hairlines up to a whole
/// pixel, which it would take by itself, stray by half a pixel.
const HAIRLINE: f32 = 0.25;
/// The most pieces of a segment.
const MOST_PIECES: f64 = 64.0;

/// The picture as a PNG file.
///
/// # Errors
///
/// Where it would have more than 10^8 pixels, more than 32767 on a side, or more than 10^5 segments; nothing is allocated then.
pub fn encode(scene: &Scene) -> Result<Vec<u8>> {
    let canvas = scene.canvas();
    let [width, height] = pixels(scene)?;
    let scale = (f64::from(width) / canvas.width()).min(f64::from(height) / canvas.height());
    check_segments(scene, scale, f64::from(width.max(height)))?;
    let mut pixmap =
        Pixmap::new(width, height).ok_or_else(|| too_large(width.into(), height.into()))?;
    if let Some(color) = scene.background.unwrap_or(Paint::WHITE).visible() {
        pixmap.fill(skia_color(color));
    }
    let to_pixels = Affine::translate((f64::from(width) / 2.0, f64::from(height) / 2.0))
        * Affine::scale(scale)
        * Affine::translate(-canvas.center().to_vec2());
    for group in &scene.groups {
        for mark in &group.marks {
            // In `f64`, so that a small shape far from the origin keeps its digits.
            let curves = scene.curves(mark)?;
            let curves = curves.iter().map(|curve| curve.transformed(to_pixels));
            if let Some(path) = skia_path(curves) {
                draw(&mut pixmap, &path, &group.pen, scale);
            }
        }
    }
    pixmap
        .encode_png()
        .map_err(|error| Error::Picture(PictureError::Encoder(error.to_string())))
}

/// Width and height in pixels.
fn pixels(scene: &Scene) -> Result<[u32; 2]> {
    let [width, height] = scene.size.map_or_else(
        || {
            let (width, height) = (scene.view.width(), scene.view.height());
            let scale = LARGER_SIDE / width.max(height);
            [width * scale, height * scale]
        },
        Size::pixels,
    );
    let [width, height] = [width, height].map(|side| side.round().max(1.0));
    // Written so that a product that is not a number is refused too.
    if width * height <= MOST_PIXELS && width.max(height) <= LONGEST_SIDE {
        Ok([width as u32, height as u32])
    } else {
        Err(too_large(width, height))
    }
}

fn too_large(width: f64, height: f64) -> Error {
    Error::Picture(PictureError::TooManyPixels {
        width,
        height,
        longest: LONGEST_SIDE,
    })
}

/// Refuses what would take minutes in a picture whose larger side is `side` pixels, `scale` of them to a unit.
fn check_segments(scene: &Scene, scale: f64, side: f64) -> Result<()> {
    let (mut count, mut stroked) = (0, 0.0);
    for group in &scene.groups {
        let segments: usize = group.marks.iter().map(segments).sum();
        let stroke = group.pen.visible_stroke();
        let pixels = stroke.map_or(0.0, |(_, width)| (width * scale).clamp(1.0, side));
        count += segments;
        stroked += segments as f64 * pixels;
    }
    if count > MOST_SEGMENTS {
        let most = MOST_SEGMENTS;
        return Err(Error::Picture(PictureError::TooManySegments {
            count,
            most,
        }));
    }
    if stroked > MOST_STROKED {
        return Err(Error::Picture(PictureError::StrokeTooWide { count }));
    }
    Ok(())
}

/// How many segments a mark has that can have many.
fn segments(mark: &Mark) -> usize {
    match mark {
        Mark::Curve(curve) => curve.segments.len(),
        Mark::Path(curves) => curves.iter().map(|curve| curve.segments.len()).sum(),
        Mark::Arcs(courses) => courses.iter().map(|course| course.steps.len()).sum(),
        _ => 0,
    }
}

/// `None` where there are no segments, or some too far away for single precision.
fn skia_path(curves: impl Iterator<Item = Curve>) -> Option<Path> {
    let mut path = PathBuilder::new();
    for curve in curves {
        push_curve(&mut path, &curve);
    }
    path.finish()
}

fn push_curve(path: &mut PathBuilder, curve: &Curve) {
    let single = |p: Point| (p.x as f32, p.y as f32);
    let Some(start) = curve.start() else { return };
    let (x, y) = single(start);
    path.move_to(x, y);
    for segment in curve.segments.iter().flat_map(pieces) {
        match segment {
            PathSeg::Line(l) => {
                let (x, y) = single(l.p1);
                path.line_to(x, y);
            }
            PathSeg::Quad(q) => {
                let ((x1, y1), (x, y)) = (single(q.p1), single(q.p2));
                path.quad_to(x1, y1, x, y);
            }
            PathSeg::Cubic(c) => {
                let ((x1, y1), (x2, y2), (x, y)) = (single(c.p1), single(c.p2), single(c.p3));
                path.cubic_to(x1, y1, x2, y2, x, y);
            }
        }
    }
    if curve.closed {
        path.close();
    }
}

/// The same curve in several pieces.
fn pieces(segment: &PathSeg) -> impl Iterator<Item = PathSeg> {
    let length: f64 = control_points(segment)
        .windows(2)
        .map(|pair| pair[0].distance(pair[1]))
        .sum();
    let count = match segment {
        PathSeg::Line(_) => 1.0,
        _ => (length / PIECE).ceil().clamp(1.0, MOST_PIECES),
    };
    (0..count as u32)
        .map(move |i| segment.subsegment(f64::from(i) / count..f64::from(i + 1) / count))
}

fn draw(pixmap: &mut Pixmap, path: &Path, pen: &Pen, scale: f64) {
    if let Some(color) = pen.fill.visible() {
        fill(pixmap, path, color);
    }
    let Some((color, width)) = pen.visible_stroke() else {
        return;
    };
    // An odd number of lengths takes dashes and gaps in turn when it comes round, which tiny-skia wants spelt out.
    let rounds = 1 + pen.dash.len() % 2;
    let lengths = pen.dash.iter().map(|length| (length * scale) as f32);
    let lengths: Vec<f32> = lengths.collect();
    let stroke = Stroke {
        width: (width * scale) as f32,
        line_join: LineJoin::Round,
        dash: StrokeDash::new(lengths.repeat(rounds), 0.0),
        ..Stroke::default()
    };
    if stroke.width < HAIRLINE {
        pixmap.stroke_path(path, &ink(color), &stroke, Transform::identity(), None);
        return;
    }
    let dashed = stroke.dash.as_ref().and_then(|dash| path.dash(dash, 1.0));
    if let Some(outline) = dashed.as_ref().unwrap_or(path).stroke(&stroke, 1.0) {
        fill(pixmap, &outline, color);
    }
}

fn fill(pixmap: &mut Pixmap, path: &Path, color: Color) {
    pixmap.fill_path(
        path,
        &ink(color),
        FillRule::Winding,
        Transform::identity(),
        None,
    );
}

fn ink(color: Color) -> Ink<'static> {
    let mut ink = Ink::default();
    ink.set_color(skia_color(color));
    ink
}

fn skia_color(color: Color) -> tiny_skia::Color {
    tiny_skia::Color::from_rgba8(color.red, color.green, color.blue, color.alpha)
}
