//! How closely what stands in place of a path follows it.

/// How closely lines or arcs follow what they replace.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearness {
    /// A bound, both ways, of their distance from it.
    pub error: f64,
    /// How far rounding may move them yet within the tolerance.
    pub room: f64,
}

impl Nearness {
    /// Of both.
    #[must_use]
    pub const fn with(self, other: Self) -> Self {
        Self {
            error: self.error.max(other.error),
            room: self.room.min(other.room),
        }
    }
}

/// How closely lines and arcs follow what they replace.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closeness {
    /// How closely the lines do.
    pub lines: Nearness,
    /// How closely the arcs do, whose centres are rounded too.
    pub arcs: Nearness,
}

impl Closeness {
    /// Lines and arcs that are what was given, and may be moved so far.
    #[must_use]
    pub const fn exact(room: f64) -> Self {
        let error = 0.0;
        Self {
            lines: Nearness { error, room },
            arcs: Nearness { error, room },
        }
    }

    /// Of both.
    #[must_use]
    pub const fn with(self, other: Self) -> Self {
        Self {
            lines: self.lines.with(other.lines),
            arcs: self.arcs.with(other.arcs),
        }
    }
}
