//! PostScript path operators as contours.

use kurbo::{Affine, CubicBez, PathSeg, Point, Vec2};

use crate::angle::Angle;
use crate::contour::{Contour, ContourPen};
use crate::error::{Error, Result, TextError, finite};
use crate::joints::MOST_IN_ALL;
use crate::shape::endpoint::SvgArc;
use crate::shape::{Arc, Truth};

/// Operators of drawings that have no say in where a path lies.
const HARMLESS: [&str; 12] = [
    "setlinewidth",
    "setlinejoin",
    "setlinecap",
    "setmiterlimit",
    "setdash",
    "setgray",
    "setrgbcolor",
    "setcmykcolor",
    "setflat",
    "clip",
    "eoclip",
    "pop",
];

/// The contours of PostScript path operators, one for each subpath that draws something, with `translate`, `scale`, `rotate`,
/// `concat`, `dup`, `neg`, `gsave` and `grestore` obeyed: of the paths that are painted, once where one is filled and stroked, and of the one that is left
/// at the end.
///
/// # Errors
///
/// Where an operator lacks its numbers or a current point, a number is not finite or beyond 1e150, a sweep is more than a turn, or a word is none of a plain
/// drawing: procedures are not executed.
///
/// ```
/// let contours = curveto::path::postscript("50 0 moveto 50 27.6 27.6 50 0 50 curveto closepath")?;
/// assert_eq!(contours[0].steps.len(), 2);
/// # Ok::<(), curveto::Error>(())
/// ```
pub fn postscript(text: &str) -> Result<Vec<Contour>> {
    let mut machine = Machine::default();
    for (i, line) in text.lines().enumerate() {
        let code = line.split('%').next().unwrap_or_default();
        let spaced = code.replace('[', " [ ").replace(']', " ] ");
        for word in spaced.split_ascii_whitespace() {
            machine.take(word).map_err(|error| {
                let why = Box::new(error);
                Error::Text(TextError::PostScript { line: i + 1, why })
            })?;
        }
    }
    machine.paint()?;
    Ok(machine.drawn)
}

/// What a path is made of, in coordinates of the page.
#[derive(Debug, Clone, Copy)]
enum PagePart {
    Move(Point),
    Line(Point),
    Curve([Point; 3]),
    Arc(SvgArc),
    Close,
}

/// What `gsave` keeps.
#[derive(Debug, Clone, Copy, Default)]
struct State {
    map: Affine,
    /// The first point of the subpath, and the current point.
    points: Option<[Point; 2]>,
    /// Where the path begins in [`Machine::marks`].
    begin: usize,
    /// How much was drawn by then.
    drawn: usize,
}

#[derive(Debug, Default)]
struct Machine {
    numbers: Vec<f64>,
    state: State,
    /// The path, and before it those of the states that were saved: a state that comes back finds its own again.
    marks: Vec<PagePart>,
    /// States, how many marks there were, and whether `save` saved them, not `gsave`.
    saved: Vec<(State, usize, bool)>,
    drawn: Vec<Contour>,
    /// How many segments these have.
    count: usize,
}

impl Machine {
    fn take(&mut self, word: &str) -> Result<()> {
        if let Ok(number) = word.parse::<f64>() {
            self.numbers.push(finite("number", number)?);
            return Ok(());
        }
        match word {
            // The brackets of a matrix or of a dash.
            "[" | "]" => return Ok(()),
            // As in `2 dup neg scale`, which turns a picture over.
            "dup" => {
                let [number] = self.last(word)?;
                self.numbers.push(number);
                return Ok(());
            }
            "neg" => {
                let [number] = self.last(word)?;
                self.numbers.pop();
                self.numbers.push(-number);
                return Ok(());
            }
            _ => {}
        }
        if !self.paint_or_keep(word)? {
            self.draw_or_map(word)?;
        }
        self.numbers.clear();
        Ok(())
    }

