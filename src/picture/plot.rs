//! Plots: a quantity along curves, and the error of methods by the number of segments.

mod palette;
mod picture;
mod scale;
mod sheet;
mod text;

use std::path::Path;

use kurbo::Vec2;

use crate::compare::Comparison;
use crate::curve::Curve;
use crate::error::{Error, Result};
use crate::measure::{Quantity, Reference, profile};
use picture::Pen;
use scale::Kind;
use sheet::LABEL_STEP;

/// The size at which a plot is laid out where none was asked for.
const LAYOUT: [f64; 2] = [800.0, 500.0];

/// How much larger than its layout a PNG is where no size was asked for, so that it can be printed.
const SHARPNESS: f64 = 2.0;

/// More joints than this are not marked.
const MOST_MARKED_JOINTS: usize = 36;

/// The form of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PictureFormat {
    /// An SVG document.
    Svg,
    /// Pixels.
    Png,
}

impl PictureFormat {
    /// The form that the extension of a file tells.
    ///
    /// # Errors
    ///
    /// Where it is neither `.svg` nor `.png`.
    pub fn of_file(file: &Path) -> Result<Self> {
        let extension = file
            .extension()
            .and_then(|e| e.to_str())
            .map(str::to_ascii_lowercase);
        match extension.as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(Error::Picture(format!(
                "a plot is a .svg or a .png file, and '{}' is neither",
                file.display()
            ))),
        }
    }
}

/// A line of a chart.
#[derive(Debug, Clone, PartialEq)]
struct Series {
    name: String,
    pen: Pen,
    /// Its parts, between which it is not joined.
    parts: Vec<Vec<(f64, f64)>>,
    /// Whether each of its points is marked.
    dots: bool,
}

impl Series {
    fn points(&self) -> impl Iterator<Item = &(f64, f64)> {
        self.parts.iter().flatten()
    }
}

/// Where the names of the lines stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Names {
    /// Above the plot.
    Legend,
    /// At the right end of each line.
    AtEnds,
}

/// A chart, ready to be drawn at any size.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    title: String,
    x_title: String,
    y_title: String,
    x_kind: Kind,
    y_kind: Kind,
    series: Vec<Series>,
    /// Marked x values: the joints.
    marks: Vec<f64>,
    names: Names,
}

impl Chart {
    /// The quantity along curves, each named, over the angle about the centre.
    #[must_use]
    pub fn along(title: &str, quantity: Quantity, curves: &[(&str, &Curve, &Reference)]) -> Self {
        let mut marks: Vec<f64> = Vec::new();
        let series = curves
            .iter()
            .enumerate()
            .map(|(i, (name, curve, reference))| {
                let steps = (3000 / curve.segments.len().max(1)).clamp(8, 160) as u32;
                let parts = profile::along(curve, reference, quantity, steps);
                for part in &parts {
                    let ends = [part.first(), part.last()].into_iter().flatten();
                    marks.extend(ends.map(|&(angle, _)| angle));
                }
                Series {
                    name: (*name).to_owned(),
                    pen: palette::line(i),
                    parts,
                    dots: false,
                }
            });
        let series = series.collect();
        marks.sort_by(f64::total_cmp);
        marks.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
        if marks.len() > MOST_MARKED_JOINTS {
            marks.clear();
        }
        Self {
            title: title.to_owned(),
            x_title: "angle about the centre (degrees)".to_owned(),
            y_title: quantity.label().to_owned(),
            x_kind: Kind::Degrees,
            y_kind: Kind::Linear,
            series,
            marks,
            names: Names::Legend,
        }
    }

    /// The error of methods by the number of segments, both axes logarithmic. Errors of 0 are not shown.
    #[must_use]
    pub fn comparison(comparison: &Comparison) -> Self {
        let series = comparison.rows.iter().map(|row| {
            let points = comparison.counts.iter().zip(&row.values);
            let points = points.filter_map(|(&n, value)| Some((n as f64, (*value)?)));
            Series {
                name: row.rule.id().to_owned(),
                pen: palette::family_line(row.rule.method().unwrap_or_default()),
                parts: vec![points.filter(|&(_, value)| value > 0.0).collect()],
                dots: true,
            }
        });
        Self {
            title: format!(
                "A full circle of radius 1: {} by the number of segments",
                comparison.by.title()
            ),
            x_title: "segments".to_owned(),
            y_title: comparison.by.label().to_owned(),
            x_kind: Kind::Counts(comparison.counts.clone()),
            y_kind: Kind::Log,
            series: series.filter(|s| s.points().count() > 0).collect(),
            marks: Vec::new(),
            names: Names::AtEnds,
        }
    }

    /// The picture's bytes at a size in pixels, or at the default one.
    ///
    /// # Errors
    ///
    /// Where the picture is too large to be made.
    pub fn picture(&self, format: PictureFormat, size: Option<[f64; 2]>) -> Result<Vec<u8>> {
        let size = size.map(|[w, h]| Vec2::new(w, h));
        let default = self.default_size();
        match format {
            PictureFormat::Svg => Ok(sheet::picture(self, size.unwrap_or(default))
                .svg()
                .into_bytes()),
            PictureFormat::Png => {
                let pixels = size.unwrap_or(default * SHARPNESS);
                let scale = (pixels.x / default.x).min(pixels.y / default.y).max(1.0);
                sheet::picture(self, pixels / scale).png(scale)
            }
        }
    }

    fn default_size(&self) -> Vec2 {
        let [width, height] = LAYOUT;
        match self.names {
            Names::Legend => Vec2::new(width, height),
            // Room for a line of words for each series.
            Names::AtEnds => Vec2::new(
                width,
                height.max(120.0 + 1.25 * LABEL_STEP * self.series.len() as f64),
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plots_are_well_formed_at_any_size() {
        let comparison = Comparison::new(
            &crate::Method::ALL.map(crate::Rule::Method),
            &[2, 3, 4, 8],
            crate::compare::Criterion::Peak,
        )
        .unwrap();
        let chart = Chart::comparison(&comparison);
        for size in [None, Some([20.0, 20.0]), Some([3000.0, 700.0])] {
            let svg = chart.picture(PictureFormat::Svg, size).unwrap();
            let svg = String::from_utf8(svg).unwrap();
            assert!(!svg.contains("NaN") && !svg.contains("inf"));
            assert_eq!(svg.matches("<text").count(), svg.matches("</text>").count());
            let png = chart.picture(PictureFormat::Png, size).unwrap();
            assert!(png.starts_with(b"\x89PNG"));
        }
        assert!(chart.picture(PictureFormat::Png, Some([1e6, 1e6])).is_err());
    }
}
