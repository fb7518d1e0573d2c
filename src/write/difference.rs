//! What two drawings differ by, as JSON.

use serde::Serialize;

use crate::diff::{Difference, Pair, Side};

/// What two drawings differ by.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DifferenceDocument {
    /// The version of this form.
    pub version: u32,
    /// The largest distance that was allowed, in user units.
    pub tolerance: f64,
    /// Whether every subpath has its like within it.
    pub within: bool,
    /// A bound of the largest distance of the subpaths that belong together.
    pub distance: f64,
    /// The subpaths, those that belong together first, then what one of the drawings lacks.
    pub subpaths: Vec<PairDocument>,
}

/// Two subpaths that belong together, or one that has no like.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PairDocument {
    /// The number of the subpath in the old drawing, from 1; null where that lacks it.
    pub old: Option<usize>,
    /// Its number in the new drawing, from 1; null where that lacks it.
    pub new: Option<usize>,
    /// Whether they are within the tolerance.
    pub within: bool,
    /// A bound of their distance both ways (Hausdorff), in user units.
    pub distance: Option<f64>,
    /// Where they lie farthest apart; null for equal segments.
    pub farthest: Option<PlaceDocument>,
    /// Whether one is closed and the other is not.
    pub closed_differently: bool,
}

/// Where two subpaths lie farthest apart.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PlaceDocument {
    /// The point that is farthest from the other subpath.
    pub point: [f64; 2],
    /// The drawing that it belongs to: `old` or `new`.
    pub drawing: &'static str,
    /// The segment that it lies on, from 1.
    pub segment: usize,
}

impl From<&Difference> for DifferenceDocument {
    fn from(difference: &Difference) -> Self {
        let pairs = difference.pairs.iter();
        let pairs = pairs.map(|pair| pair_document(pair, difference.allows(pair)));
        let lone = |old, new| PairDocument {
            old,
            new,
            within: false,
            distance: None,
            farthest: None,
            closed_differently: false,
        };
        let only_old = difference.only_old.iter().map(|i| lone(Some(i + 1), None));
        let only_new = difference.only_new.iter().map(|i| lone(None, Some(i + 1)));
        Self {
            version: 1,
            tolerance: difference.tolerance,
            within: difference.is_within(),
            distance: difference.distance(),
            subpaths: pairs.chain(only_old).chain(only_new).collect(),
        }
    }
}

fn pair_document(pair: &Pair, within: bool) -> PairDocument {
    PairDocument {
        old: Some(pair.old + 1),
        new: Some(pair.new + 1),
        within,
        distance: Some(pair.distance.at_most),
        farthest: pair.distance.place.map(|place| PlaceDocument {
            point: [place.point.x, place.point.y],
            drawing: side_name(place.side),
            segment: place.segment + 1,
        }),
        closed_differently: pair.closed_differently,
    }
}

const fn side_name(side: Side) -> &'static str {
    match side {
        Side::Old => "old",
        Side::New => "new",
    }
}
