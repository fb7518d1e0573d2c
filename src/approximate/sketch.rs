//! A curve before rounding.

use kurbo::Point;

use crate::curve::Curve;
use crate::joints::Joints;
use crate::number::Precision;
use crate::radial_error::RadialError;

/// A curve before rounding, and how it is to be rounded.
pub(crate) struct Sketch {
    pub(super) joints: Option<Joints>,
    pub(crate) curve: Curve,
    /// Points that are not rounded.
    pub(crate) kept: Option<[Point; 2]>,
    pub(crate) precision: Precision,
    /// The peak error before rounding, where a formula tells it.
    pub(super) peak: Option<f64>,
    /// The error of the curve as it is written, where it was measured.
    pub(super) measured: Option<RadialError>,
    /// The curve as it is written, where it is at hand.
    pub(super) written: Option<Curve>,
}

impl Sketch {
    /// A curve of which nothing else is known.
    pub(super) const fn plain(curve: Curve, precision: Precision) -> Self {
        Self {
            joints: None,
            curve,
            kept: None,
            precision,
            peak: None,
            measured: None,
            written: None,
        }
    }

    /// The curve as it is written.
    pub(crate) fn rounded(&self) -> Curve {
        if let Some(curve) = &self.written {
            return curve.clone();
        }
        let kept = self.kept.as_ref().map_or(&[][..], |ends| &ends[..]);
        self.curve.rounded(self.precision, kept)
    }
}
