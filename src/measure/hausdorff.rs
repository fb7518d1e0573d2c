//! The Hausdorff distance of two chains of Béziers by branch and bound.
//!
//! One way it is the largest distance of a point a(t) of the first chain from the second. Of a part of a cubic a, let b be the
//! cubic that the nearest points of both ends lie on, at u0 and u1, and f a cubic from u0 to u1 with the slopes that the nearest
//! point has there, u' = a'b'/(b'b' - (a - b)b''). No point of the part is farther away than |a(s) - b(f(s))|, whose square is a
//! polynomial of degree 18: its largest Bernstein coefficient is a bound, which nears the distance as the fourth power of the
//! part's length. Parts that stay below the largest distance found are done; the others are halved.

mod along;
#[cfg(test)]
mod exact;

use core::cmp::Ordering;
use std::collections::{BinaryHeap, HashSet};

use kurbo::{Affine, CubicBez, Line, ParamCurve as _, PathSeg, Point, Rect, Vec2};

use super::unit_for;
use crate::curve::{control_points, largest_coordinate};
use crate::numeric::bernstein::Polynomial;
pub(crate) use along::product;

use along::along;

/// How far where the tolerance lies between the distance found and its bound.
const CLOSE_GOAL: f64 = 1e-9;

/// How many parts are halved, beside some for each segment: where the distance is the same all along, it takes many.
const MOST_PARTS: usize = 20_000;

/// What rounding adds to a distance, in units of the last place of the largest coordinate.
const NOISE: f64 = 64.0 * f64::EPSILON;

/// How far two chains lie apart at most, both ways.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Apart {
    pub(crate) at_most: f64,
    /// The point found farthest away, and the segment that it lies on; none where there is no segment of its own.
    pub(crate) place: Option<(Point, usize)>,
    /// Whether it lies on the second chain.
    pub(crate) on_second: bool,
}

/// The distance of two chains that have segments, the larger of both ways. The bound lies by `goal` above it at most, as a part of it, but in
/// hard cases, and decides on a tolerance that lies between.
pub(crate) fn hausdorff(chains: [&[PathSeg]; 2], tolerance: f64, goal: f64) -> Apart {
    let (unit, [a, b]) = in_unit(chains);
    let aim = Aim {
        tolerance: tolerance / unit,
        goal,
    };
    let [there, back] = [a.farthest_from(&b, aim), b.farthest_from(&a, aim)];
    let on_second = there.at_most < back.at_most;
    let farthest = if on_second { back } else { there };
    let place = farthest.place;
    Apart {
        at_most: farthest.at_most * unit,
        place: place.map(|(point, segment)| ((point.to_vec2() * unit).to_point(), segment)),
        on_second,
    }
}

/// Two chains in a unit that suits their coordinates.
fn in_unit(chains: [&[PathSeg]; 2]) -> (f64, [Chain; 2]) {
    let largest = chains.map(largest_coordinate).into_iter();
    let unit = unit_for(largest.fold(f64::MIN_POSITIVE, f64::max));
    (unit, chains.map(|chain| Chain::new(chain, unit)))
}

/// What is to be known of a distance.
#[derive(Clone, Copy)]
struct Aim {
    tolerance: f64,
    goal: f64,
}

/// Segments as cubics, under a tree of boxes: node i holds the nodes 2i and 2i + 1, and the segment k is node n + k.
struct Chain {
    cubics: Vec<CubicBez>,
    /// Those that are straight.
    lines: Vec<Option<Line>>,
    boxes: Vec<Rect>,
    keys: Vec<Vec<u64>>,
}

/// The nearest point of a chain.
#[derive(Clone, Copy)]
struct Foot {
    segment: usize,
    u: f64,
    distance: f64,
}

/// How far a chain lies from another at most, and the point found farthest away, on the segment of that number.
struct Farthest {
    at_most: f64,
    place: Option<(Point, usize)>,
}

/// A part of a segment.
struct Part {
    segment: usize,
    cubic: CubicBez,
    feet: [Foot; 2],
    at_most: f64,
}

impl Chain {
    fn new(segments: &[PathSeg], unit: f64) -> Self {
        let map = Affine::scale(1.0 / unit);
        let segments: Vec<PathSeg> = segments.iter().map(|&s| map * s).collect();
        let cubics: Vec<CubicBez> = segments.iter().map(cubic).collect();
        let count = cubics.len();
        let mut boxes = vec![Rect::ZERO; 2 * count];
        for (k, cubic) in cubics.iter().enumerate() {
            boxes[count + k] = kurbo::Shape::bounding_box(cubic);
        }
        for i in (1..count).rev() {
            boxes[i] = boxes[2 * i].union(boxes[2 * i + 1]);
        }
        Self {
            cubics,
            lines: segments.iter().map(line).collect(),
            boxes,
            keys: segments.iter().map(key).collect(),
        }
    }

