use std::thread;

use proptest::prelude::*;

use super::*;
use crate::numeric::random::bits;

#[test]
fn compact_numbers_keep_their_digits() {
    let texts = [
        0.015_213_035,
        1.960_76e-4,
        0.0,
        -123.456,
        9.999_999_9,
        1e7,
        f64::NAN,
    ]
    .map(|x| compact(x, 6));
    assert_eq!(
        texts,
        [
            "0.0152130",
            "1.96076e-4",
            "0",
            "-123.456",
            "10.0000",
            "1.00000e7",
            "-"
        ]
    );
}

fn fixed(x: f64, decimals: u8) -> String {
    let mut out = b"#".to_vec();
    push_fixed(&mut out, x, decimals);
    String::from_utf8(out).unwrap().split_off(1)
}

fn shortest(x: f64) -> String {
    let mut out = b"#".to_vec();
    push_shortest(&mut out, x);
    String::from_utf8(out).unwrap().split_off(1)
}

/// The text of std, brought to our form.
fn plain(mut text: String) -> String {
    if text.contains('.') {
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    }
    if text == "-0" { "0".to_owned() } else { text }
}

/// All that this file promises of one finite number.
fn check(x: f64, decimals: u8) {
    let text = fixed(x, decimals);
    assert_eq!(
        text,
        plain(format!("{x:.*}", usize::from(decimals))),
        "{x:e} with {decimals} decimals"
    );
    let rounded = round(x, decimals);
    let read: f64 = text.parse().unwrap();
    assert_eq!(
        rounded.to_bits(),
        read.to_bits(),
        "{x:e} rounded to {decimals} decimals"
    );
    if text.trim_start_matches(['-', '0', '.']).len() <= 15 {
        assert_eq!(
            shortest(rounded),
            text,
            "{x:e} rounded to {decimals} decimals, in full"
        );
    }
    check_shortest(x);
    check_short(x, decimals, &text);
}

/// The short form leaves out the zero before the point, and a space stands where the number would run into another.
fn check_short(x: f64, decimals: u8, text: &str) {
    let Some(number) = Decimal::nearest(x, decimals) else {
        return;
    };
    let short = match text.split_once("0.") {
        Some((sign @ ("" | "-"), digits)) => format!("{sign}.{digits}"),
        _ => text.to_owned(),
    };
    for after in [After::Letter, After::Whole, After::Point] {
        let mut out = b"#".to_vec();
        let has_point = number.write(&mut out, after, BelowOne::Short);
        let parted = match (after, short.as_bytes()[0]) {
            (After::Letter, _) | (_, b'-') | (After::Point, b'.') => short.clone(),
            _ => format!(" {short}"),
        };
        assert_eq!(String::from_utf8_lossy(&out[1..]), parted, "{x:e}");
        assert_eq!(has_point, text.contains('.'), "{x:e}");
    }
}

/// Equal to std, or as short, a reading of the same float, and the even one of two equally near.
fn check_shortest(x: f64) {
    let (text, std) = (shortest(x), plain(format!("{x}")));
    if text != std {
        let decimals = std
            .split_once('.')
            .map_or(0, |(_, decimals)| decimals.len());
        assert_eq!(text, format!("{x:.decimals$}"), "{x:e} in full");
        assert_eq!(
            (text.parse(), text.len()),
            (Ok(x), std.len()),
            "{x:e} in full"
        );
    }
}

struct AnyNumbers(u64);

impl AnyNumbers {
    /// Coordinates, decimals, exact ties, their neighbours, and any bits at all.
    fn sample(&mut self) -> (f64, u8) {
        let choice = bits(&mut self.0);
        let decimals = (choice >> 8) % 21;
        let value = bits(&mut self.0);
        let near = value.cast_signed() >> (11 + (choice >> 16) % 53);
        let x = match choice % 6 {
            0 => near as f64 / 2f64.powi(((choice >> 24) % 60) as i32),
            1 => (near as f64 / 2f64.powi(((choice >> 24) % 20) as i32)).next_up(),
            2 => near as f64 / 10f64.powi(((choice >> 24) % 20) as i32),
            3 => ((value % 2_000_000) as f64 + 0.5) / 10f64.powi(decimals as i32),
            4 => 500.0 * ((value >> 11) as f64 / 2f64.powi(52) - 1.0),
            _ => f64::from_bits(value),
        };
        (if x.is_finite() { x } else { 0.5 }, decimals as u8)
    }
}

