//! Words beside one another.

/// Heights nearest to the wished ones, ascending, that are at least `step` apart and within [`low`, `high`] where there is room:
/// neighbours that are too close become a block about the mean of their wishes, and blocks that touch become one.
pub(super) fn spread(wished: &[f64], step: f64, low: f64, high: f64) -> Vec<f64> {
    struct Stack {
        /// Of (wish - own offset in the block).
        sum: f64,
        count: usize,
    }
    let room = (high - low).max(1.0);
    let step = step.min(room / wished.len().max(1) as f64);
    let start = |block: &Stack| {
        let most = (high - step * (block.count as f64 - 1.0)).max(low);
        (block.sum / block.count as f64).clamp(low, most)
    };
    let mut blocks: Vec<Stack> = Vec::new();
    for &wish in wished {
        blocks.push(Stack {
            sum: wish,
            count: 1,
        });
        while let [.., before, last] = blocks.as_slice() {
            if start(before) + step * before.count as f64 <= start(last) {
                break;
            }
            let offset = step * before.count as f64 * last.count as f64;
            let (sum, count) = (last.sum - offset, last.count);
            blocks.pop();
            if let Some(before) = blocks.last_mut() {
                before.sum += sum;
                before.count += count;
            }
        }
    }
    blocks
        .iter()
        .flat_map(|block| (0..block.count).map(move |i| start(block) + step * i as f64))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_never_cover_one_another() {
        let heights = spread(
            &[10.0, 11.0, 12.0, 50.0, 51.0, 99.0, 99.0],
            10.0,
            0.0,
            100.0,
        );
        assert_eq!(heights.len(), 7);
        assert!(
            heights
                .windows(2)
                .all(|pair| pair[1] - pair[0] >= 10.0 - 1e-9),
            "{heights:?}"
        );
        assert!(
            heights.iter().all(|&y| (0.0..=100.0).contains(&y)),
            "{heights:?}"
        );
    }
}
