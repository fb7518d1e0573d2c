//! Numbers for people: prose, tables, round figures.

use super::push_fixed;

/// Where prose writes more decimals, it writes an exponent.
const MOST_DECIMALS: f64 = 60.0;

/// The text of a number for prose: rounded to this many significant digits, though never before the point, so that a whole number keeps
/// all of its digits; without zeros at the end of its decimals. With an exponent where it would take more than 60 decimals. A number that
/// is not finite gives `0`.
#[must_use]
pub fn significant(x: f64, digits: u8) -> String {
    let magnitude = if x == 0.0 || !x.is_finite() {
        0.0
    } else {
        libm::log10(x.abs()).floor()
    };
    let decimals = (f64::from(digits) - 1.0 - magnitude).max(0.0);
    if decimals > MOST_DECIMALS {
        let text = format!("{x:.*e}", usize::from(digits.max(1)) - 1);
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let mantissa = match mantissa.split_once('.') {
            Some(_) => mantissa.trim_end_matches('0').trim_end_matches('.'),
            None => mantissa,
        };
        return format!("{mantissa}e{exponent}");
    }
    let mut out = Vec::new();
    push_fixed(&mut out, x, decimals as u8);
    String::from_utf8_lossy(&out).into_owned()
}

/// So many things of a kind, whose plural has an s.
#[must_use]
pub fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// The least number of this many significant digits that is not below `x`: what a bound is rounded to for people.
#[must_use]
pub fn rounded_up(x: f64, digits: u8) -> f64 {
    let text = format!("{x:.*e}", usize::from(digits.max(1)) - 1);
    let (Ok(nearest), Some((mantissa, exponent))) = (text.parse::<f64>(), text.split_once('e'))
    else {
        return x;
    };
    if nearest >= x || !x.is_finite() {
        return nearest;
    }
    // The next number of as many digits: one more in the last of them.
    let whole: String = mantissa.chars().filter(|&c| c != '.').collect();
    let whole: i64 = whole.parse().unwrap_or_default();
    let exponent: i32 = exponent.parse().unwrap_or_default();
    let next = format!("{}e{}", whole + 1, exponent + 1 - i32::from(digits.max(1)));
    next.parse().unwrap_or(x)
}

/// The number nearest to `x`, by ratio, that is a 1, 2 or 5 with zeros; 1 where `x` is not positive and finite.
#[must_use]
pub fn round_one_two_five(x: f64) -> f64 {
    if !(x.is_finite() && x > 0.0) {
        return 1.0;
    }
    let exponent = libm::log10(x).floor() as i32;
    // As text it is the nearest float at every size.
    let scaled = |digit: u8| format!("{digit}e{exponent}").parse().unwrap_or(1.0);
    [1, 2, 5, 10]
        .map(scaled)
        .into_iter()
        .min_by(|a, b| libm::log(a / x).abs().total_cmp(&libm::log(b / x).abs()))
        .unwrap_or(1.0)
}

/// The text of a number for tables: this many significant digits, trailing zeros kept so that columns align; as `1.96076e-4` below
/// a thousandth and from ten millions on. A number that is not finite gives `-`.
#[must_use]
pub fn compact(x: f64, digits: u8) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if !x.is_finite() {
        return "-".to_owned();
    }
    let digits = digits.max(1);
    let text = format!("{x:.*e}", usize::from(digits) - 1);
    let exponent = text.split_once('e').and_then(|(_, e)| e.parse().ok());
    match exponent {
        Some(exponent @ -3..7) => {
            let decimals = (i32::from(digits) - 1 - exponent).max(0);
            format!("{x:.*}", decimals as usize)
        }
        _ => text,
    }
}
