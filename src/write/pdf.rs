//! PDF: one page that fits, its content in vector operators.
//!
//! pdf-writer makes the file around the content. The content is written here, because pdf-writer takes numbers in single precision and
//! the control points are to be the very ones of the curve.

use std::borrow::Cow;
use std::collections::BTreeSet;

use kurbo::{Affine, Shape as _};
use pdf_writer::writers::{ExtGraphicsState, Resources};
use pdf_writer::{Content, Name, Pdf, Rect, Ref, TextStr};

use super::postscript::{PathOperators, number, push_path, shares};
use crate::curve::Curve;
use crate::error::{Error, PictureError, Result};
use crate::number::Precision;
use crate::picture::paint::Paint;
use crate::picture::scene::{Group, Pen, Scene};
use crate::picture::size::Size;

const PATH: PathOperators = PathOperators {
    move_to: "m",
    line_to: "l",
    curve_to: "c",
    close: "h",
};

/// The larger side of a page, in points, between which a drawing is as large as its coordinates: readers take no other pages.
const SIDES: [f64; 2] = [3.0, 14_400.0];
/// The larger side of the page of a drawing that is larger or smaller than that.
const LARGER_SIDE: f64 = 512.0;

/// Beyond these, readers cut the numbers of `cm` and of points short: what is larger or smaller has coordinates of its page.
const LARGEST_SCALE: f64 = 1e6;
const LARGEST_COORDINATE: f64 = 1e7;
/// How coordinates of a page are rounded.
const ON_PAGE: Precision = Precision::Fixed(6);

const CATALOG: i32 = 1;
const PAGES: i32 = 2;
const PAGE: i32 = 3;
const CONTENT: i32 = 4;
const INFORMATION: i32 = 5;

/// The picture as a PDF file of one page. Where a size was asked for, it is in points; else the page is as large as the coordinates.
///
/// # Errors
///
/// Where the size that was asked for is larger than any page, and where a true shape is such that a curve along it could not be
/// drawn either.
pub fn document(scene: &Scene) -> Result<Vec<u8>> {
    let [width, height] = page(scene)?;
    let content = content(scene, width / scene.canvas().width())?;
    let mut pdf = Pdf::new();
    pdf.catalog(Ref::new(CATALOG)).pages(Ref::new(PAGES));
    pdf.pages(Ref::new(PAGES)).kids([Ref::new(PAGE)]).count(1);
    let mut page = pdf.page(Ref::new(PAGE));
    page.parent(Ref::new(PAGES))
        .media_box(Rect::new(0.0, 0.0, width as f32, height as f32))
        .contents(Ref::new(CONTENT));
    opacities(&mut page.resources(), scene);
    drop(page);
    pdf.stream(Ref::new(CONTENT), &content);
    let mut information = pdf.document_info(Ref::new(INFORMATION));
    information.title(TextStr(&scene.title));
    if !scene.description.is_empty() {
        information.subject(TextStr(&scene.description));
    }
    drop(information);
    Ok(pdf.finish())
}

/// Width and height of the page in points.
fn page(scene: &Scene) -> Result<[f64; 2]> {
    let [least, most] = SIDES;
    if let Some([width, height]) = scene.size.map(Size::points) {
        return if width.max(height) <= most {
            Ok([width, height])
        } else {
            Err(Error::Picture(PictureError::LargePage(most)))
        };
    }
    let sides = [scene.view.width(), scene.view.height()];
    let larger = sides[0].max(sides[1]);
    let scale = if (least..=most).contains(&larger) {
        1.0
    } else {
        LARGER_SIDE / larger
    };
    Ok(sides.map(|side| side * scale))
}

/// The opacities of what is translucent in the picture, each a graphics state by the name that [`opacity`] gives it.
fn opacities(resources: &mut Resources<'_>, scene: &Scene) {
    let paints = scene.groups.iter().flat_map(|group| {
        let stroke = group.pen.visible_stroke().map(|(color, _)| color);
        [stroke, group.pen.fill.visible()]
    });
    let background = scene.background.and_then(Paint::visible);
    let alphas: BTreeSet<u8> = paints
        .chain([background])
        .flatten()
        .map(|color| color.alpha)
        .filter(|&alpha| alpha < u8::MAX)
        .collect();
    if alphas.is_empty() {
        return;
    }
    let mut states = resources.ext_g_states();
    for alpha in alphas {
        let part = f32::from(alpha) / 255.0;
        let name = opacity(alpha);
        let mut state: ExtGraphicsState<'_> = states.insert(Name(name.as_bytes())).start();
        state.stroking_alpha(part).non_stroking_alpha(part);
    }
}

