//! Path data that are a whole circle, ellipse or round rectangle, by numbers of few decimals.

use core::ops::Range;

use kurbo::{CubicBez, ParamCurve as _, PathSeg, Point, Rect, Shape as _, Vec2};

use crate::arcs::recognize::{MARGIN, Rules};
use crate::arcs::turn::{UprightEllipse, turned};
use crate::contour::{Contour, Step};
use crate::document::path::runs::{decimals, rules};
use crate::document::style::property::ElementKind;
use crate::joints::Tolerance;
use crate::number::{push_shortest, round};
use crate::path;

/// Longer path data are no shape of few curves.
const LONGEST: usize = 2000;

/// How many decimals more than the file a shape's numbers may have.
const MORE_DECIMALS: u8 = 1;

/// Curves that keep to one side stray so many times as far from the circle that was meant as from the one in their middle.
const ONE_SIDED: f64 = 2.0;

/// How far curves may lie from the circle on which their joints do, as a part of its radius, to be drawn like it: two Béziers of half a turn lie
/// nearly so far.
const ROUGHEST: f64 = 0.02;

/// What the last bits of a number may be off, as a part of it.
const NOISE: f64 = 1e-12;

/// A whole shape.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::document) struct Whole {
    pub(in crate::document) kind: ElementKind,
    /// The values of its attributes, as [`ElementKind::geometry`] has them; a rectangle of equal radii has one of them.
    numbers: Vec<f64>,
    /// A bound, both ways, of its distance from the path.
    pub(in crate::document) strayed: f64,
    /// Whether the path starts and runs as renderers draw the shape, so that dashes stay where they are.
    pub(in crate::document) starts_alike: bool,
}

impl Whole {
    /// The attributes, without the quote that ends the last one.
    pub(in crate::document) fn attributes(&self, quote: u8) -> Vec<u8> {
        let mut out = Vec::new();
        for (name, number) in self.kind.geometry().iter().zip(&self.numbers) {
            if !out.is_empty() {
                out.extend([quote, b' ']);
            }
            out.extend_from_slice(name.as_bytes());
            out.extend([b'=', quote]);
            // With the zero before the point: attributes are read by more programs than path data are.
            push_shortest(&mut out, *number);
        }
        out
    }
}

/// The shape that the path data in `text[span]` are; `None` where they are anything else.
pub(in crate::document) fn find(
    text: &str,
    span: Range<usize>,
    tolerance: Option<Tolerance>,
) -> Option<Whole> {
    let data = text.get(span)?.trim_ascii();
    let closes = data.ends_with(['z', 'Z']);
    if !closes || data.len() > LONGEST || data.matches(['m', 'M', 'z', 'Z']).count() != 2 {
        return None;
    }
    let rules = rules(tolerance, decimals(data.as_bytes())?);
    let contours = path::contours(data).ok()?;
    let [contour] = &contours[..] else {
        return None;
    };
    let segments = segments(contour)?;
    let bounds = segments
        .iter()
        .map(PathSeg::bounding_box)
        .reduce(|a, b| a.union(b))?;
    ellipse(&segments, bounds, &rules).or_else(|| rect(&segments, bounds, &rules))
}

/// The shape of the fewest decimals, of its place and of its radii, that is as good as that of these numbers but for what rounding of the
/// file explains: nobody meant others, however wide the tolerance is.
fn meant<const P: usize>(
    (place, radii): ([f64; P], [f64; 2]),
    rules: &Rules,
    shape: impl Fn([f64; P], [f64; 2]) -> Option<Whole>,
) -> Option<Whole> {
    let explained = ONE_SIDED * MARGIN * shape(place, radii)?.strayed + 2.0 * rules.moved();
    let is_near = |a: f64, b: f64| (a - b).abs() <= explained;
    let attempt = |(a, b)| {
        let (near, few) = (rounded(place, a), rounded(radii, b));
        let (mut places, mut sizes) = (near.iter().zip(&place), few.iter().zip(&radii));
        let is_explained =
            places.all(|(a, b)| is_near(*a, *b)) && sizes.all(|(a, b)| is_near(*a, *b));
        let drawn = is_explained.then(|| shape(near, few)).flatten();
        drawn.filter(|shape| shape.strayed <= explained)
    };
    (0..=rules.decimals.saturating_add(MORE_DECIMALS)).find_map(|most| {
        let fewer_of_radii = (0..=most).map(|few| (most, few));
        let fewer_of_place = (0..most).map(|few| (few, most));
        fewer_of_radii.chain(fewer_of_place).find_map(attempt)
    })
}