    /// One way.
    fn farthest_from(&self, other: &Self, aim: Aim) -> Farthest {
        let theirs: HashSet<&[u64]> = other.keys.iter().map(Vec::as_slice).collect();
        let mut search = Search::default();
        for (segment, cubic) in self.cubics.iter().enumerate() {
            if !theirs.contains(self.keys[segment].as_slice()) {
                let start = other.nearest(cubic.p0, search.last);
                let end = other.nearest(cubic.p3, start.segment);
                search.look(cubic.p0, segment, start);
                search.look(cubic.p3, segment, end);
                search.push(other, segment, *cubic, [start, end]);
            }
        }
        let mut left = MOST_PARTS + 32 * (self.cubics.len() + other.cubics.len());
        while let Some(part) = search.parts.pop() {
            let undecided = search.at_least <= aim.tolerance && aim.tolerance < part.at_most;
            let goal = if undecided { CLOSE_GOAL } else { aim.goal };
            let enough = (search.at_least * (1.0 + goal)).max(search.at_least + NOISE);
            if part.at_most <= enough || left == 0 {
                search.at_most = part.at_most;
                break;
            }
            left -= 1;
            let (a, b) = part.cubic.subdivide();
            let middle = other.nearest(a.p3, part.feet[0].segment);
            search.look(a.p3, part.segment, middle);
            search.push(other, part.segment, a, [part.feet[0], middle]);
            search.push(other, part.segment, b, [middle, part.feet[1]]);
        }
        // What rounding explains is no distance.
        let at_most = if search.at_most <= search.at_least + NOISE && search.at_least > NOISE {
            search.at_least
        } else {
            search.at_most.max(search.at_least)
        };
        Farthest {
            at_most,
            place: search.place,
        }
    }

    /// The nearest point, looked for on the segment of this number first.
    fn nearest(&self, p: Point, first: usize) -> Foot {
        let count = self.cubics.len();
        let first = first.min(count - 1);
        let mut best = self.foot(first, p);
        let mut stack = vec![1];
        while let Some(node) = stack.pop() {
            if away(&self.boxes[node], p) >= best.distance {
                continue;
            }
            if node >= count {
                let found = self.foot(node - count, p);
                if found.distance < best.distance {
                    best = found;
                }
                continue;
            }
            let (left, right) = (2 * node, 2 * node + 1);
            if away(&self.boxes[left], p) < away(&self.boxes[right], p) {
                stack.extend([right, left]);
            } else {
                stack.extend([left, right]);
            }
        }
        best
    }

    /// The nearest point of a segment: an end, or where (b - p)b' changes its sign.
    fn foot(&self, segment: usize, p: Point) -> Foot {
        let cubic = &self.cubics[segment];
        let at = |u: f64| Foot {
            segment,
            u,
            distance: cubic.eval(u).distance(p),
        };
        if let Some(Line { p0, p1 }) = self.lines[segment] {
            let u = (p - p0).dot(p1 - p0) / (p1 - p0).hypot2();
            // A line without length has its start alone.
            return at(if u > 0.0 { u.min(1.0) } else { 0.0 });
        }
        let points = [cubic.p0, cubic.p1, cubic.p2, cubic.p3].map(|q| q - p);
        let part = |of: fn(&Vec2) -> f64| {
            let value = Polynomial::new(&points.each_ref().map(of));
            value.times(&value.differences())
        };
        let slope = part(|v| v.x).minus(&part(|v| v.y).scaled(-1.0));
        let changes = slope.sign_changes();
        let nearer = |a: Foot, b: Foot| if b.distance < a.distance { b } else { a };
        changes
            .iter()
            .map(at)
            .fold(nearer(at(0.0), at(1.0)), nearer)
    }

    /// How far a part lies from here at most.
    fn bound(&self, part: &CubicBez, [start, end]: [Foot; 2]) -> f64 {
        let points = [part.p0, part.p1, part.p2, part.p3];
        let reach = |foot: &Foot, from: Point| {
            let far = points.map(|p| p.distance(from)).into_iter();
            foot.distance + far.fold(0.0, f64::max)
        };
        let reached = reach(&start, part.p0).min(reach(&end, part.p3));
        if start.segment != end.segment {
            return reached;
        }
        reached.min(along(part, &self.cubics[start.segment], [start.u, end.u]))
    }
}