fn opacity(alpha: u8) -> String {
    format!("opacity{alpha}")
}

fn content(scene: &Scene, scale: f64) -> Result<Vec<u8>> {
    let canvas = scene.canvas();
    // +y of a page is up: what has a right way up is turned over.
    let (up, far) = if scene.upright {
        (-scale, canvas.y1 * scale)
    } else {
        (scale, -canvas.y0 * scale)
    };
    let to_page = Affine::new([scale, 0.0, 0.0, up, -canvas.x0 * scale, far]);
    let corners = [canvas.x0, canvas.x1, canvas.y0, canvas.y1];
    let reach = corners.into_iter().map(f64::abs).fold(0.0, f64::max);
    let (map, on_page) = if scale <= LARGEST_SCALE && reach <= LARGEST_COORDINATE {
        (to_page, None)
    } else {
        (Affine::IDENTITY, Some((to_page, scale)))
    };
    let [across, _, _, up, x, y] = map.as_coeffs().map(number);
    let mut out = format!("{across} 0 0 {up} {x} {y} cm\n1 j\n").into_bytes();
    if let Some(paint) = scene.background {
        let area = Curve {
            segments: canvas.path_segments(0.0).collect(),
            closed: true,
        };
        paint_path(&mut out, &Pen::filled(paint), &placed(&[area], on_page));
    }
    for group in &scene.groups {
        push_group(&mut out, group, scene, on_page)?;
    }
    Ok(out)
}

/// The curves in coordinates of the page, where there is a map to it.
fn placed(curves: &[Curve], on_page: Option<(Affine, f64)>) -> Cow<'_, [Curve]> {
    let Some((map, _)) = on_page else {
        return curves.into();
    };
    let on_page = |curve: &Curve| curve.transformed(map).rounded(ON_PAGE, &[]);
    curves.iter().map(on_page).collect()
}

fn push_group(
    out: &mut Vec<u8>,
    group: &Group,
    scene: &Scene,
    on_page: Option<(Affine, f64)>,
) -> Result<()> {
    let scale = on_page.map_or(1.0, |(_, scale)| scale);
    let number = |length: f64| number(length * scale);
    if let Some(id) = &group.id {
        out.extend_from_slice(&opened(id));
    }
    out.extend_from_slice(b"q\n");
    if let Some((_, width)) = group.pen.visible_stroke() {
        out.extend_from_slice(format!("{} w\n", number(width)).as_bytes());
    }
    if !group.pen.dash.is_empty() {
        let lengths: Vec<String> = group.pen.dash.iter().copied().map(number).collect();
        out.extend_from_slice(format!("[{}] 0 d\n", lengths.join(" ")).as_bytes());
    }
    for mark in &group.marks {
        paint_path(out, &group.pen, &placed(&scene.curves(mark)?, on_page));
    }
    out.extend_from_slice(b"Q\n");
    if group.id.is_some() {
        out.extend_from_slice(b"EMC\n");
    }
    Ok(())
}

/// What opens marked content of this id.
fn opened(id: &str) -> Vec<u8> {
    let mut content = Content::new();
    let mut mark = content.begin_marked_content_with_properties(Name(b"Shape"));
    mark.properties().pair(Name(b"ID"), TextStr(id));
    drop(mark);
    let mut bytes = content.finish().into_vec();
    bytes.push(b'\n');
    bytes
}

/// Fills the curves, then strokes them.
fn paint_path(out: &mut Vec<u8>, pen: &Pen, curves: &[Curve]) {
    let stroke = pen.visible_stroke().map(|(color, _)| (color, "RG", "S"));
    let fill = pen.fill.visible().map(|color| (color, "rg", "f"));
    for (color, set, paint) in fill.into_iter().chain(stroke) {
        let opaque = color.alpha == u8::MAX;
        if !opaque {
            out.extend_from_slice(format!("q\n/{} gs\n", opacity(color.alpha)).as_bytes());
        }
        let [red, green, blue] = shares(color);
        out.extend_from_slice(format!("{red} {green} {blue} {set}\n").as_bytes());
        for curve in curves {
            push_path(out, curve, &PATH);
        }
        out.extend_from_slice(format!("{paint}\n").as_bytes());
        if !opaque {
            out.extend_from_slice(b"Q\n");
        }
    }
}
