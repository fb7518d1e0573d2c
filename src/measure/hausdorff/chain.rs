//! A chain of Béziers that knows its nearest points.
//!
//! Segments are cut into pieces that are small beside the drawing, in the order of a Z curve through their middles, under a tree of
//! boxes: what lies side by side is found together, however the chain runs.

use kurbo::{
    Affine, CubicBez, Line, ParamCurve as _, ParamCurveDeriv as _, PathSeg, Point, Rect, Vec2,
};

use super::{Effort, along::along};
use crate::curve::control_points;
use crate::numeric::bernstein::Polynomial;

/// How many pieces a segment is cut into at most.
const MOST_PIECES: f64 = 64.0;

/// How many pieces there are at most beside one for each segment.
const MOST_IN_ALL: f64 = 1_048_576.0;

/// What the nearest point of a cubic takes, or a bound, in boxes that are looked at.
pub(super) const STEPS_OF_A_CUBIC: u64 = 32;

/// How often the place is improved where a part passes a joint: any is good for a bound.
const JOINT_STEPS: usize = 4;

pub(super) struct CubicChain {
    pub(super) cubics: Vec<CubicBez>,
    /// What says that a segment is the same as another.
    pub(super) keys: Vec<Vec<u64>>,
    /// Those segments that are straight.
    lines: Vec<Option<Line>>,
    pieces: Vec<CubicPiece>,
    /// Node i holds the nodes 2i and 2i + 1, and piece k is node n + k.
    boxes: Vec<Rect>,
}

/// A part of a segment, between two parameters.
struct CubicPiece {
    segment: usize,
    from: f64,
    to: f64,
    cubic: CubicBez,
}

/// A near point of a chain.
#[derive(Clone, Copy)]
pub(super) struct ChainFoot {
    pub(super) piece: usize,
    pub(super) distance: f64,
    segment: usize,
    u: f64,
}

impl CubicChain {
    pub(super) fn new(segments: &[PathSeg], unit: f64) -> Self {
        let map = Affine::scale(1.0 / unit);
        let segments: Vec<PathSeg> = segments.iter().map(|&s| map * s).collect();
        let cubics: Vec<CubicBez> = segments.iter().map(cubic).collect();
        let pieces = pieces(&cubics);
        let count = pieces.len();
        let mut boxes = vec![Rect::ZERO; 2 * count];
        for (k, piece) in pieces.iter().enumerate() {
            boxes[count + k] = kurbo::Shape::bounding_box(&piece.cubic);
        }
        for i in (1..count).rev() {
            boxes[i] = boxes[2 * i].union(boxes[2 * i + 1]);
        }
        Self {
            cubics,
            keys: segments.iter().map(key).collect(),
            lines: segments.iter().map(line).collect(),
            pieces,
            boxes,
        }
    }

