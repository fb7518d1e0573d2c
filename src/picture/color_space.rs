//! Colours of other spaces than sRGB in it: `lab()`, `lch()`, `oklab()`, `oklch()` and `color()`, by the formulas and matrices of the
//! sample code of CSS Color 4 (<https://www.w3.org/TR/css-color-4/#color-conversion-code>). What lies outside of sRGB is cut to it; of the
//! largest lightness it is white, and of none black, whatever its hue.
//!
//! They are here and not csscolorparser's because that one takes powers and sines of the platform.

use crate::angle::Angle;

type Triple = [f64; 3];
type Matrix = [Triple; 3];

/// From the white D50, which CIELAB has, to D65, which sRGB has, by Bradford's method.
const D50_TO_D65: Matrix = [
    [
        0.955_473_421_488_075,
        -0.023_098_454_948_764_71,
        0.063_259_243_200_570_72,
    ],
    [
        -0.028_369_709_333_863_7,
        1.009_995_398_081_304_1,
        0.021_041_441_191_917_323,
    ],
    [
        0.012_314_014_864_481_998,
        -0.020_507_649_298_898_964,
        1.330_365_926_242_124,
    ],
];

/// From XYZ with the white D65 to linear sRGB.
const XYZ_TO_RGB: Matrix = [
    [12831.0 / 3959.0, -329.0 / 214.0, -1974.0 / 3959.0],
    [
        -851_781.0 / 878_810.0,
        1_648_619.0 / 878_810.0,
        36_519.0 / 878_810.0,
    ],
    [705.0 / 12673.0, -2585.0 / 12673.0, 705.0 / 667.0],
];

/// From Oklab to the cube roots of cone responses.
const OKLAB_TO_LMS: Matrix = [
    [1.0, 0.396_337_777_376_174_9, 0.215_803_757_309_913_6],
    [1.0, -0.105_561_345_815_658_6, -0.063_854_172_825_813_3],
    [1.0, -0.089_484_177_529_811_9, -1.291_485_548_019_409_2],
];

/// From cone responses to XYZ with the white D65.
const LMS_TO_XYZ: Matrix = [
    [
        1.226_879_875_845_924_3,
        -0.557_814_994_460_217_1,
        0.281_391_045_665_964_7,
    ],
    [
        -0.040_575_745_214_800_8,
        1.112_286_803_280_317,
        -0.071_711_058_065_516_4,
    ],
    [
        -0.076_372_936_674_660_1,
        -0.421_493_332_402_243_2,
        1.586_924_019_836_781_6,
    ],
];

/// The white D50 of CIELAB, by its chromaticity 0.3457, 0.3585.
const D50: Triple = [0.3457 / 0.3585, 1.0, (1.0 - 0.3457 - 0.3585) / 0.3585];

/// The red, green, blue and opacity from 0 to 1 of a colour function of these names; `None` where it is another, or wrong.
pub(super) fn parse(text: &str) -> Option<[f64; 4]> {
    let (name, arguments) = text.strip_suffix(')')?.split_once('(')?;
    let (values, alpha) = match arguments.split_once('/') {
        Some((values, alpha)) => (values, value(alpha.trim(), 1.0)?.clamp(0.0, 1.0)),
        None => (arguments, 1.0),
    };
    let words: Vec<&str> = values.split_ascii_whitespace().collect();
    let name = name.to_ascii_lowercase();
    let [r, g, b] = match (name.as_str(), &words[..]) {
        ("lab", &[l, a, b]) => lit(l, 100.0, [value(a, 125.0)?, value(b, 125.0)?], of_lab)?,
        ("lch", &[l, c, h]) => lit(l, 100.0, polar(value(c, 150.0)?, h)?, of_lab)?,
        ("oklab", &[l, a, b]) => lit(l, 1.0, [value(a, 0.4)?, value(b, 0.4)?], of_oklab)?,
        ("oklch", &[l, c, h]) => lit(l, 1.0, polar(value(c, 0.4)?, h)?, of_oklab)?,
        ("color", &[space, x, y, z]) => {
            let values = [value(x, 1.0)?, value(y, 1.0)?, value(z, 1.0)?];
            match space.to_ascii_lowercase().as_str() {
                "srgb" => values,
                "srgb-linear" => values.map(companded),
                "xyz" | "xyz-d65" => of_xyz(values),
                "xyz-d50" => of_xyz(times(&D50_TO_D65, values)),
                _ => return None,
            }
        }
        _ => return None,
    };
    Some([r, g, b, alpha])
}

/// A colour by its lightness, of which `whole` is white, and two coordinates of its hue.
fn lit(lightness: &str, whole: f64, [a, b]: [f64; 2], of: fn(Triple) -> Triple) -> Option<Triple> {
    let l = value(lightness, whole)?;
    Some(if l >= whole {
        [1.0; 3]
    } else if l <= 0.0 {
        [0.0; 3]
    } else {
        of([l, a, b])
    })
}

/// A number, or a part of what 100 % stands for; `none` is 0.
fn value(word: &str, whole: f64) -> Option<f64> {
    if word.eq_ignore_ascii_case("none") {
        return Some(0.0);
    }
    let number = |word: &str| word.parse().ok().filter(|x: &f64| x.is_finite());
    match word.strip_suffix('%') {
        Some(percent) => Some(number(percent)? * whole / 100.0),
        None => number(word),
    }
}

