//! What holds for any input: one function for each kind, which says what is broken. `make test` goes over what is in fixtures/fuzz.

#![allow(unreachable_pub)]

mod documents;
mod geometry;
mod numbers;
mod words;

pub use documents::{documents, judge, to_arcs};
pub use geometry::{arcs, diff, measure, path_data, points, transforms};
pub use numbers::numbers;
pub use words::{lines, words};

/// What is broken, if anything.
pub type Check = Result<(), String>;

/// A promise about any bytes.
pub type Promise = fn(&[u8]) -> Check;

/// All promises by the names of their folders of seeds.
pub const PROMISES: [(&str, Promise); 11] = [
    ("arcs", arcs),
    ("path_data", path_data),
    ("documents", documents),
    ("to_arcs", to_arcs),
    ("lines", lines),
    ("words", words),
    ("transforms", transforms),
    ("points", points),
    ("measure", measure),
    ("numbers", numbers),
    ("diff", diff),
];

/// Holds the promise of this name.
///
/// # Panics
///
/// With what is broken.
pub fn hold(name: &str, input: &[u8]) {
    let promise = PROMISES.iter().find(|(known, _)| *known == name);
    let (_, promise) = promise.expect("a promise of this name");
    if let Err(why) = promise(input) {
        panic!("{name}: {why}\n{}", String::from_utf8_lossy(input));
    }
}

fn ensure(holds: bool, why: impl FnOnce() -> String) -> Check {
    if holds { Ok(()) } else { Err(why()) }
}

/// Path data that we write: letters and plain numbers, which another reader takes.
fn is_well_formed(data: &str) -> Check {
    let plain = data
        .bytes()
        .all(|byte| b"MLCQZAmlcqza0123456789.- ".contains(&byte));
    let read = svgtypes::PathParser::from(data).all(|segment| segment.is_ok());
    ensure(plain && read, || format!("no path data: {data}"))
}

/// Whether numbers are of the everyday kind, so that double precision can judge what is made of them, and counts are small.
fn is_tame(text: &str) -> bool {
    let bytes = text.as_bytes();
    let digits = |byte: &u8| byte.is_ascii_digit() || *byte == b'.';
    let exponent = |pair: &[u8]| digits(&pair[0]) && pair[1].eq_ignore_ascii_case(&b'e');
    bytes.split(|byte| !digits(byte)).all(|run| run.len() < 6) && !bytes.windows(2).any(exponent)
}
