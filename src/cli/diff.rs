//! `diff`.

mod read;

use std::ffi::OsStr;
use std::fmt::Write as _;
use std::process::ExitCode;

use curveto::diff::{Difference, Pair, Side, compare};
use curveto::number::{compact, counted, rounded_up, significant};
use curveto::write::difference::DifferenceDocument;
use curveto::write::json;

use super::Outcome;
use super::args::QuietArgs;
use super::args::diff::{DiffArgs, DiffFormat};
use super::failure::Failure;
use super::input::Source;
use super::output::OutputTarget;

/// Compares two drawings; 0 within the tolerance, 1 beyond it, 2 where that cannot be said.
pub(super) fn run(args: &DiffArgs) -> Outcome {
    if args.tolerance < 0.0 || !args.tolerance.is_finite() {
        return Err(Failure::request_with_hint(
            format!(
                "a tolerance is a distance of at least 0, not {}",
                args.tolerance
            ),
            "for example: curveto diff old.svg new.svg -t 0.01",
        ));
    }
    if [&args.old, &args.new].map(Source::of) == [Source::Stdin; 2] {
        return Err(Failure::request_with_hint(
            "standard input cannot be both drawings",
            "name a file for one of them",
        ));
    }
    let notes = QuietArgs { quiet: args.quiet };
    // Exit code 1 says that the drawings differ.
    let old = read::drawing(&args.old, notes).map_err(Failure::requested)?;
    let new = read::drawing(&args.new, notes).map_err(Failure::requested)?;
    let difference = compare(&old, &new, args.tolerance)?;
    let report = match args.format {
        _ if args.quiet => String::new(),
        DiffFormat::Json => json::to_string(&DifferenceDocument::from(&difference))? + "\n",
        DiffFormat::Text => text(&difference, args),
    };
    OutputTarget::Stdout
        .write(report.as_bytes())
        .map_err(Failure::requested)?;
    Ok(ExitCode::from(u8::from(!difference.is_within())))
}

fn text(difference: &Difference, args: &DiffArgs) -> String {
    let mut out = String::new();
    let beyond = difference
        .pairs
        .iter()
        .filter(|pair| !difference.allows(pair));
    for pair in beyond {
        out += &line(pair, difference.noise, args);
    }
    for (only, here, there) in [
        (&difference.only_old, &args.old, &args.new),
        (&difference.only_new, &args.new, &args.old),
    ] {
        for i in only {
            // Writing to a string cannot fail.
            let _ = writeln!(
                out,
                "subpath {} of {} has no like in {}",
                i + 1,
                name(here),
                name(there)
            );
        }
    }
    let subpaths = counted(difference.pairs.len(), "subpath");
    let distance = difference.distance();
    if distance > 0.0 {
        let bound = bound(distance, difference.noise);
        let _ = if difference.is_within() {
            writeln!(out, "{subpaths} within {bound}")
        } else {
            writeln!(out, "{subpaths} up to {bound} apart")
        };
    } else if difference.is_within() {
        let _ = writeln!(out, "{subpaths} with equal segments");
    }
    out
}

/// What is said of a pair beyond the tolerance.
fn line(pair: &Pair, noise: f64, args: &DiffArgs) -> String {
    let who = if pair.old == pair.new {
        format!("subpath {}", pair.old + 1)
    } else {
        format!("subpath {} and {}", pair.old + 1, pair.new + 1)
    };
    let Some(place) = pair.distance.place else {
        return format!("{who}: one is closed and the other is not\n");
    };
    let n = |x| compact(x, 6);
    format!(
        "{who}: up to {} apart, at {},{} on segment {} of {}\n",
        bound(pair.distance.at_most, noise),
        n(place.point.x),
        n(place.point.y),
        place.segment + 1,
        name(match place.side {
            Side::Old => &args.old,
            Side::New => &args.new,
        }),
    )
}

/// A bound with a few digits, rounded up but for what the rounding of coordinates explains.
fn bound(distance: f64, noise: f64) -> String {
    let known = if distance > 1e6 * noise {
        distance - noise
    } else {
        distance
    };
    significant(rounded_up(known, 4), 4)
}

fn name(words: &OsStr) -> String {
    match Source::of(words) {
        Source::Stdin => Source::Stdin.name(),
        Source::File(_) => curveto::path::shortened(&words.to_string_lossy()),
    }
}
