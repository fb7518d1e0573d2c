//! What was worked out before: files repeat a few arcs thousands of times.
//!
//! Each thread keeps a bounded table for arcs, by their text, and one for spans, by their angle. Both hold what a computation
//! gives again, so that nothing depends on what was converted before; they are emptied when the options change.

use crate::document::Options;
use crate::document::path::curve_text::{CurveArguments, CurveFacts};
use crate::method::{Piece, Rule, Span};

/// The places of each table, a power of two; it is emptied when three quarters of them are taken.
const PLACES: usize = 1 << 15;
const MOST_ENTRIES: usize = PLACES / 4 * 3;
/// The angles that are kept.
const SPANS: usize = 4096;
/// All texts together take no more than this.
const MOST_BYTES: usize = 1 << 21;

/// A relative arc that was written before.
#[derive(Debug, Clone, Copy)]
struct Written {
    /// Where the arc's text begins among the texts, the curve's, and where that ends.
    key: u32,
    text: u32,
    end: u32,
    facts: CurveFacts,
}

/// The tables.
#[derive(Debug, Default)]
pub(in crate::document) struct ArcTables {
    made_for: Option<Options>,
    /// One more than the index of an arc, or 0.
    places: Vec<u32>,
    arcs: Vec<Written>,
    texts: Vec<u8>,
    spans: Vec<Option<(f64, Piece, f64)>>,
}

impl ArcTables {
    pub(in crate::document) fn serve(&mut self, options: &Options) {
        if self.made_for.as_ref() != Some(options) {
            self.forget_arcs();
            self.spans.clear();
            self.made_for = Some(options.clone());
        }
    }

    fn forget_arcs(&mut self) {
        self.places.fill(0);
        self.arcs.clear();
        self.texts.clear();
    }

    /// Where the arc or the shape of this spelling is kept, if it is known.
    pub(in crate::document) fn find(&self, key: &[u8]) -> Option<usize> {
        self.look_up(key).ok()
    }

    /// The index of the arc with this key, or the free place where it would be.
    fn look_up(&self, key: &[u8]) -> Result<usize, usize> {
        let mut place = slot(key);
        loop {
            let index = self.places.get(place).map_or(0, |index| *index as usize);
            let Some(written) = index.checked_sub(1).and_then(|index| self.arcs.get(index)) else {
                return Err(place);
            };
            if self.texts.get(written.key as usize..written.text as usize) == Some(key) {
                return Ok(index - 1);
            }
            place = (place + 1) % PLACES;
        }
    }

    /// What the arc or the shape that was found became.
    pub(in crate::document) fn curve(&self, index: usize) -> CurveArguments<'_> {
        let Some(written) = self.arcs.get(index) else {
            return CurveArguments::default();
        };
        CurveArguments {
            text: self
                .texts
                .get(written.text as usize..written.end as usize)
                .unwrap_or_default(),
            facts: written.facts,
        }
    }

    /// Keeps an arc or a shape.
    pub(in crate::document) fn keep(&mut self, key: &[u8], curve: &CurveArguments<'_>) {
        if key.len() + curve.text.len() > MOST_BYTES / 64 {
            return;
        }
        if self.arcs.len() == MOST_ENTRIES
            || self.texts.len() + key.len() + curve.text.len() > MOST_BYTES
        {
            self.forget_arcs();
        }
        if self.places.is_empty() {
            self.places.resize(PLACES, 0);
        }
        let Err(place) = self.look_up(key) else {
            return;
        };
        let start = self.texts.len() as u32;
        self.texts.extend_from_slice(key);
        let text = self.texts.len() as u32;
        self.texts.extend_from_slice(curve.text);
        let end = self.texts.len() as u32;
        self.arcs.push(Written {
            key: start,
            text,
            end,
            facts: curve.facts,
        });
        if let Some(entry) = self.places.get_mut(place) {
            *entry = self.arcs.len() as u32;
        }
    }

    /// The piece of that many degrees by a rule, and its peak radial error on the unit circle.
    pub(in crate::document) fn piece(
        &mut self,
        rule: Rule,
        degrees: f64,
    ) -> crate::Result<(Piece, f64)> {
        let slot = slot(&degrees.to_bits().to_le_bytes()) % SPANS;
        if let Some(Some((known, piece, error))) = self.spans.get(slot)
            && *known == degrees
        {
            return Ok((*piece, *error));
        }
        let span = Span::from_degrees(degrees);
        let (piece, error) = (rule.piece(&span)?, rule.radial_error(&span)?.peak());
        if self.spans.is_empty() {
            self.spans.resize(SPANS, None);
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
    let mix = |hash: u64, word: u64| (hash.rotate_left(23) ^ word).wrapping_mul(FACTOR);
    let mut hash = key.len() as u64;
    if let Some(last) = key.last_chunk() {
        // The last word may share bytes with the one before.
        let (words, _) = key.as_chunks();
        for word in words {
            hash = mix(hash, u64::from_le_bytes(*word));
        }
        hash = mix(hash, u64::from_le_bytes(*last));
    } else {
        hash = key
            .iter()
            .fold(hash, |hash, byte| mix(hash, u64::from(*byte)));
    }
    (hash >> 40) as usize % PLACES
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_kept_is_found_and_no_more_is_kept_than_fits() {
        let mut memo = ArcTables::default();
        let key = |i: usize| format!("{i} 1 0 0 1 {i} 1").into_bytes();
        let text = |i: usize| format!("c{i}").into_bytes();
        for i in 0..3 * MOST_ENTRIES {
            let text = text(i);
            memo.keep(
                &key(i),
                &CurveArguments {
                    text: &text,
                    facts: CurveFacts {
                        segments: i,
                        ..CurveFacts::default()
                    },
                },
            );
            assert!(memo.arcs.len() <= MOST_ENTRIES && memo.texts.len() <= MOST_BYTES);
            // This one, and one before it unless all were forgotten between.
            let index = memo.find(&key(i)).unwrap();
            assert_eq!(
                (memo.curve(index).text, memo.curve(index).facts.segments),
                (&text[..], i)
            );
            let before = i / 2 + MOST_ENTRIES / 2;
            assert_eq!(
                memo.find(&key(before)).is_some(),
                before <= i && i / MOST_ENTRIES == before / MOST_ENTRIES
            );
        }
    }

    #[test]
    fn long_texts_are_not_kept_for_ever() {
        let mut memo = ArcTables::default();
        let long = vec![b'1'; MOST_BYTES / 64 - 1];
        for i in 0..200_u8 {
            memo.keep(
                &[i],
                &CurveArguments {
                    text: &long,
                    ..CurveArguments::default()
                },
            );
            assert!(memo.find(&[i]).is_some() && memo.texts.len() <= MOST_BYTES);
            assert!((usize::from(i) % 64 == 0) == (memo.arcs.len() == 1));
        }
        let longer = vec![b'1'; MOST_BYTES / 64];
        memo.keep(
            b"no",
            &CurveArguments {
                text: &longer,
                ..CurveArguments::default()
            },
        );
        assert_eq!(memo.find(b"no"), None);
    }
}
