//! Chen's Figure 8 round by round.

use super::Drawing;
use crate::method::Span;

/// The most segments whose lengths are listed.
const MOST_SEGMENTS: usize = 1000;

/// How far the angles of two segments may lie apart, as a part of themselves, to count as the same: they are differences of joints.
const SAME: f64 = 1e-9;

impl Drawing {
    /// The lengths of all segments round by round, the first the chords, where Formulation II drew a circle or an arc of one in at
    /// most a thousand segments. A length that settled before others stays as it is. They are those before rounding for output.
    #[must_use]
    pub fn lengths(&self) -> Option<Vec<Vec<f64>>> {
        let iteration = self.rule.iteration()?;
        let outline = self.outline.filter(|outline| outline.truth.is_circle())?;
        let radius = outline.truth.larger_radius();
        if self.curve.segments.len() > MOST_SEGMENTS {
            return None;
        }
        let mut columns: Vec<Vec<f64>> = Vec::new();
        let mut before = f64::NAN;
        for pair in self.angles.windows(2) {
            let degrees = (pair[1] - pair[0]).abs();
            match columns.last() {
                Some(same) if (degrees - before).abs() <= SAME * degrees => {
                    columns.push(same.clone());
                }
                _ => columns.push(iteration.lengths(&Span::from_degrees(degrees))),
            }
            before = degrees;
        }
        let rounds = columns.iter().map(Vec::len).max()?;
        let at = |column: &Vec<f64>, round: usize| {
            column.get(round).or(column.last()).copied().unwrap_or(0.0) * radius
        };
        let row = |round| columns.iter().map(|column| at(column, round)).collect();
        Some((0..rounds).map(row).collect())
    }
}
