//! `sphere`.

use std::process::ExitCode;

use curveto::Rule;
use curveto::picture::figure::Figure;
use curveto::sphere::{Options, Sphere, View};
use curveto::write::json;
use curveto::write::sphere::SphereDocument;

use super::Outcome;
use super::args::SphereArgs;
use super::output::write_figure;

pub(super) fn run(args: &SphereArgs) -> Outcome {
    let format = args.output.format()?;
    let [longitude, latitude] = args.view;
    let view = View {
        longitude,
        latitude,
        y_up: format.has_y_up(),
    };
    let options = Options {
        rule: Rule::Method(args.method),
        segments: args.segments,
        precision: args.output.rounding(format),
        transform: args.output.transform(),
    };
    let sphere = Sphere::new(args.center, args.radius, args.meridians, args.parallels)?;
    let picture = sphere.seen(view, &options)?;
    let hidden = args.hidden.into();
    let figure = Figure::of_sphere(&picture, hidden);
    let json = || Ok(json::to_string(&SphereDocument::new(&picture, hidden))?);
    write_figure(&figure, json, format, &args.output)?;
    Ok(ExitCode::SUCCESS)
}