/// The steps that lead anywhere, where none is an arc.
fn segments(contour: &Contour) -> Option<Vec<PathSeg>> {
    let given = |step: &Step| match step {
        Step::Given(segment) => Some(*segment),
        Step::Arc(_) => None,
    };
    let all: Vec<PathSeg> = contour.steps.iter().map(given).collect::<Option<_>>()?;
    let size = all
        .iter()
        .map(|s| s.start().distance(s.end()))
        .fold(0.0, f64::max);
    let leads = |segment: &PathSeg| segment.start().distance(segment.end()) > 1e-9 * size;
    Some(all.into_iter().filter(leads).collect())
}

/// Numbers rounded to this many decimals.
fn rounded<const N: usize>(numbers: [f64; N], decimals: u8) -> [f64; N] {
    numbers.map(|number| round(number, decimals))
}

/// Both radii, or their mean twice where rounding explains that they differ.
fn evened(radii: Vec2, rules: &Rules) -> (Vec2, bool) {
    let mean = f64::midpoint(radii.x, radii.y);
    let is_even = (radii.x - radii.y).abs() <= 2.0 * rules.slack(mean);
    (if is_even { Vec2::splat(mean) } else { radii }, is_even)
}

fn ellipse(segments: &[PathSeg], bounds: Rect, rules: &Rules) -> Option<Whole> {
    let cubics: Vec<CubicBez> = segments
        .iter()
        .map(|segment| (!matches!(segment, PathSeg::Line(_))).then(|| segment.to_cubic()))
        .collect::<Option<_>>()?;
    let (center, size) = (bounds.center(), bounds.size());
    let (radii, is_circle) = evened(size.to_vec2() / 2.0, rules);
    let start = segments.first()?.start();
    let shape = |[cx, cy]: [f64; 2], [rx, ry]: [f64; 2]| {
        let turn = UprightEllipse {
            center: Point::new(cx, cy),
            radii: Vec2::new(rx, ry),
        };
        let is_meant = segments
            .iter()
            .all(|segment| turn.off(segment.start()) <= MARGIN * rules.moved());
        let rules = if is_meant {
            Rules {
                part: rules.part.max(ROUGHEST),
                ..*rules
            }
        } else {
            *rules
        };
        let (swept, strayed) = turned(&cubics, &turn, &rules)?;
        let fits = (swept.abs() - 360.0).abs() < 1.0 && strayed <= rules.room(rx.max(ry));
        fits.then(|| Whole {
            kind: if is_circle {
                ElementKind::Circle
            } else {
                ElementKind::Ellipse
            },
            numbers: if is_circle {
                vec![cx, cy, rx]
            } else {
                vec![cx, cy, rx, ry]
            },
            strayed,
            starts_alike: swept > 0.0
                && start.distance(turn.center + Vec2::new(rx, 0.0)) <= rules.slack(rx),
        })
    };
    let found = meant(([center.x, center.y], [radii.x, radii.y]), rules, shape)?;
    // What was meant may be farther off than is allowed: then it is that or nothing.
    let room = rules.of_what_is_meant().room(radii.x.max(radii.y));
    (found.strayed <= room).then_some(found)
}

/// A rectangle with round corners.
struct RoundRect {
    bounds: Rect,
    radii: Vec2,
}

impl RoundRect {
    /// The corner on whose side of the middle a point lies: its ellipse, and the way from the middle to it.
    fn corner(&self, p: Point) -> (UprightEllipse, Vec2) {
        let middle = self.bounds.center();
        let out = Vec2::new((p.x - middle.x).signum(), (p.y - middle.y).signum());
        let half = self.bounds.size().to_vec2() / 2.0 - self.radii;
        let center = middle + Vec2::new(out.x * half.x, out.y * half.y);
        (
            UprightEllipse {
                center,
                radii: self.radii,
            },
            out,
        )
    }

    /// How far a cubic lies from its corner, and how far it turns there, in degrees.
    fn bend(&self, cubic: &CubicBez, rules: &Rules) -> Option<(f64, f64)> {
        let room = rules.slack(self.radii.x.max(self.radii.y));
        let (turn, out) = self.corner(cubic.eval(0.5));
        let beyond = |p: Point| {
            let v = p - turn.center;
            v.x * out.x >= -room && v.y * out.y >= -room
        };
        let (swept, strayed) = turned(&[*cubic], &turn, rules)?;
        (beyond(cubic.p0) && beyond(cubic.p3)).then_some((swept, strayed))
    }

