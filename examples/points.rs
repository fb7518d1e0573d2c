//! The control points of an arc, without an allocation for them: `cargo run --example points`.

use std::fmt::Write as _;

use curveto::{Angle, Arc};

/// Every cubic of a part of an ellipse on a line, within a hundredth of it.
pub(crate) fn text() -> Result<String, Box<dyn std::error::Error>> {
    let (start, sweep) = (Angle::from_degrees(30.0), Angle::from_degrees(200.0));
    let arc = Arc::new((0.0, 0.0), (50.0, 20.0), Angle::ZERO, start, sweep)?;
    let mut out = String::new();
    for cubic in arc.cubics(0.01) {
        let points = [cubic.p0, cubic.p1, cubic.p2, cubic.p3];
        writeln!(
            out,
            "{}",
            points.map(|p| format!("{:.3},{:.3}", p.x, p.y)).join(" ")
        )?;
    }
    Ok(out)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    print!("{}", text()?);
    Ok(())
}