#[test]
fn trailing_zeros_and_point_are_dropped_and_the_leading_zero_is_kept() {
    assert_eq!(fixed(0.5, 3), "0.5");
    assert_eq!(fixed(-27.596, 3), "-27.596");
    assert_eq!(fixed(50.0, 8), "50");
    assert_eq!(fixed(100.0, 0), "100");
    assert_eq!(fixed(1200.0, 12), "1200");
    assert_eq!(fixed(0.1, 17), "0.10000000000000001");
}

#[test]
fn a_tie_of_the_binary_value_goes_to_even_and_no_other_is_a_tie() {
    assert_eq!(fixed(0.125, 2), "0.12");
    assert_eq!(fixed(0.375, 2), "0.38");
    assert_eq!(fixed(2.5, 0), "2");
    assert_eq!(fixed(3.5, 0), "4");
    // The float is a little more, or less, than the decimal in the source.
    assert_eq!(fixed(1.005, 2), "1");
    assert_eq!(fixed(0.15, 1), "0.1");
    assert_eq!(fixed(0.35, 1), "0.3");
    assert_eq!(fixed(0.45, 1), "0.5");
}

#[test]
fn a_carry_reaches_the_whole_part() {
    assert_eq!(fixed(0.9999, 3), "1");
    assert_eq!(fixed(-999_999.999_999_99, 3), "-1000000");
    assert_eq!(fixed(99_999_999.999_999_99, 3), "100000000");
}

#[test]
fn zero_has_no_sign() {
    for x in [0.0, -0.0, -1e-9, -5e-324] {
        assert_eq!(fixed(x, 3), "0");
        assert_eq!(fixed(x, 0), "0");
        assert_eq!(round(x, 3).to_bits(), 0);
    }
    assert_eq!(fixed(-5e-324, 255), "0");
    assert_eq!(round(-5e-324, 255).to_bits(), 0);
    assert_eq!(shortest(-0.0), "0");
}

#[test]
fn no_magnitude_needs_an_exponent() {
    assert_eq!(shortest(1e21), "1000000000000000000000");
    assert_eq!(shortest(-1e-7), "-0.0000001");
    assert_eq!(fixed(1e21, 2), "1000000000000000000000");
    assert_eq!(fixed(1e-20, 30), "0.00000000000000000001");
    for exponent in -323..=308 {
        let x: f64 = format!("1e{exponent}").parse().unwrap();
        for x in [x, x.next_down(), -x.next_up(), f64::MAX, f64::MIN_POSITIVE] {
            (0..=40).for_each(|decimals| check(x, decimals));
            check(x, 255);
        }
    }
}

#[test]
fn what_is_not_finite_prints_as_zero_and_stays_in_a_measurement() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for decimals in [0, 3, 19, 20, 255] {
            assert_eq!(fixed(x, decimals), "0");
            assert_eq!(round(x, decimals).is_nan(), x.is_nan());
            assert!(!round(x, decimals).is_finite());
        }
        assert_eq!(shortest(x), "0");
        assert_eq!(decimals_of(x), 0);
    }
}

#[test]
fn of_two_shortest_forms_the_even_one_is_printed() {
    assert_eq!(shortest(13_100_520_720.5 / 512.0), "25586954.532226562");
}

#[test]
fn decimals_are_counted_on_the_shortest_form() {
    let cases = [
        (0.25, 2),
        (1e-7, 7),
        (50.0, 0),
        (-0.0, 0),
        (27.596, 3),
        (1e300, 0),
        (5e-324, 255),
    ];
    for (x, decimals) in cases {
        assert_eq!(decimals_of(x), decimals, "{x}");
    }
}