    /// The nearest point, looked for on the piece of this number first, or one that is near enough. Without steps
    /// it is any.
    pub(super) fn nearest(
        &self,
        p: Point,
        first: usize,
        enough: f64,
        steps: &mut Effort,
    ) -> ChainFoot {
        let count = self.pieces.len();
        let mut best = self.foot(first.min(count - 1), p);
        let mut stack = vec![1];
        while let Some(node) = stack.pop() {
            steps.take(1);
            if best.distance <= enough || steps.0 == 0 {
                break;
            }
            if away(&self.boxes[node], p) >= best.distance {
                continue;
            }
            if node >= count {
                steps.take(STEPS_OF_A_CUBIC);
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

    /// The nearest point of a piece: an end, or where (b - p)b' changes its sign. Of a line it is that of all of it.
    fn foot(&self, number: usize, p: Point) -> ChainFoot {
        let piece = &self.pieces[number];
        let at = |v: f64| ChainFoot {
            piece: number,
            segment: piece.segment,
            u: piece.from + v * (piece.to - piece.from),
            distance: piece.cubic.eval(v).distance(p),
        };
        if let Some(Line { p0, p1 }) = self.lines[piece.segment] {
            let u = (p - p0).dot(p1 - p0) / (p1 - p0).hypot2();
            // A line without length has its start alone.
            let u = if u > 0.0 { u.min(1.0) } else { 0.0 };
            let distance = self.cubics[piece.segment].eval(u).distance(p);
            return ChainFoot {
                distance,
                u,
                ..at(0.0)
            };
        }
        at(nearest_on(&piece.cubic, p).0)
    }

    /// How far a part lies from here at most, by points near its ends.
    pub(super) fn bound(&self, part: &CubicBez, [start, end]: [ChainFoot; 2]) -> f64 {
        let points = [part.p0, part.p1, part.p2, part.p3];
        let reach = |foot: &ChainFoot, from: Point| {
            let far = points.map(|p| p.distance(from)).into_iter();
            foot.distance + far.fold(0.0, f64::max)
        };
        let reached = reach(&start, part.p0).min(reach(&end, part.p3));
        if start.segment != end.segment {
            return reached.min(self.past_joint(part, [start, end]).unwrap_or(reached));
        }
        reached.min(along(part, &self.cubics[start.segment], [start.u, end.u]))
    }

    /// The same where one of the points lies on the segment after that of the other: the part is cut where the joint of both is near.
    fn past_joint(&self, part: &CubicBez, [start, end]: [ChainFoot; 2]) -> Option<f64> {
        let (i, j) = (start.segment, end.segment);
        let follows = |i: usize, j: usize| {
            j == (i + 1) % self.cubics.len() && self.cubics[i].p3 == self.cubics[j].p0
        };
        let ways = [(follows(i, j), 1.0), (follows(j, i), 0.0)].into_iter();
        let bounds = ways.filter(|(is_joined, _)| *is_joined).map(|(_, joint)| {
            let (here, there) = (&self.cubics[i], &self.cubics[j]);
            let at = passing(part, here, joint);
            let first = along(&part.subsegment(0.0..at), here, [start.u, joint]);
            let second = along(&part.subsegment(at..1.0), there, [1.0 - joint, end.u]);
            first.max(second)
        });
        bounds.reduce(f64::min)
    }
}

/// About where a part passes the end of a segment: any place is good for a bound.
fn passing(part: &CubicBez, segment: &CubicBez, end: f64) -> f64 {
    let (joint, slopes) = (segment.eval(end), part.deriv());
    let tangent = segment.deriv().eval(end).to_vec2();
    let step = |at: f64| {
        let off = (joint - part.eval(at)).dot(tangent);
        let next = at + off / slopes.eval(at).to_vec2().dot(tangent);
        // A segment without length has no direction.
        if next.is_nan() {
            0.5
        } else {
            next.clamp(0.0, 1.0)
        }
    };
    (0..JOINT_STEPS).fold(0.5, |at, _| step(at))
}

/// The pieces of all segments: of n that fill a square, each is about as large as a cell of a grid of n cells.
fn pieces(cubics: &[CubicBez]) -> Vec<CubicPiece> {
    let boxes: Vec<Rect> = cubics.iter().map(kurbo::Shape::bounding_box).collect();
    let all = boxes.iter().copied().reduce(|a, b| a.union(b));
    let all = all.unwrap_or(Rect::ZERO);
    let size = |area: &Rect| area.width().max(area.height());
    let n = cubics.len() as f64;
    let cell = size(&all) / n.sqrt();
    let mut pieces = Vec::with_capacity(cubics.len());
    for (segment, (&cubic, area)) in cubics.iter().zip(&boxes).enumerate() {
        // A drawing of one point has no size.
        let wanted = if cell > 0.0 {
            (size(area) / cell).ceil()
        } else {
            1.0
        };
        let count = wanted.min(1.0 + MOST_IN_ALL / n).clamp(1.0, MOST_PIECES) as usize;
        for k in 0..count {
            let [from, to] = [k, k + 1].map(|k| k as f64 / count as f64);
            let cubic = if count == 1 {
                cubic
            } else {
                cubic.subsegment(from..to)
            };
            pieces.push(CubicPiece {
                segment,
                from,
                to,
                cubic,
            });
        }
    }
    pieces.sort_by_cached_key(|piece| along_z(piece.cubic.eval(0.5), &all));
    pieces
}

/// The place of a point along a Z curve that fills a rectangle: the bits of its coordinates in turn.
fn along_z(p: Point, area: &Rect) -> u64 {
    let size = area.width().max(area.height()).max(f64::MIN_POSITIVE);
    let cells = |offset: f64| (offset / size * 65_535.0) as u64;
    let (x, y) = (cells(p.x - area.x0), cells(p.y - area.y0));
    let bit = |k: u32| (x >> k & 1) << (2 * k) | (y >> k & 1) << (2 * k + 1);
    (0..16).map(bit).sum()
}

/// What says that two segments are the same, whichever way they run.
pub(super) fn key(segment: &PathSeg) -> Vec<u64> {
    // -0 is 0.
    let bits = |p: &Point| [(p.x + 0.0).to_bits(), (p.y + 0.0).to_bits()];
    let points = control_points(segment);
    let forward: Vec<u64> = points.iter().flat_map(bits).collect();
    let backward: Vec<u64> = points.iter().rev().flat_map(bits).collect();
    forward.min(backward)
}

/// The parameter of the nearest point of a cubic, and how far it is: an end, or where (b - p)b' changes its sign.
pub(crate) fn nearest_on(cubic: &CubicBez, p: Point) -> (f64, f64) {
    let arms = [cubic.p0, cubic.p1, cubic.p2, cubic.p3].map(|q| q - p);
    let at = |v: f64| (v, cubic.eval(v).distance(p));
    let nearer = |a: (f64, f64), b: (f64, f64)| if b.1 < a.1 { b } else { a };
    let ends = nearer(at(0.0), at(1.0));
    let inner = distance_slope(&arms).sign_changes();
    inner.iter().map(at).fold(ends, nearer)
}

/// How the square of a cubic's distance from a place changes, b·b' but for a factor: its control points are given from there.
pub(crate) fn distance_slope(arms: &[Vec2; 4]) -> Polynomial {
    let part = |of: fn(&Vec2) -> f64| {
        let value = Polynomial::new(&arms.each_ref().map(of));
        value.times(&value.differences())
    };
    part(|v| v.x).minus(&part(|v| v.y).scaled(-1.0))
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

#[cfg(test)]
mod tests {
    use super::super::tests::tangle;
    use super::*;

    #[test]
    fn the_sign_of_0_makes_no_segment_another() {
        let key = |x: f64, y: f64| key(&PathSeg::Line(Line::new((x, y), (1.0, 2.0))));
        assert_eq!(key(-0.0, -0.0), key(0.0, 0.0));
    }

    #[test]
    fn the_nearest_point_of_a_line_is_exact() {
        for (x, y) in [(1.0, 0.0), (0.5, 0.75), (-0.25, 1.0)] {
            let chain = CubicChain::new(&[PathSeg::Line(Line::new((0.0, 0.0), (x, y)))], 1.0);
            for k in 0..=64 {
                let u = f64::from(k) / 64.0;
                let foot = chain.foot(0, Point::new(u * x - y, u * y + x));
                assert_eq!(foot.u, u);
            }
        }
    }

    #[test]
    fn the_nearest_piece_is_that_of_the_nearest_segment() {
        let segments = tangle(64, 3);
        let chain = CubicChain::new(&segments, 1.0);
        let alone: Vec<CubicChain> = segments
            .iter()
            .map(|&s| CubicChain::new(&[s], 1.0))
            .collect();
        for p in tangle(8, 4).iter().flat_map(control_points) {
            let steps = &mut Effort(1_000_000);
            let found = chain.nearest(p, 0, 0.0, steps).distance;
            let distances = alone.iter().map(|segment| segment.foot(0, p).distance);
            let nearest = distances.fold(f64::INFINITY, f64::min);
            assert!((found - nearest).abs() < 1e-12, "{found} {nearest}");
            assert!(chain.nearest(p, 0, 0.5, steps).distance <= 0.5_f64.max(nearest));
        }
    }
}