/// The two coordinates of a chroma and a hue.
fn polar(chroma: f64, hue: &str) -> Option<[f64; 2]> {
    let hue = if hue.eq_ignore_ascii_case("none") {
        Angle::ZERO
    } else {
        hue.parse().ok()?
    };
    let along = hue.direction() * chroma.max(0.0);
    Some([along.x, along.y])
}

fn times(matrix: &Matrix, [x, y, z]: Triple) -> Triple {
    matrix.map(|[a, b, c]| a * x + b * y + c * z)
}

/// f and its inverse are those of CIE 15: cubes, but near black a line.
fn of_lab([l, a, b]: Triple) -> Triple {
    const KAPPA: f64 = 24389.0 / 27.0;
    const EPSILON: f64 = 216.0 / 24389.0;
    let f = (l + 16.0) / 116.0;
    let inverse = |f: f64| {
        let cube = f * f * f;
        if cube > EPSILON {
            cube
        } else {
            (116.0 * f - 16.0) / KAPPA
        }
    };
    let [x, y, z] = [f + a / 500.0, f, f - b / 200.0].map(inverse);
    of_xyz(times(&D50_TO_D65, [x * D50[0], y * D50[1], z * D50[2]]))
}

fn of_oklab(lab: Triple) -> Triple {
    let lms = times(&OKLAB_TO_LMS, lab).map(|root| root * root * root);
    of_xyz(times(&LMS_TO_XYZ, lms))
}

fn of_xyz(xyz: Triple) -> Triple {
    times(&XYZ_TO_RGB, xyz).map(companded)
}

/// sRGB's transfer function.
fn companded(linear: f64) -> f64 {
    let size = linear.abs();
    let value = if size > 0.003_130_8 {
        1.055 * libm::pow(size, 1.0 / 2.4) - 0.055
    } else {
        12.92 * size
    };
    value.copysign(linear)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pairs are those of the examples in CSS Color 4 and of the web platform tests that go with it; csscolorparser is near by its own matrices.
    #[test]
    fn colours_are_those_of_the_specification() {
        for (text, rgb) in [
            ("lab(29.2345% 39.3825 20.0664)", [125, 35, 41]),
            ("lab(52.2345% 40.1645 59.9971)", [198, 93, 6]),
            ("lab(60.2345% -5.3654 58.956)", [157, 147, 24]),
            ("lab(62.2345% -34.9638 47.7721)", [104, 166, 57]),
            ("lab(67.5345% -8.6911 -41.6019)", [98, 172, 239]),
            ("lch(29.2345% 44.2 27)", [125, 35, 41]),
            ("lch(52.2345% 72.2 56.2)", [198, 93, 6]),
            ("oklab(40.101% 0.1147 0.0453)", [125, 35, 41]),
            ("oklab(59.686% 0.1009 0.1192)", [198, 93, 7]),
            ("oklab(55% 0 -0.2)", [71, 97, 228]),
            ("oklch(40.101% 0.12332 21.555)", [125, 35, 41]),
            ("oklch(44.027% 0.1603 303.37)", [102, 51, 153]),
            ("color(srgb 1 0.5 0)", [255, 128, 0]),
            ("color(srgb-linear 0.5 0.5 0.5)", [188, 188, 188]),
            ("color(xyz 0.95047 1 1.08883)", [255, 255, 255]),
            ("color(xyz-d50 0.9643 1 0.8251)", [255, 255, 255]),
        ] {
            let [r, g, b, alpha] = parse(text).unwrap();
            assert_eq!(alpha, 1.0);
            let found = [r, g, b].map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
            assert_eq!(found, rgb, "{text}");
            let theirs = csscolorparser::parse(text).unwrap().to_array();
            for (ours, theirs) in [r, g, b].into_iter().zip(theirs) {
                assert!((ours - f64::from(theirs)).abs() < 1e-3, "{text}");
            }
        }
    }

    #[test]
    fn both_forms_of_a_space_and_both_of_a_number_agree() {
        let near = |a: &str, b: &str| {
            let (left, right) = (parse(a).unwrap(), parse(b).unwrap());
            let far = left.iter().zip(right).map(|(x, y)| (x - y).abs());
            assert!(far.fold(0.0, f64::max) < 1e-12, "{a} {b}");
        };
        near("lab(50 20 0)", "lch(50 20 none)");
        near("lab(50 0 20)", "LCH(50% 20 100grad)");
        near("oklab(0.5 0 -0.1 / 40%)", "oklch(50% 25% 270deg / 0.4)");
        near("lab(50% 100% -100%)", "lab(50 125 -125)");
        near("lab(150 0 0)", "lab(100 none none / 7)");
        for (white, black) in [
            ("lab(100 50 50)", "lab(0 50 50)"),
            ("lch(100% 110 60)", "lch(-1 110 60)"),
            ("oklab(1 0.3 0.3)", "oklab(0% 0.3 0.3)"),
            ("oklch(120% 0.4 30)", "oklch(none 0.4 30)"),
        ] {
            assert_eq!(parse(white), Some([1.0; 4]));
            assert_eq!(parse(black), Some([0.0, 0.0, 0.0, 1.0]));
        }
        for wrong in [
            "lab(50 20)",
            "lab(50 20 0 1)",
            "lab(50 20 0 / )",
            "lab(50, 20, 0)",
            "lab(50 nan 0)",
            "lch(50 20 0px)",
            "color(a98-rgb 1 0 0)",
            "color(srgb 1 0)",
            "rgb(1 2 3)",
        ] {
            assert_eq!(parse(wrong), None, "{wrong}");
        }
    }
}
