//! Curves as chains of control points: those that JSON states, and those that a reader of another format finds.

use kurbo::{Point, QuadBez};
use serde_json::Value;

use crate::judges::program::drawn_text;

/// A chain of segments by their control points.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Chain {
    pub(crate) segments: Vec<Vec<[f64; 2]>>,
    pub(crate) closed: bool,
}

impl Chain {
    pub(crate) fn new(start: [f64; 2]) -> Self {
        Self {
            segments: vec![vec![start]],
            closed: false,
        }
    }

    /// Where the next segment starts.
    fn end(&self) -> [f64; 2] {
        *self.segments.last().unwrap().last().unwrap()
    }

    pub(crate) fn push(&mut self, points: &[[f64; 2]]) {
        let segment = [&[self.end()], points].concat();
        self.segments.push(segment);
    }

    /// Without the point that the first segment starts from.
    pub(crate) fn finished(mut self, closed: bool) -> Self {
        self.segments.remove(0);
        if closed {
            assert_eq!(
                self.segments[0][0],
                self.end(),
                "a closed chain ends where it starts"
            );
        }
        self.closed = closed;
        self
    }

    /// Whether both have the same points, but for what the last bits of a third are.
    pub(crate) fn is_near(&self, other: &Self) -> bool {
        let numbers = |chain: &Self| -> Vec<Vec<f64>> {
            let segments = chain.segments.iter();
            segments.map(|points| points.concat()).collect()
        };
        let (ours, theirs) = (numbers(self), numbers(other));
        let lengths = |all: &[Vec<f64>]| all.iter().map(Vec::len).collect::<Vec<_>>();
        let pairs = ours.iter().flatten().zip(theirs.iter().flatten());
        self.closed == other.closed
            && lengths(&ours) == lengths(&theirs)
            && pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max) < 1e-14
    }

    /// With quadratics raised to cubics.
    pub(crate) fn raised(mut self) -> Self {
        for segment in &mut self.segments {
            if segment.len() == 3 {
                let [a, b, c] = [0, 1, 2].map(|i| Point::new(segment[i][0], segment[i][1]));
                let cubic = QuadBez::new(a, b, c).raise();
                *segment = [cubic.p0, cubic.p1, cubic.p2, cubic.p3]
                    .map(|p| [p.x, p.y])
                    .to_vec();
            }
        }
        self
    }
}

fn point(value: &Value) -> [f64; 2] {
    [value[0].as_f64().unwrap(), value[1].as_f64().unwrap()]
}

/// What JSON states, one chain.
pub(crate) fn stated(arguments: &str) -> Chain {
    let json: Value = serde_json::from_str(&drawn_text(&format!("{arguments} -f json"))).unwrap();
    let segments = json["segments"].as_array().unwrap();
    let points = |segment: &Value| {
        segment["points"]
            .as_array()
            .unwrap()
            .iter()
            .map(point)
            .collect()
    };
    Chain {
        segments: segments.iter().map(points).collect(),
        closed: json["closed"].as_bool().unwrap(),
    }
}

pub(crate) const SHAPES: [&str; 7] = [
    "circle 50 -p 3",
    "circle 5 -m quadratic-minimax -n 6 -p 4",
    "ellipse 30 20 --rotation 15 --center 100,-50 -n 5 -p 3",
    "arc 10 --start 20 --sweep -250 -t 1e-4 -p 7",
    "arc --from 0,0 --to 10,5 --bulge 0 -p 3",
    "circle 1e-3 --center -0.5,0.25 -p 9",
    "spline --points 0,0_1,2_3,1_4,4 -p 5",
];

pub(crate) fn curves_of_a_sphere() -> usize {
    drawn_text("sphere 5").matches('M').count()
}
