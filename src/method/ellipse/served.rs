//! Which ellipses and segments `minimax-ellipse` serves, and what it says of others.

use crate::error::{Error, MethodError, Remedy};
use crate::method::Method;

/// The flattest ellipses, by their ratio, and the longest segments on those, in degrees: what was tried, and found in 3 microseconds.
const SERVED: [(f64, f64); 2] = [(0.05, 170.0), (0.02, 100.0)];

/// The longest segment that is served on an ellipse of this ratio, in degrees; `None` on one flatter than [`SERVED`].
pub(crate) fn largest_angle(short: f64) -> Option<f64> {
    let served = SERVED.into_iter().find(|&(ratio, _)| short >= ratio);
    served.map(|(_, angle)| angle)
}

/// Why there are no handles for a segment of this many degrees.
pub(super) fn refusal(method: Method, short: f64, size: f64) -> Error {
    let (why, remedy) = match largest_angle(short) {
        Some(largest) if size > largest => (
            MethodError::LargestOnEllipse {
                degrees: size,
                largest,
            },
            Remedy::MoreSegments {
                degrees: Some(largest),
                methods: &["minimax"],
            },
        ),
        Some(_) => (
            MethodError::NoHandles(size),
            Remedy::EveryEllipse("minimax"),
        ),
        None => (MethodError::TooFlat, Remedy::EveryEllipse("minimax")),
    };
    method.refuse(why, remedy)
}
