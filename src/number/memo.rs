//! The texts of numbers that come again: an answer repeats most of its coordinates.

use super::push_shortest;

/// How many texts are kept: more than a line of an ellipse has.
const SLOTS: usize = 256;

/// The longest text that is kept.
const LONGEST: usize = 24;

/// A number without its sign, by its bits, and its text.
#[derive(Debug, Clone, Copy)]
struct Slot {
    bits: u64,
    length: usize,
    text: [u8; LONGEST],
}

/// The last numbers that were printed in full, with their texts.
#[derive(Debug)]
pub(crate) struct Memo {
    slots: [Slot; SLOTS],
}

impl Default for Memo {
    fn default() -> Self {
        // Zero, whose bits are 0.
        let zero = Slot {
            bits: 0,
            length: 1,
            text: [b'0'; LONGEST],
        };
        Self {
            slots: [zero; SLOTS],
        }
    }
}

impl Memo {
    /// Appends the text of [`push_shortest`].
    #[inline]
    pub(crate) fn push(&mut self, out: &mut Vec<u8>, x: f64) {
        // What mirrors another number has its digits.
        if x < 0.0 {
            out.push(b'-');
        }
        let bits = x.abs().to_bits();
        // The upper bits of a product with the golden ratio (Knuth).
        let hash = bits.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 56;
        let slot = &mut self.slots[hash as usize % SLOTS];
        if slot.bits == bits {
            let end = out.len() + slot.length;
            out.extend_from_slice(&slot.text);
            out.truncate(end);
        } else {
            slot.fill(out, x.abs());
        }
    }
}

impl Slot {
    fn fill(&mut self, out: &mut Vec<u8>, x: f64) {
        let start = out.len();
        push_shortest(out, x);
        let length = out.len() - start;
        if length <= LONGEST {
            // So many bytes as a slot has are copied by a few instructions, any number of them by a call.
            out.extend_from_slice(&[b'0'; LONGEST]);
            self.text.copy_from_slice(&out[start..start + LONGEST]);
            out.truncate(start + length);
            (self.bits, self.length) = (x.to_bits(), length);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_come_again_have_the_same_text() {
        let mut memo = Memo::default();
        for i in 0..3000 {
            let sizes = [1.0, -0.1, 1e-30, -1e22];
            let x = f64::from(i % 97) / 7.0 * sizes[i as usize % 4];
            for x in [x, -x] {
                let (mut own, mut text) = (b"x".to_vec(), b"x".to_vec());
                memo.push(&mut own, x);
                push_shortest(&mut text, x);
                assert_eq!(own, text);
            }
        }
    }
}
