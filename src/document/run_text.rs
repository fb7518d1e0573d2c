//! The text of arcs in place of runs of Béziers, and of the commands after them.

use core::ops::Range;

use kurbo::Vec2;

use super::path_data::Segment;
use crate::arcs::recognize::Found;
use crate::number::decimal::{After, Decimal, Form};
use crate::number::decimals_of;

/// A Bézier of path data.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    pub(super) segment: Segment,
    /// The index of the byte after the segment before it.
    pub(super) previous: usize,
    /// Where it ends.
    pub(super) to: Vec2,
}

/// A run of links that becomes one arc.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    /// Its first link.
    pub(super) start: usize,
    pub(super) found: Found,
}

impl Run {
    /// The index of the link after it.
    pub(super) const fn end(&self) -> usize {
        self.start + self.found.count
    }
}

/// The family of a Bézier command: `c` or `q`; 0 for any other one.
pub(super) const fn family(kind: u8) -> u8 {
    match kind {
        b'c' | b's' => b'c',
        b'q' | b't' => b'q',
        _ => 0,
    }
}

/// A range of the path data and what stands in its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Edit {
    pub(super) range: Range<usize>,
    pub(super) text: Vec<u8>,
}

impl Edit {
    /// By how many bytes the text grows.
    fn growth(&self) -> isize {
        self.text.len().cast_signed() - self.range.len().cast_signed()
    }
}

/// The edits for those runs that do not grow the text, in their order, and these runs.
pub(super) fn edits(text: &str, links: &[Link], runs: &[Run]) -> (Vec<Edit>, Vec<Run>) {
    let (mut edits, mut taken) = (Vec::new(), Vec::new());
    // From the last one, so that what follows each is known.
    let mut next = links.len();
    for run in runs.iter().rev() {
        let Some(arc) = arc(text, links, run) else {
            continue;
        };
        let follows = if run.end() == next {
            Some([None, None])
        } else {
            after(text, links, run, next)
        };
        let Some(follows) = follows else {
            continue;
        };
        let growth: isize = follows.iter().flatten().map(Edit::growth).sum();
        if arc.growth() + growth <= 0 {
            edits.extend(follows.into_iter().flatten().rev());
            edits.push(arc);
            taken.push(*run);
            next = run.start;
        }
    }
    edits.reverse();
    taken.reverse();
    (edits, taken)
}

/// Where the text of a link begins: with what parts it from the segment before, unless its own letter does.
const fn text_start(link: &Link) -> usize {
    if link.segment.explicit {
        link.segment.start
    } else {
        link.previous
    }
}

/// How many characters an arc may take, at most, without its end point in place of the first of these Béziers; a letter for the next one may
/// stand where several characters parted them.
pub(super) fn longest(links: &[Link]) -> usize {
    let [link, rest @ ..] = links else {
        return 0;
    };
    let parted = match rest {
        [next, ..] if !next.segment.explicit => next.segment.arguments - next.previous,
        _ => 0,
    };
    link.segment.tail - text_start(link) + parted.saturating_sub(1)
}

fn arc(text: &str, links: &[Link], run: &Run) -> Option<Edit> {
    let run_links = &links[run.start..run.end()];
    let (first, last) = (run_links.first()?, run_links.last()?);
    let given = &run.found.given;
    let (letter, end) = end_point(text, run_links)?;
    let mut out = vec![letter];
    let mut after = After::Letter;
    for number in [given.radii.x, given.radii.y, given.rotation.degrees()] {
        after.push(
            &mut out,
            Decimal::round(number, u32::from(decimals_of(number))),
            Form::Short,
        );
    }
    for flag in [given.large_arc, given.sweep] {
        after.push_text(&mut out, if flag { b"1" } else { b"0" });
    }
    match end {
        End::Spelled(range) => after.push_text(&mut out, text[range].as_bytes()),
        End::Sum(sum) => sum
            .into_iter()
            .for_each(|number| after.push(&mut out, number, Form::Short)),
    }
    Some(Edit {
        range: text_start(first)..last.segment.end,
        text: out,
    })
}

