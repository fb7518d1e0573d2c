//! Axes: from values to positions, and where the round numbers are.

use crate::number::{Precision, decimals_of, text};
use crate::numeric::functions::{self, power};

/// Beyond this no axis goes, so that its steps stay finite; what is smaller than the other is 0.
const LARGEST: f64 = 1e300;
const SMALLEST: f64 = 1e-290;

/// A number on an axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    /// Empty for one that has a mark only.
    pub(super) label: String,
}

/// How an axis places values.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum ScaleKind {
    /// Round decimal steps.
    Linear,
    /// Steps that divide a turn.
    Degrees,
    /// Powers of ten.
    Log,
    /// These numbers, placed by their logarithms, each of them a tick.
    Given(Vec<f64>),
}

/// An axis with its range, wide enough for its data.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Axis {
    pub(super) kind: ScaleKind,
    low: f64,
    high: f64,
    /// Labels are in units of ten to this power.
    pub(super) exponent: i32,
    step: f64,
}

impl Axis {
    /// An axis for these values with about `count` ticks.
    pub(super) fn new(kind: ScaleKind, values: impl Iterator<Item = f64>, count: f64) -> Self {
        let (mut low, mut high) = values
            .filter(|v| v.abs() < LARGEST && (!kind.is_log() || *v >= SMALLEST))
            .map(|v| if v.abs() < SMALLEST { 0.0 } else { v })
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
                (a.min(v), b.max(v))
            });
        if low > high {
            (low, high) = if kind.is_log() {
                (0.1, 1.0)
            } else {
                (0.0, 1.0)
            };
        }
        let mut axis = Self {
            kind,
            low,
            high,
            exponent: 0,
            step: 1.0,
        };
        match axis.kind {
            ScaleKind::Linear => axis.fit_linear(count),
            ScaleKind::Degrees => axis.fit_degrees(count),
            ScaleKind::Log => {
                // A margin of a twentieth of a decade keeps marks off the frame.
                (axis.low, axis.high) = (low / 1.2, high * 1.2);
                axis.step = (libm::log10(high / low) / count).ceil().max(1.0);
            }
            ScaleKind::Given(_) => (axis.low, axis.high) = (low / 1.06, high * 1.06),
        }
        axis
    }

    fn fit_linear(&mut self, count: f64) {
        let size = self.low.abs().max(self.high.abs());
        // What differs by rounding only is one value.
        if self.high - self.low <= 1e-12 * size || size == 0.0 {
            let margin = if size == 0.0 { 1.0 } else { size * 1e-3 };
            (self.low, self.high) = (self.low - margin, self.high + margin);
        }
        let rough = (self.high - self.low) / count;
        let power = functions::power(10.0, libm::log10(rough).floor() as i32);
        self.step = [1.0, 2.0, 2.5, 5.0, 10.0]
            .into_iter()
            .map(|digit| digit * power)
            .find(|&step| step >= rough * 0.999_999)
            .unwrap_or(10.0 * power);
        self.low = (self.low / self.step).floor() * self.step;
        self.high = (self.high / self.step).ceil() * self.step;
        let largest = self.low.abs().max(self.high.abs());
        // The size of the data where it has one: the ends of the axis may be a digit longer.
        let exponent = libm::log10(if size > 0.0 { size } else { largest })
            .floor()
            .clamp(-300.0, 300.0);
        if !(-2.0..=4.0).contains(&exponent) {
            self.exponent = exponent as i32;
        }
    }

    fn fit_degrees(&mut self, count: f64) {
        const STEPS: [f64; 12] = [
            0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0,
        ];
        if self.high - self.low < 1e-9 {
            (self.low, self.high) = (self.low - 1.0, self.high + 1.0);
        }
        let rough = (self.high - self.low) / count;
        self.step = STEPS
            .into_iter()
            .find(|&step| step >= rough * 0.999_999)
            .unwrap_or((rough / 360.0).ceil() * 360.0);
    }

    /// From its low end to its high one.
    pub(super) fn length(&self) -> f64 {
        self.high - self.low
    }

    /// Where a value lies, from 0 at the low end to 1 at the high one.
    pub(super) fn position(&self, value: f64) -> f64 {
        if self.kind.is_log() {
            libm::log(value / self.low) / libm::log(self.high / self.low)
        } else {
            (value - self.low) / (self.high - self.low)
        }
    }

    /// Whether it has room for the value.
    pub(super) fn shows(&self, value: f64) -> bool {
        value.abs() < LARGEST && !(self.kind.is_log() && value < SMALLEST)
    }

    /// The ticks, ascending.
    pub(super) fn ticks(&self) -> Vec<Tick> {
        match &self.kind {
            ScaleKind::Linear | ScaleKind::Degrees => self.even_ticks(),
            ScaleKind::Log => self.decades(),
            ScaleKind::Given(values) => values
                .iter()
                .map(|&value| Tick {
                    value,
                    label: text(value),
                })
                .collect(),
        }
    }

    fn even_ticks(&self) -> Vec<Tick> {
        let unit = power(10.0, self.exponent);
        let first = (self.low / self.step - 1e-9).ceil() as i64;
        let last = (self.high / self.step + 1e-9).floor() as i64;
        // As many decimals as the step has, on every tick.
        let decimals = usize::from(decimals_of(Precision::Fixed(9).round(self.step / unit)));
        let sign = if self.kind == ScaleKind::Degrees {
            "°"
        } else {
            ""
        };
        (first..=last.min(first + 50))
            .map(|i| {
                let value = i as f64 * self.step;
                let size = format!("{:.decimals$}{sign}", (value / unit).abs());
                let label = if i < 0 { format!("−{size}") } else { size };
                Tick { value, label }
            })
            .collect()
    }

    /// Each power of ten, with marks at its multiples where there is room.
    fn decades(&self) -> Vec<Tick> {
        let (first, last) = (
            libm::log10(self.low).floor() as i32,
            libm::log10(self.high).ceil() as i32,
        );
        let every = self.step as i32;
        let mut ticks = Vec::new();
        for decade in first..=last {
            let power = functions::power(10.0, decade);
            let label = if decade.rem_euclid(every) == 0 {
                power_of_ten(decade)
            } else {
                String::new()
            };
            ticks.push(Tick {
                value: power,
                label,
            });
            if every == 1 {
                ticks.extend((2..10).map(|k| Tick {
                    value: f64::from(k) * power,
                    label: String::new(),
                }));
            }
        }
        ticks.retain(|tick| tick.value >= self.low && tick.value <= self.high);
        ticks
    }
}