/// What the branch and bound has found.
#[derive(Default)]
struct Search {
    parts: BinaryHeap<Part>,
    at_least: f64,
    at_most: f64,
    place: Option<(Point, usize)>,
    last: usize,
}

impl Search {
    fn look(&mut self, p: Point, segment: usize, foot: Foot) {
        self.last = foot.segment;
        if self.place.is_none() || foot.distance > self.at_least {
            self.at_least = foot.distance;
            self.place = Some((p, segment));
        }
    }

    fn push(&mut self, other: &Chain, segment: usize, cubic: CubicBez, feet: [Foot; 2]) {
        self.parts.push(Part {
            segment,
            cubic,
            feet,
            at_most: other.bound(&cubic, feet),
        });
    }
}

/// What says that two segments are the same, whichever way they run.
fn key(segment: &PathSeg) -> Vec<u64> {
    // -0 is 0.
    let bits = |p: &Point| [(p.x + 0.0).to_bits(), (p.y + 0.0).to_bits()];
    let points = control_points(segment);
    let forward: Vec<u64> = points.iter().flat_map(bits).collect();
    let backward: Vec<u64> = points.iter().rev().flat_map(bits).collect();
    forward.min(backward)
}

/// How far a point lies from a rectangle.
pub(crate) fn away(area: &Rect, p: Point) -> f64 {
    let x = (area.x0 - p.x).max(p.x - area.x1).max(0.0);
    let y = (area.y0 - p.y).max(p.y - area.y1).max(0.0);
    Vec2::new(x, y).hypot2().sqrt()
}

/// A segment as a cubic of the same parameter.
fn cubic(segment: &PathSeg) -> CubicBez {
    match segment {
        PathSeg::Line(Line { p0, p1 }) => {
            CubicBez::new(*p0, p0.lerp(*p1, 1.0 / 3.0), p0.lerp(*p1, 2.0 / 3.0), *p1)
        }
        _ => segment.to_cubic(),
    }
}

const fn line(segment: &PathSeg) -> Option<Line> {
    match segment {
        PathSeg::Line(line) => Some(*line),
        _ => None,
    }
}

impl Ord for Part {
    fn cmp(&self, other: &Self) -> Ordering {
        self.at_most.total_cmp(&other.at_most)
    }
}

impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Part {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diff::Track;
    use crate::path::contours;

    fn distance(old: &str, new: &str) -> f64 {
        let track = |data| Track::new(&contours(data).unwrap()[0], Affine::IDENTITY).unwrap();
        let (old, new) = (track(old), track(new));
        hausdorff([&old.segments, &new.segments], 0.0, 1e-4).at_most
    }

    #[test]
    fn distances_that_are_known() {
        for (old, new, expected) in [
            ("M0 0L10 0", "M0 1L10 1", 1.0),
            ("M0 0L10 0", "M3 4L13 4", 5.0),
            ("M0 0L10 0", "M10 0L0 0", 0.0),
            ("M0 0L10 0", "M0 0L20 0", 10.0),
            ("M0 0L10 0", "M5 0L5 3", 5.0),
            ("M0 0H10V10H0Z", "M10 10H0V0H10Z", 0.0),
            // The middle of the base, seen from the other two sides.
            ("M0 0L10 0", "M0 0L5 5L10 0", 5.0),
            ("M0 0L10 0", "M0 0Q5 10 10 0", 5.0),
        ] {
            let found = distance(old, new);
            assert!(
                (found - expected).abs() <= 1e-4 * expected,
                "{old} {new}: {found}"
            );
        }
        let circles = distance(
            "M50 0A50 50 0 0 1-50 0A50 50 0 0 1 50 0Z",
            "M51 0A51 51 0 0 1-51 0A51 51 0 0 1 51 0Z",
        );
        assert!((1.0..1.0001).contains(&circles), "{circles}");
    }

    #[test]
    fn a_curve_that_is_cut_elsewhere_is_the_same() {
        let whole = CubicBez::new((0.0, 0.0), (30.0, 80.0), (70.0, -40.0), (100.0, 10.0));
        let (a, b) = (whole.subsegment(0.0..0.3), whole.subsegment(0.3..1.0));
        let [whole, a, b] = [whole, a, b].map(PathSeg::Cubic);
        let found = hausdorff([&[whole], &[a, b]], 0.0, 1e-4).at_most;
        assert!(found < 1e-11, "{found}");
    }
}
