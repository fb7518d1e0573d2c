//! Buffers that one thread uses again and again.

use core::cell::Cell;

use crate::document::Options;
use crate::document::path::beziers::Beziers;
use crate::document::path::curve_text::Body;
use crate::document::path::known::ArcTables;

/// Buffers that outlive one path.
#[derive(Debug, Default)]
pub(in crate::document) struct Scratch {
    pub(in crate::document) body: Body,
    pub(in crate::document) beziers: Beziers,
    pub(in crate::document) memo: ArcTables,
}

thread_local! {
    static SCRATCH: Cell<Option<Box<Scratch>>> = const { Cell::new(None) };
}

/// Runs `work` with this thread's buffers.
pub(in crate::document) fn with_scratch<T>(
    options: &Options,
    work: impl FnOnce(&mut Scratch) -> T,
) -> T {
    let mut scratch = SCRATCH.take().unwrap_or_default();
    scratch.memo.serve(options);
    let result = work(&mut scratch);
    SCRATCH.set(Some(scratch));
    result
}
