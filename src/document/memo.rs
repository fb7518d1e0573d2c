//! What was worked out before: files repeat a few arcs thousands of times.
//!
//! Each thread keeps a bounded table for arcs, by their text, and one for spans, by their angle. Both hold what a computation
//! gives again, so that nothing depends on what was converted before; they are emptied when the options change.

use core::cell::RefCell;

use super::Options;
use super::arcs::Scratch;
use super::curve_text::Body;
use super::number::After;
use crate::joints::Cut;
use crate::method::{Piece, Rule, Span};

/// The number of entries of each table.
const ENTRIES: usize = 8192;
/// Longer texts are not kept.
const LONGEST_KEY: usize = 64;

/// A relative arc that was written before.
#[derive(Debug, Clone)]
pub(super) struct Written {
    key: Box<[u8]>,
    /// The arguments of the curve commands.
    pub(super) text: Box<[u8]>,
    pub(super) after: After,
    pub(super) quadratic: bool,
    pub(super) segments: usize,
}

/// The tables.
#[derive(Debug, Default)]
pub(super) struct Memo {
    made_for: Option<(Rule, Cut, Option<u8>)>,
    arcs: Vec<Option<Written>>,
    spans: Vec<Option<(f64, Piece, f64)>>,
}

thread_local! {
    static SCRATCH: RefCell<Scratch> = RefCell::default();
}

/// Runs `work` with this thread's buffers.
pub(super) fn with_scratch<T>(options: &Options, work: impl FnOnce(&mut Scratch) -> T) -> T {
    let mut scratch = SCRATCH.take();
    scratch.memo.serve(options);
    let result = work(&mut scratch);
    SCRATCH.set(scratch);
    result
}

impl Memo {
    fn serve(&mut self, options: &Options) {
        let same = self
            .made_for
            .as_ref()
            .is_some_and(|(rule, cut, precision)| {
                *rule == options.rule && *cut == options.cut && *precision == options.precision
            });
        if !same {
            self.arcs.clear();
            self.spans.clear();
            self.made_for = Some((options.rule, options.cut.clone(), options.precision));
        }
    }

    /// The arc whose arguments are spelled like that.
    pub(super) fn arc(&self, key: &[u8]) -> Option<&Written> {
        self.arcs
            .get(slot(key))?
            .as_ref()
            .filter(|written| *written.key == *key)
    }

    /// Keeps an arc.
    pub(super) fn keep_arc(&mut self, key: &[u8], body: &Body) {
        let Body {
            text,
            after,
            quadratic,
            segments,
        } = body;
        if key.len() > LONGEST_KEY || text.len() > 4 * LONGEST_KEY {
            return;
        }
        if self.arcs.is_empty() {
            self.arcs.resize(ENTRIES, None);
        }
        if let Some(entry) = self.arcs.get_mut(slot(key)) {
            *entry = Some(Written {
                key: key.into(),
                text: text[..].into(),
                after: *after,
                quadratic: *quadratic,
                segments: *segments,
            });
        }
    }

    /// The piece of that many degrees by a rule, and its peak radial error on the unit circle.
    pub(super) fn piece(&mut self, rule: Rule, degrees: f64) -> crate::Result<(Piece, f64)> {
        let slot = slot(&degrees.to_bits().to_le_bytes());
        if let Some(Some((known, piece, error))) = self.spans.get(slot)
            && *known == degrees
        {
            return Ok((*piece, *error));
        }
        let span = Span::from_degrees(degrees);
        let (piece, error) = (rule.piece(&span)?, rule.radial_error(&span)?.peak());
        if self.spans.is_empty() {
            self.spans.resize(ENTRIES, None);
        }
        if let Some(entry) = self.spans.get_mut(slot) {
            *entry = Some((degrees, piece, error));
        }
        Ok((piece, error))
    }
}

/// The place of a key in a table.
fn slot(key: &[u8]) -> usize {
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut hash = key.len() as u64;
    let mut chunks = key.chunks_exact(8);
    for chunk in &mut chunks {
        let word = chunk.try_into().map_or(0, u64::from_le_bytes);
        hash = (hash.rotate_left(23) ^ word).wrapping_mul(FACTOR);
    }
    for byte in chunks.remainder() {
        hash = (hash.rotate_left(9) ^ u64::from(*byte)).wrapping_mul(FACTOR);
    }
    (hash >> 40) as usize % ENTRIES
}
