//! Pictures as numbers, to be compared.

use resvg::tiny_skia::Pixmap;

/// A picture as levels from 0 to 255, three a pixel.
pub(crate) struct Picture {
    width: usize,
    levels: Vec<f64>,
}

impl Picture {
    pub(crate) fn new(pixmap: &Pixmap) -> Self {
        let levels = pixmap
            .pixels()
            .iter()
            .flat_map(|c| [c.red(), c.green(), c.blue()].map(f64::from))
            .collect();
        Self {
            width: pixmap.width() as usize,
            levels,
        }
    }

    fn height(&self) -> usize {
        self.levels.len() / 3 / self.width
    }

    /// The picture at so many times fewer pixels on each side, each the mean of those that it stands for.
    pub(crate) fn reduced(&self, factor: usize) -> Self {
        let (width, height) = (self.width / factor, self.height() / factor);
        let mut levels = vec![0.0; 3 * width * height];
        for y in 0..height * factor {
            for x in 0..width * factor {
                for c in 0..3 {
                    levels[3 * (y / factor * width + x / factor) + c] +=
                        self.levels[3 * (y * self.width + x) + c] / (factor * factor) as f64;
                }
            }
        }
        Self { width, levels }
    }

    pub(crate) fn upside_down(&self) -> Self {
        let rows = self.levels.chunks(3 * self.width).rev();
        Self {
            width: self.width,
            levels: rows.flatten().copied().collect(),
        }
    }

    /// How far the pictures differ, in levels: the most, and the mean over what is not white in both.
    pub(crate) fn difference(&self, other: &Self) -> (f64, f64) {
        assert_eq!(
            (self.width, self.levels.len()),
            (other.width, other.levels.len()),
            "the pictures have different sizes"
        );
        let (mut most, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
        for (a, b) in self.levels.iter().zip(&other.levels) {
            if *a < 255.0 || *b < 255.0 {
                most = most.max((a - b).abs());
                sum += (a - b).abs();
                count += 1.0;
            }
        }
        assert!(count > 0.0, "both pictures are empty");
        (most, sum / count)
    }
}
