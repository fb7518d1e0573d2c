//! `sphere`.

use std::process::ExitCode;

use curveto::Rule;
use curveto::sphere::{Options, Sphere, View};
use curveto::write::sphere::SphereDrawing;

use super::Outcome;
use super::args::SphereArgs;
use super::output::write_drawn;

pub(super) fn run(args: &SphereArgs) -> Outcome {
    let format = args.output.format_but_gcode()?;
    let [longitude, latitude] = args.view;
    let view = View {
        longitude,
        latitude,
        y_up: format.has_y_up(),
    };
    let options = Options {
        rule: Rule::Method(args.method),
        cut: args.cut(),
        precision: args.output.rounding(format),
        transform: args.output.transform(),
    };
    let sphere = Sphere::new(args.center, args.radius, args.meridians, args.parallels)?;
    let picture = sphere.seen(view, &options)?;
    let hidden = args.hidden;
    write_drawn(
        &SphereDrawing { picture, hidden },
        format,
        &args.output.options(format)?,
        &args.output,
    )?;
    Ok(ExitCode::SUCCESS)
}
