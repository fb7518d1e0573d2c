//! A pen that draws contours, subpath by subpath, as path data and PostScript do.

use kurbo::{ParamCurve as _, PathSeg, Point};

use super::{Contour, Step};
use crate::error::Result;
use crate::shape::endpoint::SvgArc;

/// What was drawn, and the current point.
#[derive(Debug, Default)]
pub(crate) struct ContourPen {
    contours: Vec<Contour>,
    steps: Vec<Step>,
    start: Point,
    here: Point,
}

impl ContourPen {
    /// The current point.
    pub(crate) const fn here(&self) -> Point {
        self.here
    }

    /// Begins a subpath.
    pub(crate) fn move_to(&mut self, to: Point) {
        self.end(false);
        (self.start, self.here) = (to, to);
    }

    pub(crate) fn line(&mut self, to: Point) {
        self.steps.push(Step::line(self.here, to));
        self.here = to;
    }

    /// A segment that begins at the current point.
    pub(crate) fn segment(&mut self, segment: PathSeg) {
        self.here = segment.end();
        self.steps.push(Step::Given(segment));
    }

    /// An arc that begins at the current point.
    pub(crate) fn arc(&mut self, arc: &SvgArc) -> Result<()> {
        self.steps.extend(Step::of_shape(arc.shape()?));
        self.here = arc.to;
        Ok(())
    }

    /// Closes the subpath, by a line where its end is not its start; the next one begins there.
    pub(crate) fn close(&mut self) {
        // A point alone is a dot where lines have round ends.
        if self.here != self.start || self.steps.is_empty() {
            self.line(self.start);
        }
        self.end(true);
    }

    /// All that was drawn.
    pub(crate) fn contours(mut self) -> Vec<Contour> {
        self.end(false);
        self.contours
    }

    fn end(&mut self, closed: bool) {
        if !self.steps.is_empty() {
            let steps = core::mem::take(&mut self.steps);
            self.contours.push(Contour { steps, closed });
        }
    }
}
