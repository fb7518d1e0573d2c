//! Path data: arcs become Béziers in place, and on the way back Béziers arcs.

pub(super) mod arcs;
pub(super) mod bezier;
pub(super) mod beziers;
pub(super) mod collapse;
pub(super) mod curve_text;
mod known;
mod position;
pub(super) mod run_text;
pub(super) mod runs;
pub(super) mod scratch;