    /// Obeys an operator that ends a path, or that saves it with its matrix or brings it back, and whether it is one.
    fn paint_or_keep(&mut self, word: &str) -> Result<bool> {
        match word {
            "newpath" => self.new_path(),
            "stroke" | "fill" | "eofill" => {
                self.paint()?;
                self.new_path();
            }
            "showpage" => {
                self.state.map = Affine::IDENTITY;
                self.new_path();
            }
            "gsave" | "save" => {
                let saved = (self.state, self.marks.len(), word == "save");
                self.saved.push(saved);
            }
            "grestore" => self.restore(),
            "restore" => {
                let save = self.saved.iter().rposition(|&(.., is_save)| is_save);
                self.saved.truncate(save.map_or(0, |i| i + 1));
                self.restore();
                self.saved.pop();
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Brings back the last state that was saved; one that `save` saved stays there, as the first one of all does.
    fn restore(&mut self) {
        let (state, marks, is_save) = self.saved.last().copied().unwrap_or_default();
        if !is_save {
            self.saved.pop();
        }
        self.state = state;
        self.marks.truncate(marks);
    }

    fn new_path(&mut self) {
        self.marks
            .truncate(self.saved.last().map_or(0, |&(_, marks, _)| marks));
        self.state = State {
            map: self.state.map,
            points: None,
            begin: self.marks.len(),
            drawn: self.drawn.len(),
        };
    }

    /// Draws the path, unless what was painted since it began is just that: `gsave fill grestore stroke` paints one path twice.
    fn paint(&mut self) -> Result<()> {
        let mut pen = ContourPen::default();
        for mark in &self.marks[self.state.begin..] {
            match *mark {
                PagePart::Move(to) => pen.move_to(to),
                PagePart::Line(to) => pen.line(to),
                PagePart::Curve([a, b, to]) => {
                    let cubic = CubicBez::new(pen.here(), a, b, to);
                    pen.segment(PathSeg::Cubic(cubic));
                }
                PagePart::Arc(arc) => pen.arc(&arc)?,
                PagePart::Close => pen.close(),
            }
        }
        let path = pen.contours();
        if self.drawn[self.state.drawn..].starts_with(&path) {
            return Ok(());
        }
        // What is saved can be painted again and again.
        let count: usize = path.iter().map(|contour| contour.steps.len()).sum();
        self.count += count;
        if self.count > MOST_IN_ALL.max(count) {
            return Err(Error::Count {
                count: self.count,
                most: MOST_IN_ALL,
            });
        }
        self.drawn.extend(path);
        Ok(())
    }

    fn draw_or_map(&mut self, word: &str) -> Result<()> {
        match word {
            "moveto" | "rmoveto" => {
                let [to] = self.points(word, word == "rmoveto")?;
                self.state.points = Some([to; 2]);
                self.marks.push(PagePart::Move(to));
            }
            "lineto" | "rlineto" => {
                let [to] = self.points(word, word == "rlineto")?;
                self.go(word, to, PagePart::Line(to))?;
            }
            "curveto" | "rcurveto" => {
                let points = self.points(word, word == "rcurveto")?;
                self.go(word, points[2], PagePart::Curve(points))?;
            }
            "arc" | "arcn" => self.arc(word)?,
            "closepath" => {
                if let Some([start, here]) = &mut self.state.points {
                    *here = *start;
                    // What is closed already stays as it is.
                    if !matches!(self.marks.last(), Some(PagePart::Close)) {
                        self.marks.push(PagePart::Close);
                    }
                }
            }
            "translate" => {
                let [x, y] = self.last(word)?;
                self.state.map *= Affine::translate(Vec2::new(x, y));
            }
            "scale" => {
                let [x, y] = self.last(word)?;
                self.state.map *= Affine::scale_non_uniform(x, y);
            }
            "rotate" => {
                let [degrees] = self.last(word)?;
                let v = crate::Angle::from_degrees(degrees).direction();
                self.state.map *= Affine::new([v.x, v.y, -v.y, v.x, 0.0, 0.0]);
            }
            "concat" => self.state.map *= Affine::new(self.last(word)?),
            _ if HARMLESS.contains(&word) => {}
            _ => {
                return Err(Error::Text(TextError::Operator(word.to_owned())));
            }
        }
        Ok(())
    }

    /// The last numbers on the stack.
    fn last<const N: usize>(&self, word: &str) -> Result<[f64; N]> {
        let numbers = self.numbers.last_chunk().copied();
        numbers.ok_or_else(|| self.too_few(word, N))
    }

    fn too_few(&self, operator: &str, takes: usize) -> Error {
        Error::Text(TextError::Operands {
            operator: operator.to_owned(),
            takes,
            count: self.numbers.len(),
        })
    }

    /// The current point, which an operator needs.
    fn here(&self, word: &str) -> Result<Point> {
        let [_, here] = self
            .state
            .points
            .ok_or_else(|| Error::Text(TextError::CurrentPoint(word.to_owned())))?;
        Ok(here)
    }

    fn points<const N: usize>(&self, word: &str, relative: bool) -> Result<[Point; N]> {
        let numbers = self.numbers.as_slice();
        let Some(at) = numbers.len().checked_sub(2 * N) else {
            return Err(self.too_few(word, 2 * N));
        };
        let [a, b, c, d, _, _] = self.state.map.as_coeffs();
        let here = if relative {
            Some(self.here(word)?)
        } else {
            None
        };
        let mut points = [Point::ZERO; N];
        for (point, pair) in points.iter_mut().zip(numbers[at..].as_chunks::<2>().0) {
            let given = Point::new(pair[0], pair[1]);
            *point = if let Some(here) = here {
                let v = given.to_vec2();
                here + Vec2::new(a * v.x + c * v.y, b * v.x + d * v.y)
            } else {
                self.state.map * given
            };
        }
        Ok(points)
    }

    /// Goes on from the current point.
    fn go(&mut self, word: &str, to: Point, mark: PagePart) -> Result<()> {
        self.here(word)?;
        if let Some([_, here]) = &mut self.state.points {
            *here = to;
        }
        self.marks.push(mark);
        Ok(())
    }

    /// An arc, after a line to its start where there is a current point: in thirds, which their ends and radii determine.
    fn arc(&mut self, word: &str) -> Result<()> {
        let [x, y, radius, start, end] = self.last(word)?;
        let [start, end] = [start, end].map(Angle::from_degrees);
        let sweep = start.sweep_to(end, word == "arcn");
        let arc = Arc::new((x, y), (radius, radius), Angle::ZERO, start, sweep)?;
        let map = self.state.map * Affine::translate(arc.center.to_vec2()) * Affine::scale(radius);
        let truth = Truth::of(map)?;
        let at = |third: u8| {
            let angle = start.degrees() + arc.sweep.degrees() * f64::from(third) / 3.0;
            map * Angle::from_degrees(angle).direction().to_point()
        };
        match self.state.points {
            None => {
                self.state.points = Some([at(0); 2]);
                self.marks.push(PagePart::Move(at(0)));
            }
            Some([_, here]) if here != at(0) => self.go(word, at(0), PagePart::Line(at(0)))?,
            Some(_) => {}
        }
        for third in 1..=3 {
            let arc = SvgArc {
                from: at(third - 1),
                radii: truth.radii,
                rotation: Angle::of(truth.axis),
                large_arc: false,
                sweep: (sweep.degrees() > 0.0) == (self.state.map.determinant() > 0.0),
                to: at(third),
            };
            // What is no arc is refused where it stands.
            arc.shape()?;
            self.go(word, arc.to, PagePart::Arc(arc))?;
        }
        Ok(())
    }
}
