use kurbo::{Affine, Vec2};
use svgtypes::{TransformListParser, TransformListToken as Token};

use super::refusal::refusal;
use crate::angle::Angle;
use crate::error::{Error, Result, TextError};

/// What such a list holds.
const FUNCTION: &str = "a function such as rotate(30) or translate(5,0)";

/// Reads the list of an SVG `transform` as one map.
///
/// svgtypes reads the list; the map is made here, because it would ask the platform for sines, and would turn by 90 degrees with a
/// cosine of 6e-17.
///
/// # Errors
///
/// Where the text is no such list, or a number of the map overflows.
pub fn transform(text: &str) -> Result<Affine> {
    let mut map = Affine::IDENTITY;
    for token in TransformListParser::from(text) {
        let token = token
            .map_err(|error| Error::Text(TextError::Transform(refusal(&error, text, FUNCTION))))?;
        map *= one(token);
    }
    // svgtypes takes a comma after the last one too.
    if text.trim_end().ends_with(',') {
        let why = refusal(&svgtypes::Error::UnexpectedEndOfStream, text, FUNCTION);
        return Err(Error::Text(TextError::Transform(why)));
    }
    if map.is_finite() {
        Ok(map)
    } else {
        Err(Error::Text(TextError::TransformNotFinite))
    }
}

fn one(token: Token) -> Affine {
    match token {
        Token::Matrix { a, b, c, d, e, f } => Affine::new([a, b, c, d, e, f]),
        Token::Translate { tx, ty } => Affine::translate((tx, ty)),
        Token::Scale { sx, sy } => Affine::scale_non_uniform(sx, sy),
        Token::Rotate { angle } => {
            let Vec2 { x, y } = Angle::from_degrees(angle).direction();
            Affine::new([x, y, -y, x, 0.0, 0.0])
        }
        Token::SkewX { angle } => Affine::skew(libm::tan(angle.to_radians()), 0.0),
        Token::SkewY { angle } => Affine::skew(0.0, libm::tan(angle.to_radians())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_function_makes_the_map_of_svgtypes() {
        for text in [
            "",
            "matrix(1 2 3 4 5 6)",
            "translate(7), scale(2)",
            "scale(2 -3) translate(1 4)",
            "rotate(30)",
            "rotate(200, 3, 4)",
            "skewX(20) skewY(-50)",
        ] {
            let own = transform(text).unwrap().as_coeffs();
            let theirs: svgtypes::Transform = text.parse().unwrap();
            let theirs = [theirs.a, theirs.b, theirs.c, theirs.d, theirs.e, theirs.f];
            for (own, theirs) in own.into_iter().zip(theirs) {
                assert!((own - theirs).abs() < 4e-15, "{text}: {own} {theirs}");
            }
        }
    }

    #[test]
    fn quarter_turns_are_exact() {
        let map = transform("rotate(90)").unwrap();
        assert_eq!(map, Affine::new([0.0, 1.0, -1.0, 0.0, 0.0, 0.0]));
    }

    #[test]
    fn what_is_no_list_is_refused() {
        for text in ["rotate(", "turn(3)", "scale(1e999)"] {
            assert!(transform(text).is_err(), "{text}");
        }
    }
}
