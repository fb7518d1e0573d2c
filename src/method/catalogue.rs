//! The catalogue: what is known of each method, in one table.

use super::Method;
use crate::continuity::Continuity;

/// The degree of a method's curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Degree {
    /// Three control points a piece.
    Quadratic,
    /// Four control points a piece.
    Cubic,
}

/// Where the ends of each piece lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Ends {
    /// On the circle.
    OnCircle,
    /// A little off the circle: for closed shapes with equal segments only.
    OffCircle,
}

/// How the error of a piece falls: the leading term is `constant` times this power of its angle in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// The power.
    pub order: u8,
    /// The factor.
    pub constant: f64,
}

/// What is known of a method.
#[derive(Debug, Clone, Copy)]
pub struct Card {
    /// The name by which it is asked for.
    pub id: &'static str,
    /// Other names for it.
    pub aliases: &'static [&'static str],
    /// A few words.
    pub title: &'static str,
    /// The degree of its curves.
    pub degree: Degree,
    /// Where the ends of each piece lie.
    pub ends: Ends,
    /// How pieces of equal angles join.
    pub continuity_equal: Continuity,
    /// How pieces of different angles join.
    pub continuity_uneven: Continuity,
    /// How the error falls with the angle; `None` for numbers found by trial.
    pub law: Option<Law>,
    /// Its factor as a formula.
    pub leading: &'static str,
    /// The largest angle of one piece, in degrees.
    pub largest_angle: f64,
    /// What singles it out.
    pub criterion: &'static str,
    /// Where it comes from, in two or three words.
    pub origin: &'static str,
    /// Where it comes from: author, title, year; "derived" where it was built from its criterion alone.
    pub source: &'static str,
    /// How its control points are found, in the notation of docs/methods.md.
    pub formula: &'static str,
    /// When to use it.
    pub advice: &'static str,
}

const fn law(order: u8, constant: f64) -> Law {
    Law { order, constant }
}

impl Method {
    /// All methods, in the order of the catalogue.
    pub const ALL: [Self; 28] = [
        Self::Midpoint,
        Self::Minimax,
        Self::Goldapp,
        Self::Curvature,
        Self::Apprich,
        Self::ApprichPlus,
        Self::Area,
        Self::Length,
        Self::Mean,
        Self::MeanAngle,
        Self::Rms,
        Self::Chen1,
        Self::Chen2,
        Self::Chen3,
        Self::LancasterBest,
        Self::LancasterDrawellipse,
        Self::MinimaxG0,
        Self::MinimaxEllipse,
        Self::MinimaxFree,
        Self::MinimaxEllipseFree,
        Self::ApprichScaled,
        Self::CurvatureScaled,
        Self::MinimaxG0Free,
        Self::QuadraticTangent,
        Self::QuadraticMidpoint,
        Self::QuadraticArea,
        Self::QuadraticMinimax,
        Self::QuadraticMinimaxFree,
    ];

    /// What is known of the method.
    #[must_use]
    pub const fn card(self) -> &'static Card {
        &CARDS[self as usize]
    }

    /// The id and the aliases.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        let card = self.card();
        core::iter::once(card.id).chain(card.aliases.iter().copied())
    }
}

/// The ids of the catalogue nearest to a name that it lacks, best first; none where nothing is near.
#[cfg(feature = "cli")]
pub(super) fn nearest(name: &str) -> Vec<&'static str> {
    let name = name.to_lowercase();
    let mut scored: Vec<(f64, &str)> = Method::ALL
        .into_iter()
        .filter_map(|method| {
            let score = method
                .names()
                .map(|known| strsim::jaro_winkler(&name, known))
                .fold(0.0, f64::max);
            (score > 0.75).then_some((score, method.id()))
        })
        .collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0));
    scored.into_iter().take(3).map(|(_, id)| id).collect()
}

/// Only people misspell.
#[cfg(not(feature = "cli"))]
pub(super) fn nearest(_name: &str) -> Vec<&'static str> {
    Vec::new()
}

