//! Random numbers for tests, the same ones in every run.

/// 64 random bits, by `SplitMix64`.
pub(crate) fn bits(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A number from 0 to 1.
pub(crate) fn uniform(state: &mut u64) -> f64 {
    (bits(state) >> 11) as f64 / (1_u64 << 53) as f64
}

/// A number from -1 to 1.
pub(crate) fn signed(state: &mut u64) -> f64 {
    2.0 * uniform(state) - 1.0
}
