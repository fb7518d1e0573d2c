//! Decimals that are too coarse for a tolerance, known before a search that would find nothing.

use crate::approximate::Request;
use crate::method::Ends;
use crate::number::Precision;
use crate::numeric::functions::power;

/// The logarithm of a chance that nobody meets.
const HOPELESS: f64 = -20.0;

impl Request<'_> {
    /// Whether decimals are so much coarser than a tolerance T that not even luck brings all joints within it. Of the places in a square of
    /// side 1, in which a point may be rounded from, less than 2 √2 T lie within T of a line, and the joints in a quarter of an ellipse, or an
    /// eighth of a circle, have nothing to do with one another, but for those at its ends.
    pub(super) fn is_hopeless(&self, tolerance: f64) -> bool {
        let method = self.options.rule.method();
        let (Some(Precision::Fixed(decimals)), Some(method)) = (self.options.precision, method)
        else {
            return false;
        };
        let chance = 2.0 * 2_f64.sqrt() * tolerance * power(10.0, i32::from(decimals));
        let card = method.card();
        // Numbers for some angles only are refused by those.
        if chance >= 1.0 || card.ends != Ends::OnCircle || card.law.is_none() {
            return false;
        }
        let truth = &self.outline.truth;
        let alike = if truth.is_circle() { 8.0 } else { 4.0 };
        let joints = self.least_count(tolerance) as f64 / alike - 2.0;
        joints * libm::log(chance) < HOPELESS
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Angle, Cut, Ellipse, Method, Options, Shape, Tolerance};

    #[test]
    fn decimals_are_hopeless_where_joints_ask_for_luck_time_and_again() {
        let flat = Ellipse::new((0.0, 0.0), (100.0, 30.0), Angle::ZERO).unwrap();
        let flat = Shape::Ellipse(flat);
        for (method, decimals, tolerance, is_hopeless) in [
            (Method::Chen2, 8, 3.3e-10, true),
            (Method::Minimax, 10, 1e-12, true),
            // Two of three joints are within by luck.
            (Method::Minimax, 9, 3e-10, false),
            (Method::Chen2, 9, 3e-10, true),
            (Method::Chen2, 9, 4e-10, false),
            (Method::Minimax, 1, 0.02, false),
            // It serves quarters only, and says so.
            (Method::LancasterDrawellipse, 10, 1e-12, false),
            // Joints that are off the circle may be anywhere.
            (Method::MinimaxFree, 8, 3.3e-10, false),
        ] {
            let options = Options {
                rule: method.into(),
                cut: Cut::Tolerance(Tolerance::Absolute(tolerance)),
                precision: Some(Precision::Fixed(decimals)),
                ..Options::default()
            };
            let request = Request::new(&flat, &options).unwrap().unwrap();
            assert_eq!(request.is_hopeless(tolerance), is_hopeless, "{method:?}");
            if is_hopeless {
                let refusal = request
                    .fewest(Tolerance::Absolute(tolerance))
                    .err()
                    .unwrap();
                assert!(refusal.to_string().contains("rounding to"), "{refusal}");
            }
        }
    }
}
