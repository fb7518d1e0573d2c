//! Instructions that not every processor of a kind has.

/// Runs a computation by the vectors and fused products of the processor that runs it, where it has them (`simd`): the same bits in less time.
/// What is to be compiled so has to be inlined.
#[inline(always)]
pub(crate) fn by_the_best<T>(run: impl FnOnce() -> T) -> T {
    #[cfg(all(feature = "simd", target_arch = "x86_64"))]
    if let Some(level) = fearless_simd::Level::new().as_avx2() {
        return fearless_simd::Simd::vectorize(level, run);
    }
    run()
}