    /// How far a line lies from its side, and the sense in which it runs about the middle.
    fn side(&self, from: Point, to: Point, room: f64) -> Option<(f64, f64)> {
        let (way, middle) = (to - from, self.bounds.center());
        let half = self.bounds.size().to_vec2() / 2.0;
        let [u, v] = [from, to].map(|p| p - middle);
        let is_level = way.x.abs() > way.y.abs();
        let turned = |v: Vec2| if is_level { v } else { Vec2::new(v.y, v.x) };
        let [u, v, half, radii] = [u, v, half, self.radii].map(turned);
        let off = (u.y.abs() - half.y).abs().max((v.y.abs() - half.y).abs());
        let over = (u.x.abs().max(v.x.abs()) - (half.x - radii.x)).max(0.0);
        let sense = u.cross(v).signum() * if is_level { 1.0 } else { -1.0 };
        (off <= room && over <= room && u.y * v.y > 0.0).then_some((sense, off.max(over)))
    }
}

fn rect(segments: &[PathSeg], bounds: Rect, rules: &Rules) -> Option<Whole> {
    let (radii, _) = evened(corner_radii(segments)?, rules);
    let (place, size) = (bounds.origin(), bounds.size());
    let place = [place.x, place.y, size.width, size.height];
    meant((place, [radii.x, radii.y]), rules, |place, radii| {
        round_rect(segments, place, radii, rules)
    })
}

fn round_rect(
    segments: &[PathSeg],
    [x, y, width, height]: [f64; 4],
    [rx, ry]: [f64; 2],
    rules: &Rules,
) -> Option<Whole> {
    let room = rules.slack(rx.max(ry));
    let shape = RoundRect {
        bounds: Rect::new(x, y, x + width, y + height),
        radii: Vec2::new(rx, ry),
    };
    // Numbers that are not yet rounded have their noise.
    let fit = 2.0 * rx <= width * (1.0 + NOISE) && 2.0 * ry <= height * (1.0 + NOISE);
    if !(rx > 0.0 && ry > 0.0 && fit) {
        return None;
    }
    let (mut swept, mut sense, mut strayed) = (0.0, 0.0, 0.0_f64);
    for segment in segments {
        let off = if let PathSeg::Line(line) = segment {
            let (way, off) = shape.side(line.p0, line.p1, room)?;
            if sense * way < 0.0 {
                return None;
            }
            sense = way;
            off
        } else {
            let (turn, off) = shape.bend(&segment.to_cubic(), rules)?;
            swept += turn;
            off
        };
        strayed = strayed.max(off);
    }
    // A joint may lie beside both of its neighbours, and then a bit of the outline between them.
    let strayed = 2.0 * strayed;
    let fits =
        sense != 0.0 && (swept - 360.0 * sense).abs() < 1.0 && strayed <= rules.room(rx.max(ry));
    let start = segments.first()?.start();
    fits.then(|| Whole {
        kind: ElementKind::Rect,
        numbers: if rx == ry {
            vec![x, y, width, height, rx]
        } else {
            vec![x, y, width, height, rx, ry]
        },
        strayed,
        starts_alike: sense > 0.0 && start.distance(Point::new(x + rx, y)) <= room,
    })
}

/// The radii of the first corner between two lines: the extent of its curves, or half of it where they turn back.
fn corner_radii(segments: &[PathSeg]) -> Option<Vec2> {
    let is_line = |segment: &PathSeg| matches!(segment, PathSeg::Line(_));
    let first = segments.iter().position(is_line)?;
    let around = segments[first..]
        .iter()
        .chain(&segments[..first])
        .skip_while(|s| is_line(s));
    let corner: Vec<PathSeg> = around.take_while(|s| !is_line(s)).copied().collect();
    let size = corner
        .iter()
        .map(PathSeg::bounding_box)
        .reduce(|a, b| a.union(b))?
        .size()
        .to_vec2();
    let way = corner.last()?.end() - corner.first()?.start();
    Some(if way.x.abs() < 0.1 * size.x {
        Vec2::new(size.x, size.y / 2.0)
    } else if way.y.abs() < 0.1 * size.y {
        Vec2::new(size.x / 2.0, size.y)
    } else {
        size
    })
}

#[cfg(test)]
mod tests;
