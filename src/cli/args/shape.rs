//! The words for shapes, and the shapes that they ask for.

use clap::{ArgAction, Args};
use curveto::shape::endpoint::{from_bulge, parse_svg_arc, through};
use curveto::shape::machine::{about_center, from_radius};
use curveto::{Angle, Arc, Circle, Ellipse, Shape};
use kurbo::{Point, Vec2};

use super::values;
use crate::cli::failure::Failure;

/// Where a closed shape starts and which way it runs, where nothing was asked for.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Direction {
    /// The angle of the first joint.
    pub(crate) start: Angle,
    /// Whether it runs against growing angles.
    pub(crate) reverse: bool,
}

#[derive(Debug, Args)]
pub(crate) struct CircleShape {
    /// The radius
    #[arg(value_name = "RADIUS", value_parser = values::number, allow_negative_numbers = true, required_unless_present = "diameter")]
    radius: Option<f64>,
    /// The diameter, in place of the radius
    #[arg(long, value_name = "D", value_parser = values::number, allow_hyphen_values = true, conflicts_with = "radius")]
    diameter: Option<f64>,
    #[command(flatten)]
    place: PlaceArgs,
    #[command(flatten)]
    course: CourseArgs,
}

#[derive(Debug, Args)]
pub(crate) struct EllipseShape {
    /// The radii along the ellipse's own axes
    #[arg(value_names = ["RX", "RY"], num_args = 2, value_parser = values::number, allow_negative_numbers = true, required_unless_present = "diameters")]
    radii: Vec<f64>,
    /// The diameters, in place of the radii
    #[arg(long, value_name = "W,H", value_parser = values::size, allow_hyphen_values = true, conflicts_with = "radii")]
    diameters: Option<Vec2>,
    /// The angle from the x axis to the axis of the first radius
    #[arg(long, value_name = "ANGLE", value_parser = values::angle, allow_hyphen_values = true)]
    rotation: Option<Angle>,
    #[command(flatten)]
    place: PlaceArgs,
    #[command(flatten)]
    course: CourseArgs,
}

#[derive(Debug, Args)]
pub(crate) struct ArcShape {
    /// The radius, or both radii along the ellipse's own axes
    #[arg(value_name = "RADIUS|RX RY", num_args = 1..=2, value_parser = values::number, allow_negative_numbers = true, group = "form")]
    radii: Vec<f64>,
    /// Where the arc starts
    ///
    /// An ellipse's angles are parametric, as in SVG and the HTML canvas: the point at angle A is (rx cos A, ry sin A), then rotated.
    /// Units are deg (default), rad, grad and turn. Positive angles turn from +x towards +y.
    #[arg(long, value_name = "ANGLE", value_parser = values::angle, allow_hyphen_values = true, requires = "radii", conflicts_with_all = ["svg", "through", "from"])]
    start: Option<Angle>,
    /// Where the arc ends
    ///
    /// As PostScript's arc takes it, with --reverse as arcn does. It is raised by whole turns until it is not below the start; with --reverse lowered until it is not above.
    #[arg(long, value_name = "ANGLE", value_parser = values::angle, allow_hyphen_values = true, requires = "radii", conflicts_with_all = ["sweep", "svg", "through", "from"])]
    end: Option<Angle>,
    /// How far the arc runs, with its sign
    ///
    /// At most one turn.
    #[arg(long, value_name = "ANGLE", value_parser = values::angle, allow_hyphen_values = true, requires = "radii", conflicts_with_all = ["svg", "through", "from"])]
    sweep: Option<Angle>,
    /// How far the first radius's axis is turned
    ///
    /// It is the angle from the x axis to that axis.
    #[arg(long, value_name = "ANGLE", value_parser = values::angle, allow_hyphen_values = true, requires = "radii", conflicts_with_all = ["svg", "through", "from"])]
    rotation: Option<Angle>,
    /// The centre [default: 0,0]
    ///
    /// With --from and --to it is the circle's, as G2 and G3 with I and J.
    #[arg(long, value_name = "X,Y", value_parser = values::point, allow_hyphen_values = true, conflicts_with_all = ["svg", "through"])]
    center: Option<Point>,
    /// SVG path data of one arc
    ///
    /// 'M x y A rx ry rotation large sweep x y'
    #[arg(long, value_name = "PATH", allow_hyphen_values = true, group = "form")]
    svg: Option<String>,
    /// Start, a point on the arc, end
    #[arg(long, value_names = ["X,Y", "X,Y", "X,Y"], num_args = 3, value_parser = values::point, allow_hyphen_values = true, group = "form", action = ArgAction::Set)]
    through: Vec<Point>,
    /// The first point, with --to
    ///
    /// And with one of --bulge, --radius and --center.
    #[arg(long, value_name = "X,Y", value_parser = values::point, allow_hyphen_values = true, requires = "to", group = "form")]
    from: Option<Point>,
    /// The last point
    #[arg(long, value_name = "X,Y", value_parser = values::point, allow_hyphen_values = true, requires = "from")]
    to: Option<Point>,
    /// The DXF bulge, tan(sweep/4)
    #[arg(long, value_name = "B", value_parser = values::number, allow_hyphen_values = true, requires = "from", conflicts_with_all = ["radius", "center"])]
    bulge: Option<f64>,
    /// The radius, as G2 and G3 with R
    #[arg(long, value_name = "R", value_parser = values::number, allow_hyphen_values = true, requires = "from", conflicts_with = "center")]
    radius: Option<f64>,
    /// With --radius: the longer way round
    #[arg(long, hide_short_help = true, requires = "radius", conflicts_with_all = ["bulge", "center"])]
    large: bool,
    /// Run against growing angles
    ///
    /// With --end, --radius or --center.
    #[arg(long, conflicts_with_all = ["sweep", "svg", "through", "bulge"])]
    reverse: bool,
    /// Leave out the closing operator of a whole turn
    #[arg(long, hide_short_help = true)]
    open: bool,
}

