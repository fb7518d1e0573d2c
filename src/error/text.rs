//! Why a text that was given cannot be read.

use thiserror::Error;

/// Why a text that was given cannot be read. Long texts stand here by their first words.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TextError {
    /// SVG path data.
    #[error("cannot read the path data '{data}': {why}")]
    PathData {
        /// The data.
        data: String,
        /// What is expected, and where.
        why: String,
    },
    /// The points of a `polyline` or a `polygon`.
    #[error("cannot read the points '{points}': {why}")]
    Points {
        /// The points.
        points: String,
        /// What is expected, and where.
        why: String,
    },
    /// An SVG transform list.
    #[error("not an SVG transform list: {0}")]
    Transform(String),
    /// A transform whose numbers overflow.
    #[error("the transform is not finite")]
    TransformNotFinite,
    /// The transform of an element.
    #[error("cannot read the transform '{text}': {why}")]
    ElementTransform {
        /// The text.
        text: String,
        /// What is wrong with it.
        why: Box<super::Error>,
    },
    /// A property of an element whose value is not read.
    #[error("its {name} '{value}' is not read here")]
    Property {
        /// The property.
        name: String,
        /// Its value.
        value: String,
    },
    /// An element within an `svg` of which the width, the height or the `viewBox` is zero.
    #[error("a viewport around it has no size: nothing in it is drawn")]
    NoViewport,
    /// A property that an element lacks, and that has no default.
    #[error("{0} is not known")]
    NoProperty(&'static str),
    /// An entity whose text cannot stand where it does.
    #[error("the entity `&{entity};` in line {line} at character {column} {why}")]
    Entity {
        /// Its name.
        entity: String,
        /// The line of the reference, from 1.
        line: usize,
        /// Its column in characters, from 1.
        column: usize,
        /// What is wrong with it.
        why: &'static str,
    },
    /// A PostScript drawing.
    #[error("line {line}: {why}")]
    PostScript {
        /// The line, from 1.
        line: usize,
        /// What is wrong there.
        why: Box<super::Error>,
    },
    /// A word of a PostScript drawing that is not known.
    #[error(
        "'{0}' is none of the operators of a plain drawing, which are all that is read of PostScript"
    )]
    Operator(String),
    /// An operator of PostScript that goes on from a current point where there is none.
    #[error("'{0}' needs a current point, which 'newpath' and painting take away")]
    CurrentPoint(String),
    /// An operator of PostScript with too few numbers before it.
    #[error("{operator} takes {takes} numbers and has {count}")]
    Operands {
        /// The operator.
        operator: String,
        /// How many it takes.
        takes: usize,
        /// How many stand before it.
        count: usize,
    },
}
