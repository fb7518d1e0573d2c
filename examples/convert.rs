//! An SVG document whose circles become Béziers: `cargo run --example convert --features document`.

use std::fmt::Write as _;

use curveto::document::{self, Options};

/// A document, converted, and a note on each element that was left.
pub(crate) fn text() -> Result<String, Box<dyn std::error::Error>> {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle cx="12" cy="12" r="10"/><circle r="10%"/></svg>"#;
    let converted = document::convert(svg, &Options::default())?;
    let mut out = format!("{}\n", converted.text);
    for note in &converted.notes {
        writeln!(
            out,
            "line {}: {} was left: {}",
            note.line, note.element, note.reason
        )?;
    }
    Ok(out)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    print!("{}", text()?);
    Ok(())
}