#[test]
fn precision_chooses_the_decimals() {
    assert_eq!(Precision::Full.round(1.0625), 1.0625);
    assert_eq!(Precision::Fixed(1).round(1.0625), 1.1);
}

#[test]
fn eight_digits_are_split_without_error() {
    for n in (0..10_000)
        .chain((0..BLOCK).step_by(997))
        .chain([BLOCK - 1])
    {
        assert_eq!(
            (digits(n) | ZEROS).to_le_bytes(),
            format!("{n:08}").as_bytes()
        );
    }
}

proptest! {
    #[test]
    fn any_bits_print_as_std_prints_them(bits: u64, decimals in 0..30u8) {
        let x = f64::from_bits(bits);
        prop_assume!(x.is_finite());
        check(x, decimals);
    }

    #[test]
    fn decimal_inputs_print_as_std_prints_them(n in -1_000_000_000_000i64..1_000_000_000_000, scale in 0..16i32, decimals in 0..20u8) {
        check(n as f64 / 10f64.powi(scale), decimals);
    }

    #[test]
    fn exact_ties_print_as_std_prints_them(k in -(1i64 << 53)..(1 << 53), drop in 0..53u32, n in 0..70i32, decimals in 0..20u8) {
        check((k >> drop) as f64 / 2f64.powi(n), decimals);
    }
}

fn check_many(count: u64) {
    let threads = thread::available_parallelism().map_or(1, usize::from) as u64;
    thread::scope(|scope| {
        for seed in 0..threads {
            scope.spawn(move || {
                let mut numbers = AnyNumbers(seed << 40);
                for _ in 0..count.div_ceil(threads) {
                    let (x, decimals) = numbers.sample();
                    check(x, decimals);
                }
            });
        }
    });
}

#[test]
fn a_million_mixed_numbers_print_as_std_prints_them() {
    check_many(1_000_000);
}

/// Fewer with `CURVETO_NUMBERS`: `CURVETO_NUMBERS=100000000 cargo test --release -- --ignored number`.
#[test]
#[ignore = "long: a billion numbers against std"]
fn a_billion_mixed_numbers_print_as_std_prints_them() {
    check_many(
        std::env::var("CURVETO_NUMBERS").map_or(1_000_000_000, |count| count.parse().unwrap()),
    );
}

#[test]
fn what_needs_many_zeros_has_an_exponent_in_prose() {
    let texts = [2.5, 1e-58, 1e-70, 1.9608e-64, -4.25e-99].map(|x| significant(x, 3));
    let small = format!("0.{}1", "0".repeat(57));
    assert_eq!(texts, ["2.5", &small, "1e-70", "1.96e-64", "-4.25e-99"]);
}

#[test]
fn what_has_no_digits_to_round_is_left() {
    assert_eq!(significant(3e-300, 1), "3e-300");
    assert_eq!(significant(2.5e-300, 3), "2.5e-300");
    assert_eq!(rounded_up(f64::INFINITY, 3), f64::INFINITY);
    for none in [0.0, -3.0, f64::INFINITY, f64::NAN] {
        assert_eq!(round_one_two_five(none), 1.0);
    }
    for round in [5e-324, 1e-322, 2e-310, 1e-300, 5e101, 2e150, 1e308] {
        assert_eq!(round_one_two_five(round), round);
        assert_eq!(round_one_two_five(1.04 * round), round);
    }
    assert_eq!(round_one_two_five(f64::MAX), 1e308);
}

#[test]
fn a_difference_that_leaves_the_range_is_rounded() {
    let of = |units, decimals| decimal::Decimal { units, decimals };
    let found = of(9_000_000_000_000_000_000, 0).minus(of(1, 18));
    assert_eq!(found.value(), 9e18);
    // Nor is there a number of the other sign to the least word.
    let least = of(i64::MAX, 0).negated().minus(of(i64::MAX, 0));
    assert_eq!(least.negated().value(), i64::MAX as f64);
    for word in [
        "-9223372036854775808",
        "9223372036854775808",
        "-9999999999999999999",
    ] {
        assert_eq!(parse(word), word.parse().ok(), "{word}");
    }
}
