//! Buffers that one thread uses again and again.

use core::cell::Cell;

use super::Options;
use super::curve_text::Body;
use super::memo::Memo;
use super::segments::Beziers;

/// Buffers that outlive one path.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    pub(super) body: Body,
    pub(super) beziers: Beziers,
    pub(super) memo: Memo,
}

thread_local! {
    static SCRATCH: Cell<Option<Box<Scratch>>> = const { Cell::new(None) };
}

/// Runs `work` with this thread's buffers.
pub(super) fn with_scratch<T>(options: &Options, work: impl FnOnce(&mut Scratch) -> T) -> T {
    let mut scratch = SCRATCH.take().unwrap_or_default();
    scratch.memo.serve(options);
    let result = work(&mut scratch);
    SCRATCH.set(Some(scratch));
    result
}
