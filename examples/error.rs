//! How far a circle of another program strays: `cargo run --example error`.

use std::fmt::Write as _;

use curveto::measure::{Reference, report};
use curveto::{Circle, Shape, path};

/// The circle of radius 50 by the handle 0.55, measured.
pub(crate) fn text() -> Result<String, Box<dyn std::error::Error>> {
    let theirs = "M50 0C50 27.5 27.5 50 0 50C-27.5 50-50 27.5-50 0C-50-27.5-27.5-50 0-50C27.5-50 50-27.5 50 0Z";
    let circle = Shape::Circle(Circle::new((0.0, 0.0), 50.0)?);
    let outline = circle.outline().ok_or("a circle has an outline")?;
    let mut out = String::new();
    for curve in path::curves(theirs)? {
        let report = report(&curve, &Reference::from(&outline), None)?;
        let error = report.error;
        writeln!(
            out,
            "outside {:.4}, inside {:.4}",
            error.outward, error.inward
        )?;
    }
    Ok(out)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    print!("{}", text()?);
    Ok(())
}
