//! Tables for people: without rules, and without blanks at the ends of their lines.

use std::io::{self, IsTerminal as _};

use comfy_table::{CellAlignment, ContentArrangement, Table, presets};

/// The width of prose: longer lines are hard to read, and a pipe has no width of its own.
pub(super) const PROSE: u16 = 100;

/// A table as wide as it becomes.
pub(super) fn plain() -> Table {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    table
}

/// A table whose cells are wrapped where it would be wider than this.
pub(super) fn wrapped(width: u16) -> Table {
    let mut table = plain();
    table
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_width(width);
    table
}

/// The width of the terminal, or what `COLUMNS` says of it, as far as this one. A file is the same on every terminal.
pub(super) fn width(widest: u16) -> u16 {
    if !io::stdout().is_terminal() {
        return PROSE;
    }
    let told = std::env::var("COLUMNS").ok();
    let told = told.and_then(|columns| columns.parse().ok());
    let width = told.or_else(|| Table::new().width());
    width.unwrap_or(PROSE).clamp(60, widest)
}

/// Sets this many blanks between columns, and these columns to the right.
pub(super) fn close_up(table: &mut Table, gap: u16, right: &[usize]) {
    for (i, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, gap));
        if right.contains(&i) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
}

/// The lines of a table, each after an indent.
pub(super) fn lines(table: &Table, indent: &str) -> String {
    let line = |line: String| match line.trim_end() {
        "" => "\n".to_owned(),
        text => format!("{indent}{text}\n"),
    };
    table.lines().map(line).collect()
}