#[derive(Debug, Args)]
struct PlaceArgs {
    /// The centre
    #[arg(long, value_name = "X,Y", value_parser = values::point, allow_hyphen_values = true, default_value = "0,0")]
    center: Point,
}

#[derive(Debug, Args)]
pub(crate) struct CourseArgs {
    /// Where the first joint lies [default: 0; 180 in ps and eps]
    #[arg(long, value_name = "ANGLE", value_parser = values::angle, allow_hyphen_values = true)]
    start: Option<Angle>,
    /// Run the other way round
    #[arg(long)]
    reverse: bool,
    /// Leave out the closing operator
    #[arg(long)]
    open: bool,
}

impl CourseArgs {
    fn resolve(&self, default: Direction) -> Direction {
        Direction {
            start: self.start.unwrap_or(default.start),
            reverse: self.reverse != default.reverse,
        }
    }
}

/// Words that ask for a shape.
pub(crate) trait ShapeWords {
    /// The shape; a closed one starts and runs as `default` says where nothing was asked for.
    fn shape(&self, default: Direction) -> Result<Shape, Failure>;

    /// How a closed shape was asked to run.
    fn course(&self) -> Option<&CourseArgs> {
        None
    }

    /// Whether the closing operator is to be left out.
    fn open(&self) -> bool {
        self.course().is_some_and(|course| course.open)
    }

    /// Where the first joint was asked to lie.
    fn start(&self) -> Option<Angle> {
        self.course()?.start
    }
}

impl ShapeWords for CircleShape {
    fn shape(&self, default: Direction) -> Result<Shape, Failure> {
        let radius = match (self.radius, self.diameter) {
            (Some(radius), _) => radius,
            (None, diameter) => diameter.unwrap_or(f64::NAN) / 2.0,
        };
        let Direction { start, reverse } = self.course.resolve(default);
        Ok(Shape::Circle(Circle {
            start,
            reverse,
            ..Circle::new(self.place.center, radius)?
        }))
    }

    fn course(&self) -> Option<&CourseArgs> {
        Some(&self.course)
    }
}

impl ShapeWords for EllipseShape {
    fn shape(&self, default: Direction) -> Result<Shape, Failure> {
        let radii = match (self.diameters, self.radii.as_slice()) {
            (Some(diameters), _) => diameters / 2.0,
            (None, &[rx, ry]) => Vec2::new(rx, ry),
            (None, _) => return Err(Failure::request("an ellipse has two radii, RX and RY")),
        };
        let Direction { start, reverse } = self.course.resolve(default);
        let rotation = self.rotation.unwrap_or_default();
        Ok(Shape::Ellipse(Ellipse {
            start,
            reverse,
            ..Ellipse::new(self.place.center, radii, rotation)?
        }))
    }

    fn course(&self) -> Option<&CourseArgs> {
        Some(&self.course)
    }
}

impl ShapeWords for ArcShape {
    fn shape(&self, _: Direction) -> Result<Shape, Failure> {
        if let Some(svg) = &self.svg {
            return Ok(parse_svg_arc(svg)?.shape()?);
        }
        if let &[from, on, to] = self.through.as_slice() {
            return Ok(through(from, on, to)?);
        }
        match (self.from, self.to) {
            (Some(from), Some(to)) => self.between(from, to),
            _ => self.centre_form(),
        }
    }

    fn open(&self) -> bool {
        self.open
    }
}

impl ArcShape {
    fn between(&self, from: Point, to: Point) -> Result<Shape, Failure> {
        Ok(match (self.bulge, self.radius, self.center) {
            (Some(bulge), ..) => from_bulge(from, to, bulge)?,
            (None, Some(radius), _) => from_radius(from, to, radius, self.large, self.reverse)?,
            (None, None, Some(center)) => about_center(from, to, center, self.reverse)?,
            (None, None, None) => {
                return Err(Failure::request_with_hint(
                    "two ends determine no arc",
                    "add one of --bulge B, --radius R and --center X,Y",
                ));
            }
        })
    }

    fn centre_form(&self) -> Result<Shape, Failure> {
        let radii = match *self.radii.as_slice() {
            [radius] => Vec2::new(radius, radius),
            [rx, ry] => Vec2::new(rx, ry),
            _ => {
                return Err(Failure::request_with_hint(
                    "an arc needs a radius, or one of --svg, --through, --from",
                    "for example: curveto arc 10 --start 0 --end 90",
                ));
            }
        };
        let start = self.start.unwrap_or_default();
        let sweep = match (self.sweep, self.end) {
            (Some(sweep), _) => sweep,
            (None, Some(end)) => start.sweep_to(end, self.reverse),
            (None, None) => {
                return Err(Failure::request_with_hint(
                    "an arc needs --end or --sweep",
                    "for example: --start 0 --end 90",
                ));
            }
        };
        let arc = Arc::new(
            self.center.unwrap_or_default(),
            radii,
            self.rotation.unwrap_or_default(),
            start,
            sweep,
        )?;
        Ok(arc.shape())
    }
}