/// In the order of [`Method`].
static CARDS: [Card; 28] = [
    Card {
        id: "midpoint",
        aliases: &[
            "standard",
            "lancaster-normal",
            "mortenson-1",
            "dokken",
            "riskus",
            "peters",
        ],
        title: "the standard handle",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(6, 1.0 / 55296.0)),
        leading: "1/55296",
        largest_angle: 180.0,
        criterion: "the midpoint lies on the circle",
        origin: "Lancaster 2005",
        source: "Don Lancaster, \"Approximating a Circle or an Ellipse Using Four Bezier Cubic Splines\", 2005 (GuruGram 57), his normal number; Mortenson's first, as Chen 1996 tells it; Dokken et al. 1990, Riskus and Peters are known for it, none of them read here",
        formula: "k = (4/3) tan(a/4)",
        advice: "where others use it too, or where the curve must nowhere lie inside the circle",
    },
    Card {
        id: "minimax",
        aliases: &["mortenson-2", "best", "mortensen-web"],
        title: "the least peak error",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(6, 1.292_633_581_840_6e-5)),
        leading: "w0³/55296 with goldapp's w0",
        largest_angle: 180.0,
        criterion: "the least peak error with both ends and tangents on the circle",
        origin: "Mortenson",
        source: "Mortenson's second, as given by Da-Pan Chen, \"Formulations of composite parametric cubic curves and circle approximations\", 1996; the number .551915024494 of Mortensen's web page is its quarter, the page not read here",
        formula: "k with r_out + r_mid = 2: k(a, w0), 4 w0³ = 27 ρ (1-w0), ρ = (3 - r_mid)/(1 + r_mid)",
        advice: "by default: the least peak error of all cubics with smooth joints and both ends on the circle",
    },
    Card {
        id: "goldapp",
        aliases: &[],
        title: "the least peak of r² - 1",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(6, 1.292_633_581_840_6e-5)),
        leading: "w0³/55296",
        largest_angle: 180.0,
        criterion: "the least peak of |r² - 1|",
        origin: "Goldapp 1991",
        source: "Goldapp, \"Approximation of circular arcs by cubic polynomials\", 1991, as Chen 1996 and Apprich et al. cite it; the closed form is derived",
        formula: "k = k(a, w0), w0 = (3/2)(cbrt(√2+1) - cbrt(√2-1))",
        advice: "where a closed form is wanted: its peak is within 0.02 % of minimax's on a quarter",
    },
    Card {
        id: "curvature",
        aliases: &["de-boor", "maisonobe"],
        title: "the circle's curvature at the ends",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G2,
        law: Some(law(6, 1.0 / 8192.0)),
        leading: "1/8192",
        largest_angle: 180.0,
        criterion: "the curvature at both ends is the circle's",
        origin: "de Boor et al.",
        source: "de Boor, Höllig, Sabin, \"High accuracy geometric Hermite interpolation\", 1987, as Apprich et al. tell it; Maisonobe 2003 is known for it, not read here",
        formula: "k = (sqrt(s² + 6(1-c)) - s)/3",
        advice: "where pieces of different angles must join with continuous curvature",
    },
    Card {
        id: "apprich",
        aliases: &["c4"],
        title: "four times continuously differentiable",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G4,
        continuity_uneven: Continuity::G1,
        law: Some(law(6, 3.0 / 8192.0)),
        leading: "3/8192",
        largest_angle: 120.0,
        criterion: "f''' = 0 at the joints, f the curve as a graph",
        origin: "Apprich et al.",
        source: "Christian Apprich, Anne Dietrich, Klaus Höllig et al., a note on C4 cubic spline approximations of a circle: delta-minus",
        formula: "k = (1-c)/(3s(3+2c)) (2(4+3c) - sqrt(2(5+3c)))",
        advice: "where reflections or accelerations must be smooth: curvature and its first two derivatives are continuous at joints of equal segments",
    },
    Card {
        id: "apprich-plus",
        aliases: &[],
        title: "the other C4 solution",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G4,
        continuity_uneven: Continuity::G1,
        law: Some(law(2, 0.1)),
        leading: "1/10",
        largest_angle: 120.0,
        criterion: "f''' = 0 at the joints, f the curve as a graph",
        origin: "Apprich et al.",
        source: "Christian Apprich, Anne Dietrich, Klaus Höllig et al., a note on C4 cubic spline approximations of a circle: delta-plus",
        formula: "k = (1-c)/(3s(3+2c)) (2(4+3c) + sqrt(2(5+3c)))",
        advice: "never for drawing: it is here because the paper has it, and errs by a third of the radius on a quarter",
    },
    Card {
        id: "area",
        aliases: &[],
        title: "the circle's area",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(6, 1.0 / 57344.0)),
        leading: "1/57344",
        largest_angle: 180.0,
        criterion: "the sector has the area of the circle's",
        origin: "derived",
        source: "derived from its criterion",
        formula: "k = 10(a-s)/(6(1-c) + sqrt(36(1-c)² - 30s(a-s)))",
        advice: "where what is enclosed must be right: cutting, filling, weighing",
    },
    Card {
        id: "length",
        aliases: &[],
        title: "the circle's arc length",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(6, 1.0 / 57344.0)),
        leading: "1/57344",
        largest_angle: 180.0,
        criterion: "the curve has the arc length of the circle's",
        origin: "derived",
        source: "derived from its criterion",
        formula: "k such that the arc length of the curve is a",
        advice: "where the way along the curve must be right: dashes, text on a path, feed rates",
    },
    Card {
        id: "mean",
        aliases: &[],
        title: "the least mean error by parameter",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(6, 1.412_663_810_8e-5)),
        leading: "w0³/55296, w0 = 1-τ², 3τ⁵ - 10τ³ + 15τ = 4",
        largest_angle: 180.0,
        criterion: "the least integral of |r-1| dt",
        origin: "derived",
        source: "derived from its criterion",
        formula: "k with the least ∫ |r-1| dt",
        advice: "where the average stray counts rather than the peak",
    },
    Card {
        id: "mean-angle",
        aliases: &[],
        title: "the least mean error by angle",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(6, 1.412_663_810_8e-5)),
        leading: "w0³/55296 with mean's w0",
        largest_angle: 180.0,
        criterion: "the least integral of |r-1| dθ",
        origin: "derived",
        source: "derived from its criterion",
        formula: "k with the least ∫ |r-1| dθ",
        advice: "where the average stray along the circle counts",
    },
    Card {
        id: "rms",
        aliases: &[],
        title: "the least squares",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(6, 1.358_714_556_022_9e-5)),
        leading: "(4/27)(10/11)³/8192",
        largest_angle: 180.0,
        criterion: "the least integral of (r-1)² dt",
        origin: "derived",
        source: "derived from its criterion",
        formula: "k with the least ∫ (r-1)² dt",
        advice: "where errors add up as squares",
    },
    Card {
        id: "chen-1",
        aliases: &[],
        title: "Formulation I",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G2,
        law: Some(law(4, 1.0 / 384.0)),
        leading: "1/384",
        largest_angle: 120.0,
        criterion: "the C2 spline whose segments all have the parameter 0 to 1",
        origin: "Chen 1996",
        source: "Da-Pan Chen, \"Formulations of composite parametric cubic curves and circle approximations\", 1996: Formulation I",
        formula: "k = s/(2+c) for equal segments of a closed circle; else the cyclic system (11), or fixed ends with the circle's derivatives on an open arc",
        advice: "to reproduce the paper, or the circle of a plain spline program",
    },
    Card {
        id: "chen-2",
        aliases: &[],
        title: "Formulation II",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(4, 1.0 / 384.0)),
        leading: "1/384",
        largest_angle: 180.0,
        criterion: "the parameter is the curve's own arc length",
        origin: "Chen 1996",
        source: "Da-Pan Chen, \"Formulations of composite parametric cubic curves and circle approximations\", 1996: Formulation II",
        formula: "k = t/3 with t = L(t/3), where L(k) is the length of the curve with the handle k",
        advice: "to reproduce the paper",
    },
    Card {
        id: "chen-3",
        aliases: &[],
        title: "Formulation III",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(4, 1.0 / 384.0)),
        leading: "1/384",
        largest_angle: 180.0,
        criterion: "the parameter is the circle's arc length",
        origin: "Chen 1996",
        source: "Da-Pan Chen, \"Formulations of composite parametric cubic curves and circle approximations\", 1996: Formulation III",
        formula: "k = a/3",
        advice: "where the speed at the joints must be the circle's",
    },
    Card {
        id: "lancaster-best",
        aliases: &[],
        title: "Lancaster's best magic numbers",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: None,
        leading: "none: a table",
        largest_angle: 180.0,
        criterion: "his best numbers, found by trial",
        origin: "Lancaster 2005",
        source: "Don Lancaster, \"Approximating a Circle or an Ellipse Using Four Bezier Cubic Splines\", 2005 (GuruGram 57), his table of best numbers",
        formula: "2 segments 1.333333, 3 .7698112, 4 .551784, 5 .433072, 6 .3572045, 8 .2652031",
        advice: "to reproduce the paper; minimax is better at every count",
    },
    Card {
        id: "lancaster-drawellipse",
        aliases: &[],
        title: "the number of his PostScript procedure",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::Apart,
        law: None,
        leading: "none: quarters only",
        largest_angle: 90.0,
        criterion: "the number of his PostScript procedures",
        origin: "Lancaster 2005",
        source: "Don Lancaster, \"Approximating a Circle or an Ellipse Using Four Bezier Cubic Splines\", 2005 (GuruGram 57), his PostScript",
        formula: "k = .55228475 - .00045, quarters only",
        advice: "where output must match his drawellipse and drawcircle",
    },
    Card {
        id: "minimax-g0",
        aliases: &[],
        title: "the least peak error with corners",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G0,
        continuity_uneven: Continuity::G0,
        law: Some(law(6, 4.696_749_625_7e-6)),
        leading: "1/(262144 cos⁶(π/12))",
        largest_angle: 180.0,
        criterion: "the least peak error with both ends on the circle, tangents free",
        origin: "derived",
        source: "derived; the class of Vavpetič & Žagar 2020",
        formula: "|p|² = 1 + R² + 2R T6(λτ), λ = cos(acos(-R/2)/6)",
        advice: "where corners of a fraction of a degree do no harm: a third of minimax's error",
    },
    Card {
        id: "minimax-ellipse",
        aliases: &[],
        title: "the least true distance",
        degree: Degree::Cubic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(6, 1.292_633_581_840_6e-5)),
        leading: "w0³/55296 with goldapp's w0",
        largest_angle: 180.0,
        criterion: "the least peak of the true distance from an ellipse, ends and tangents on it",
        origin: "derived",
        source: "derived from its criterion",
        formula: "two handles and E with distances +E, -E, +E at the three extremes; on a circle minimax",
        advice: "for ellipses: on quarters of a 2:1 ellipse three quarters of minimax's peak, at 10:1 half of it",
    },
    Card {
        id: "minimax-free",
        aliases: &["goldapp-free"],
        title: "midpoint, centred",
        degree: Degree::Cubic,
        ends: Ends::OffCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::Apart,
        law: Some(law(6, 1.0 / 110_592.0)),
        leading: "1/110592",
        largest_angle: 180.0,
        criterion: "the least peak error of all scaled midpoint circles",
        origin: "derived",
        source: "derived from its criterion; Goldapp 1991 has cubics whose ends miss the arc, as Chen 1996 tells, said to balance r² in place of r; not read here",
        formula: "all control points of midpoint times 2/(1 + sqrt(1+E)), E = (4/27) sin⁶(a/4)/cos²(a/4)",
        advice: "for whole circles and ellipses that may miss the quadrant points: two thirds of minimax's error, no corners",
    },
    Card {
        id: "minimax-ellipse-free",
        aliases: &[],
        title: "the least, off the ellipse",
        degree: Degree::Cubic,
        ends: Ends::OffCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::Apart,
        law: Some(law(6, 1.0 / 110_592.0)),
        leading: "1/110592",
        largest_angle: 180.0,
        criterion: "the least peak of the true distance from an ellipse in quarters, the axis points too off it",
        origin: "derived",
        source: "derived from its criterion",
        formula: "distances -E, +E, -E, +E, -E from axis to axis; on a circle minimax-free",
        advice: "for whole ellipses in quarters that may miss the axis points: half of minimax's peak at 2:1",
    },
    Card {
        id: "apprich-scaled",
        aliases: &[],
        title: "the C4 spline, centred",
        degree: Degree::Cubic,
        ends: Ends::OffCircle,
        continuity_equal: Continuity::G4,
        continuity_uneven: Continuity::Apart,
        law: Some(law(6, 3.0 / 16384.0)),
        leading: "3/16384",
        largest_angle: 120.0,
        criterion: "the C4 spline with its error balanced",
        origin: "Apprich et al.",
        source: "Christian Apprich, Anne Dietrich, Klaus Höllig et al., a note on C4 cubic spline approximations of a circle: p-star",
        formula: "all control points of apprich times 2/(1 + sqrt(1-E)), E = (9/32)(c-1)k² - (3/4)ks + (1-c)/2",
        advice: "as apprich, for whole circles that may miss the quadrant points",
    },
    Card {
        id: "curvature-scaled",
        aliases: &[],
        title: "curvature, centred",
        degree: Degree::Cubic,
        ends: Ends::OffCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::Apart,
        law: Some(law(6, 1.0 / 16384.0)),
        leading: "1/16384",
        largest_angle: 180.0,
        criterion: "the curvature handle with its error balanced",
        origin: "derived",
        source: "derived from its criterion",
        formula: "all control points of curvature times 2/(1 + r_mid)",
        advice: "as curvature with half the error, for whole circles that may miss the quadrant points",
    },
    Card {
        id: "minimax-g0-free",
        aliases: &["rababah"],
        title: "the least peak error of all cubics",
        degree: Degree::Cubic,
        ends: Ends::OffCircle,
        continuity_equal: Continuity::G0,
        continuity_uneven: Continuity::Apart,
        law: Some(law(6, 1.0 / 262_144.0)),
        leading: "2^-18",
        largest_angle: 180.0,
        criterion: "the least peak error of all symmetric cubics",
        origin: "derived",
        source: "derived from its criterion; the best uniform cubic of Rababah 2016, which Apprich et al. cite, is said to balance r² in place of r and so to differ in the last digits; not read here",
        formula: "|p|² = 1 + R² + 2R T6(2t-1)",
        advice: "to know how far a cubic can get; it has corners and misses the quadrant points",
    },
    Card {
        id: "quadratic-tangent",
        aliases: &["hollig-koch"],
        title: "the tangents' crossing",
        degree: Degree::Quadratic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G2,
        continuity_uneven: Continuity::G1,
        law: Some(law(4, 1.0 / 128.0)),
        leading: "1/128",
        largest_angle: 175.0,
        criterion: "the tangents are the circle's",
        origin: "derived",
        source: "derived from its criterion; on a circle Höllig and Koch's is this one, not read here",
        formula: "P1 at radius 1/cos h on the bisector",
        advice: "for quadratics without corners; the curve lies nowhere inside the circle",
    },
    Card {
        id: "quadratic-midpoint",
        aliases: &[],
        title: "the midpoint on the circle",
        degree: Degree::Quadratic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G0,
        continuity_uneven: Continuity::G0,
        law: Some(law(4, 1.0 / 512.0)),
        leading: "1/512",
        largest_angle: 180.0,
        criterion: "the midpoint lies on the circle",
        origin: "derived",
        source: "derived from its criterion",
        formula: "P1 at radius 2 - cos h on the bisector",
        advice: "for quadratics that must nowhere lie outside the circle",
    },
    Card {
        id: "quadratic-area",
        aliases: &[],
        title: "the circle's area",
        degree: Degree::Quadratic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G0,
        continuity_uneven: Continuity::G0,
        law: Some(law(4, 1.0 / 640.0)),
        leading: "1/640",
        largest_angle: 180.0,
        criterion: "the sector has the area of the circle's",
        origin: "derived",
        source: "derived from its criterion",
        formula: "P1 at radius (3a - s)/(4 sin h) on the bisector",
        advice: "for quadratics that enclose the right area",
    },
    Card {
        id: "quadratic-minimax",
        aliases: &[],
        title: "the least peak error of a quadratic",
        degree: Degree::Quadratic,
        ends: Ends::OnCircle,
        continuity_equal: Continuity::G0,
        continuity_uneven: Continuity::G0,
        law: Some(law(4, 1.340_413_087_9e-3)),
        leading: "1/(1024 cos⁴(π/8))",
        largest_angle: 180.0,
        criterion: "the least peak error with both ends on the circle",
        origin: "derived",
        source: "derived from its criterion",
        formula: "P1 at the radius m for which (cos h + m)/2 - 1 = 1 - sqrt(1 - B²/(4A))",
        advice: "for TrueType and other quadratic formats: a sixth to an eighth of quadratic-tangent's error, with corners",
    },
    Card {
        id: "quadratic-minimax-free",
        aliases: &[],
        title: "the least peak error of all quadratics",
        degree: Degree::Quadratic,
        ends: Ends::OffCircle,
        continuity_equal: Continuity::G0,
        continuity_uneven: Continuity::Apart,
        law: Some(law(4, 1.0 / 1024.0)),
        leading: "1/1024",
        largest_angle: 180.0,
        criterion: "the least peak error of all symmetric quadratics",
        origin: "derived",
        source: "derived from its criterion; the abstract of Rababah, \"The best uniform quadratic approximation of circular arcs with high accuracy\", 2016, which was read, has an error that is a Chebyshev polynomial of degree 4, 5.5e-3 on a quarter; the paper was not read",
        formula: "|p|² = 1 + R² + 2R T4(2t-1), R = q², tan h (1 - 4q + q²) = (1-q) sqrt(8q)",
        advice: "for whole circles in quadratics: the best of them",
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_has_its_own_card_and_names() {
        let mut names: Vec<&str> = Method::ALL.into_iter().flat_map(Method::names).collect();
        for method in Method::ALL {
            assert_eq!(method.id().parse::<Method>().unwrap(), method);
            assert_eq!(Method::ALL[method as usize], method);
        }
        names.sort_unstable();
        let count = names.len();
        names.dedup();
        assert_eq!(names.len(), count);
    }

    #[test]
    fn names_that_users_look_for_are_known() {
        for (name, method) in [
            ("maisonobe", Method::Curvature),
            ("dokken", Method::Midpoint),
            ("riskus", Method::Midpoint),
            ("peters", Method::Midpoint),
            ("mortensen-web", Method::Minimax),
            ("hollig-koch", Method::QuadraticTangent),
            ("goldapp-free", Method::MinimaxFree),
            ("rababah", Method::MinimaxG0Free),
        ] {
            assert_eq!(name.parse::<Method>().unwrap(), method);
        }
        // The number of the web page, to its last digit.
        let quarter = Method::Minimax
            .piece(&super::super::Span::from_degrees(90.0))
            .unwrap();
        assert!((quarter.handle.y - 0.551_915_024_494).abs() < 5e-13);
    }

    #[test]
    fn near_names_are_offered() {
        assert_eq!(nearest("minmax")[0], "minimax");
        assert_eq!(nearest("midpont")[0], "midpoint");
        assert!(nearest("xyzzy").is_empty());
    }
}
