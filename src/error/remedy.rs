//! What can be done instead of what cannot.

/// What can be done instead. Methods stand by their ids, the best first.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Remedy {
    /// More segments, of at most this many degrees each where that is known; or methods that serve half a turn.
    MoreSegments {
        /// The largest angle of a segment.
        degrees: Option<f64>,
        /// Methods that serve half a turn.
        methods: &'static [&'static str],
    },
    /// At least three segments, or other methods.
    ThreeSegments(&'static [&'static str]),
    /// One of these numbers of segments, or methods that serve every angle.
    Segments(Vec<usize>, &'static [&'static str]),
    /// A method that serves every ellipse.
    EveryEllipse(&'static str),
    /// Quarters from axis to axis of an ellipse, or other methods.
    Quarters(&'static [&'static str]),
    /// More segments, or joints that are nearer to one another.
    NearerJoints,
    /// The same, by other methods.
    NearerJointsBy(Vec<&'static str>),
    /// Joints at these angles in degrees.
    Joints(Vec<f64>),
    /// Other methods.
    Methods(&'static [&'static str]),
    /// Methods whose segments end on the circle.
    OnCircle(Vec<&'static str>),
    /// The finest tolerance at this size, rounded up.
    FinestTolerance(f64),
    /// A larger tolerance, and nothing else.
    LargerToleranceAlone,
    /// A larger tolerance, or this method.
    LargerTolerance(&'static str),
    /// A larger tolerance, or this method, whose error falls with the sixth power of the angle.
    LargerToleranceOrOrder(&'static str),
    /// More decimals, or as many as the error needs.
    MoreDecimals,
    /// More decimals, or a larger tolerance.
    MoreDecimalsOrTolerance,
    /// One answer a line in place of one picture.
    LineByLine,
    /// The function `approximate` draws by every method.
    Approximate,
    /// Fewer methods or counts on one page.
    SmallerPage,
    /// Arcs of circles in place of those of ellipses.
    CircularArcs,
    /// A format that has circular arcs, or curves.
    FormatsOfArcs,
    /// A shape of lines and circular arcs, or a format of curves.
    Arcs,
    /// A drawing that is smaller by this factor.
    Scale(f64),
}