impl ScaleKind {
    const fn is_log(&self) -> bool {
        matches!(self, Self::Log | Self::Given(_))
    }
}

/// 10⁻⁴ in raised digits.
pub(super) fn power_of_ten(exponent: i32) -> String {
    match exponent {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => format!("10{}", raised(exponent)),
    }
}

fn raised(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    text(f64::from(exponent))
        .bytes()
        .map(|byte| {
            if byte == b'-' {
                '⁻'
            } else {
                DIGITS[usize::from(byte - b'0')]
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<String> {
        axis.ticks()
            .into_iter()
            .map(|tick| tick.label)
            .filter(|l| !l.is_empty())
            .collect()
    }

    #[test]
    fn ticks_are_round() {
        let axis = Axis::new(ScaleKind::Linear, [-1.9e-4, 2.7e-4].into_iter(), 6.0);
        assert_eq!(
            (axis.exponent, labels(&axis)),
            (
                -4,
                ["−2", "−1", "0", "1", "2", "3"].map(String::from).to_vec()
            )
        );
        let turn = Axis::new(ScaleKind::Degrees, [0.0, 360.0].into_iter(), 9.0);
        assert_eq!(labels(&turn)[..3], ["0°", "45°", "90°"]);
        let log = Axis::new(ScaleKind::Log, [3e-6, 0.02].into_iter(), 8.0);
        assert_eq!(labels(&log), ["10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²"]);
    }

    #[test]
    fn every_value_lies_on_its_axis() {
        for values in [
            vec![],
            vec![1.0],
            vec![0.0],
            vec![5e-324],
            vec![0.0, 1e-310],
            vec![-1.7e308, 1.7e308],
            vec![-1e299, 1e299],
            vec![1.0, 1.0 + 1e-16],
            vec![-3e200, 5e200],
            vec![f64::NAN],
        ] {
            for kind in [ScaleKind::Linear, ScaleKind::Degrees, ScaleKind::Log] {
                let axis = Axis::new(kind, values.iter().copied(), 6.0);
                for &value in values.iter().filter(|&&v| axis.shows(v)) {
                    let at = axis.position(value);
                    assert!((0.0..=1.0).contains(&at), "{value}: {at}");
                }
                let ticks = axis.ticks();
                assert!(ticks.len() < 400);
                let words = ["NaN", "inf"];
                assert!(
                    ticks
                        .iter()
                        .all(|t| words.iter().all(|w| !t.label.contains(w)))
                );
            }
        }
    }
}