/// The end point of an arc.
enum End {
    /// As the file spells it.
    Spelled(Range<usize>),
    /// The exact sum of what the file spells.
    Sum([Decimal; 2]),
}

/// The letter of an arc and its end point: that of the run's last absolute one, and the relative ones after it.
fn end_point(text: &str, run: &[Link]) -> Option<(u8, End)> {
    let last = run.last()?;
    let absolute = run.iter().rposition(|link| !link.segment.is_relative());
    let letter = if absolute.is_some() { b'A' } else { b'a' };
    if absolute == Some(run.len() - 1) || run.len() == 1 {
        return Some((letter, End::Spelled(last.segment.tail..last.segment.end)));
    }
    let mut sum = [Decimal::ZERO; 2];
    for link in &run[absolute.unwrap_or(0)..] {
        let [.., end] = points(text, link)?;
        sum = [sum[0].plus(end[0]), sum[1].plus(end[1])];
    }
    Some((letter, End::Sum(sum)))
}

/// The last two points of a link as the file spells them; of a `t` or a `T`, which has one, that one twice.
fn points(text: &str, link: &Link) -> Option<[[Decimal; 2]; 2]> {
    let mut numbers = [Decimal::ZERO; 6];
    let mut count = 0;
    for (place, number) in numbers.iter_mut().zip(link.segment.numbers(text)) {
        *place = Decimal::read(number)?;
        count += 1;
    }
    let point = |end: usize| Some([*numbers.get(end.checked_sub(2)?)?, *numbers.get(end - 1)?]);
    let end = point(count)?;
    Some([point(count - 2).unwrap_or(end), end])
}

/// What has to be written after a run: a smooth command is spelled out, a repetition gets its letter, and so does one of the
/// smooth command, unless it begins the `next` run; `None` where a control point has no exact digits.
fn after(text: &str, links: &[Link], run: &Run, next_run: usize) -> Option<[Option<Edit>; 2]> {
    let Some(next) = links.get(run.end()) else {
        return Some([None, None]);
    };
    let last = links.get(run.end() - 1)?;
    let segment = &next.segment;
    let same = family(segment.kind()) == family(last.segment.kind());
    if !(matches!(segment.kind(), b's' | b't') && same) {
        // It reflects nothing, before and after.
        return Some([lettered(next), None]);
    }
    if last.segment.kind() == b't' {
        return None;
    }
    let full = family(segment.kind());
    let mut out = vec![if segment.is_relative() {
        full
    } else {
        full.to_ascii_uppercase()
    }];
    let [control, end] = points(text, last)?;
    let mut after = After::Letter;
    for axis in 0..2 {
        let way = end[axis].minus(control[axis]);
        let number = if segment.is_relative() {
            way
        } else if last.segment.is_relative() {
            absolute([last.to.x, last.to.y][axis] + way.value())
        } else {
            end[axis].plus(way)
        };
        after.push(&mut out, number, Form::Short);
    }
    after.part(&mut out, &text.as_bytes()[segment.arguments..]);
    let spelled = Edit {
        range: text_start(next)..segment.arguments,
        text: out,
    };
    let repeated = links
        .get(run.end() + 1)
        .filter(|_| run.end() + 1 != next_run);
    Some([Some(spelled), repeated.and_then(lettered)])
}

/// A coordinate that no number of the file spells.
fn absolute(value: f64) -> Decimal {
    let decimals = 12 - libm::log10(value.abs().max(1e-9)).ceil() as i32;
    Decimal::round(value, decimals.max(0).unsigned_abs())
}

/// The letter of a command that had none of its own.
fn lettered(link: &Link) -> Option<Edit> {
    (!link.segment.explicit).then(|| Edit {
        range: link.previous..link.segment.arguments,
        text: vec![link.segment.letter],
    })
}
