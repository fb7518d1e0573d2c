//! Chains that come back to their start in equal parts: a circle of cubics is nearest to arcs again and again, and not where a search ends that
//! goes as far as the tolerance lets it.

use kurbo::CubicBez;

use super::chain::Chain;
use super::fit::PieceSearch;
use super::form::Fitted;

/// The most parts that are tried.
const MOST_PARTS: usize = 16;

impl PieceSearch {
    /// The fewest equal parts of a closed chain that are near enough, where they are fewer than so many pieces.
    pub(super) fn even(&mut self, cubics: &[CubicBez], count: usize) -> Option<Vec<Fitted>> {
        let chain = Chain::new(cubics);
        if chain.reach() >= chain.end() {
            return None;
        }
        (2..count.min(MOST_PARTS + 1)).find_map(|parts| {
            let at = |i: usize| chain.end() * i as f64 / parts as f64;
            let fit = |i| self.attempt(&chain, at(i), at(i + 1)).ok();
            (0..parts).map(fit).collect()
        })
    }
}
