//! What a page holds, as JSON: docs/schema/page.json.

use serde::Serialize;

use crate::compare::Criterion;
use crate::continuity::Continuity;
use crate::write::json::ShapeDocument;

/// Everything that a page shows.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PageDocument {
    /// The version of this form.
    pub version: u32,
    /// What the page is about.
    pub title: String,
    /// The command that makes the page.
    pub command: String,
    /// What methods are compared by at first.
    pub by: Criterion,
    /// What methods can be compared by.
    pub criteria: Vec<CriterionEntry>,
    /// The methods to choose from.
    pub methods: Vec<MethodEntry>,
    /// The shapes to choose from; the first is the one that was asked for.
    pub shapes: Vec<ShapeChoice>,
    /// What papers print, beside what is true.
    pub sources: Vec<SourceTable>,
}

/// What methods are compared by.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CriterionEntry {
    /// The name that `--by` takes.
    pub id: Criterion,
    /// What a title says.
    pub title: String,
    /// What an axis says, with the unit.
    pub label: String,
}

/// A method.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MethodEntry {
    /// The name that `-m` takes.
    pub id: String,
    /// The words of the command line that ask for it.
    pub words: String,
    /// What it does, in a few words.
    pub title: String,
    /// 2 or 3.
    pub degree: u8,
    /// The power of the angle with which the error falls; nothing where it follows none.
    pub order: Option<u8>,
    /// The factor before that power, as a formula.
    pub leading: String,
    /// What singles it out.
    pub criterion: String,
    /// Where it comes from, in two or three words.
    pub origin: String,
    /// When to use it.
    pub advice: String,
}

/// A shape, or a row of shapes that a slider runs over.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ShapeChoice {
    /// `asked`, `ellipse` or `arc`.
    pub id: String,
    /// What it is called.
    pub title: String,
    /// What the slider sets, and its unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quantity: Option<String>,
    /// The numbers of segments that were computed.
    pub counts: Vec<usize>,
    /// The shapes.
    pub steps: Vec<PageStep>,
}

/// A shape with its drawings.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "Step"))]
pub struct PageStep {
    /// Where the slider stands.
    pub value: f64,
    /// What it is, in a few words.
    pub title: String,
    /// The words of the command line that ask for it.
    pub words: String,
    /// The same for PostScript, whose writer starts elsewhere and runs the other way round unless asked to.
    pub words_ps: String,
    /// The shape.
    pub shape: ShapeDocument,
    /// Whether it is closed.
    pub closed: bool,
    /// The angles of the joints in degrees, for each of the counts.
    pub joints: Vec<Vec<f64>>,
    /// The drawings; what a method cannot draw is missing.
    pub drawings: Vec<DrawingEntry>,
}

impl PageStep {
    /// The drawing by a method with this many segments.
    #[must_use]
    pub fn drawing(&self, method: &str, segments: usize) -> Option<&DrawingEntry> {
        let mut drawings = self.drawings.iter();
        drawings.find(|drawing| drawing.method == method && drawing.segments == segments)
    }
}

/// A drawing.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DrawingEntry {
    /// The id of its method.
    pub method: String,
    /// How many segments it has.
    pub segments: usize,
    /// The decimals of its points, two more than the error needs; nothing where only all digits are enough.
    pub precision: Option<u8>,
    /// Its points, as SVG path data.
    pub path: String,
    /// The largest distances of the points as printed outside and inside the true shape, in user units, both at least 0.
    pub error: [f64; 2],
    /// The largest corner at a joint, in degrees, where the method's pieces do not share tangents.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<f64>,
    /// How arc length was integrated, where it was Chen's two-point Gauss quadrature.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quadrature: Option<String>,
    /// What methods are compared by, in the order of the criteria and for a larger radius of 1: before rounding, at six digits and
    /// rounded up.
    pub figures: [f64; 6],
    /// The lowest order of continuity at a joint; nothing where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub continuity: Option<Continuity>,
    /// The signed distance from the true shape at 25 values of t, (1 - cos(πi/24))/2 for i from 0 to 24, in thousandths of the peak in
    /// `figures`, positive outside: a list for each kind of segment, or its first 13 where it is the same from both ends. The polynomial
    /// through them is the distance to a thousandth or so: that of a circle has hardly more than the degree 6 of r².
    pub profiles: Vec<Vec<i16>>,
    /// Which profile each segment has, counted from 1; negative where it runs backwards. Nothing where all have the first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(feature = "schema", schemars(default))]
    pub profile_of: Vec<i16>,
}

/// What a paper prints, beside what is true.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SourceTable {
    /// The name by which a link asks for it.
    pub id: String,
    /// Whose table it is.
    pub title: String,
    /// The paper.
    pub source: String,
    /// What the figures are.
    pub note: String,
    /// Its rows.
    pub rows: Vec<SourceRow>,
}

/// A printed figure.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SourceRow {
    /// What it is.
    pub label: String,
    /// The method that it belongs to.
    pub method: String,
    /// The number of segments of the circle.
    pub segments: usize,
    /// The figure, as it is printed.
    pub printed: String,
    /// The printed figure as a number.
    pub printed_value: f64,
    /// The true figure.
    #[serde(rename = "true")]
    pub truth: f64,
    /// The unit: nothing, or `%`.
    pub unit: String,
    /// The command that shows the true one.
    pub command: String,
}
