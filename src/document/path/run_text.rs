//! The text of arcs in place of runs of Béziers, and of the commands after them.

use core::ops::Range;

use kurbo::Vec2;

use crate::arcs::recognize::Found;
use crate::number::decimal::{After, BelowOne, Decimal};
use crate::number::{decimals_for, decimals_of};
use crate::path_data::Segment;

/// A Bézier of path data.
#[derive(Debug, Clone, Copy)]
pub(in crate::document) struct Link {
    pub(in crate::document) segment: Segment,
    /// The index of the byte after the segment before it.
    pub(in crate::document) previous: usize,
    /// Where it ends.
    pub(in crate::document) to: Vec2,
    /// The most decimals of its numbers that are believed.
    pub(in crate::document) decimals: u8,
}

/// A run of links that becomes one arc.
#[derive(Debug, Clone, Copy)]
pub(in crate::document) struct Run {
    /// Its first link.
    pub(in crate::document) start: usize,
    pub(in crate::document) found: Found,
}

impl Run {
    /// The index of the link after it.
    pub(in crate::document) const fn end(&self) -> usize {
        self.start + self.found.count
    }
}

/// The family of a Bézier command: `c` or `q`; 0 for any other one.
pub(in crate::document) const fn family(kind: u8) -> u8 {
    match kind {
        b'c' | b's' => b'c',
        b'q' | b't' => b'q',
        _ => 0,
    }
}

/// Room for the text of most arcs.
const TEXT: usize = 48;

/// A range of the path data and what stands in its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::document) struct Edit {
    pub(in crate::document) range: Range<usize>,
    pub(in crate::document) text: Vec<u8>,
}

impl Edit {
    /// By how many bytes the text grows.
    fn growth(&self) -> isize {
        self.text.len().cast_signed() - self.range.len().cast_signed()
    }
}

/// A run that becomes an arc, with what becomes of the text up to the next one.
struct Taken {
    edits: [Option<Edit>; 3],
    /// The index of the next run that becomes one; of none that of the end.
    next: usize,
    cost: Cost,
}

/// By how much the text grows from a run on, and minus the number of arcs: the less, the better.
type Cost = (isize, isize);

/// The edits for those runs with which the text is shortest, in their order, and these runs; of texts of one length it is that with the most
/// arcs.
pub(in crate::document) fn edits(
    text: &str,
    links: &[Link],
    runs: &[Run],
) -> (Vec<Edit>, Vec<Run>) {
    // From the last one, so that what follows each is known: what becomes of it, and which of them is the first to be taken from it on.
    let mut taken: Vec<Option<Taken>> = runs.iter().map(|_| None).collect();
    let mut first = vec![runs.len(); runs.len() + 1];
    let cost_of = |taken: &[Option<Taken>], first: usize| {
        let found = taken.get(first).and_then(Option::as_ref);
        found.map_or((0, 0), |found| found.cost)
    };
    for (index, run) in runs.iter().enumerate().rev() {
        let found = arc(text, links, run).and_then(|arc| {
            let next = nexts(runs, index, &first)
                .into_iter()
                .filter(|&next| next == runs.len() || taken[next].is_some());
            let follows = |next: usize| {
                let start = runs.get(next).map_or(links.len(), |run| run.start);
                let follows = after(text, links, run, start)?;
                let (growth, arcs) = cost_of(&taken, next);
                let grown: isize = follows.iter().flatten().map(Edit::growth).sum();
                Some(((growth + grown + arc.growth(), arcs - 1), next, follows))
            };
            let best = next
                .filter_map(follows)
                .min_by_key(|(cost, next, _)| (*cost, *next));
            best.map(|(cost, next, [a, b])| Taken {
                edits: [Some(arc), a, b],
                next,
                cost,
            })
        });
        let without = first[index + 1];
        let is_better = |found: &Taken| found.cost <= cost_of(&taken, without);
        first[index] = if found.as_ref().is_some_and(is_better) {
            index
        } else {
            without
        };
        taken[index] = found;
    }
    let (mut edits, mut chosen, mut at) = (Vec::new(), Vec::new(), first[0]);
    while let Some(found) = taken.get_mut(at).and_then(Option::take) {
        edits.extend(found.edits.into_iter().flatten());
        chosen.push(runs[at]);
        at = found.next;
    }
    (edits, chosen)
}

/// Which runs may be the next one after a run: what follows it depends on whether one of the next two begins there.
fn nexts(runs: &[Run], index: usize, first: &[usize]) -> Vec<usize> {
    let end = runs[index].end() + 1;
    let begins = |next: &usize| runs.get(*next).is_some_and(|run| run.start <= end);
    let mut nexts: Vec<usize> = [index + 1, index + 2].into_iter().filter(begins).collect();
    nexts.push(first[index + 1 + nexts.len()]);
    nexts
}

/// Where the text of a link begins: with what parts it from the segment before, unless its own letter does.
const fn text_start(link: &Link) -> usize {
    if link.segment.explicit {
        link.segment.start
    } else {
        link.previous
    }
}

/// How many characters an arc may take, at most, without its end point in place of one Bézier; a letter for the next one may stand where
/// several characters parted them, and after a run this one would be spelled otherwise.
pub(in crate::document) fn longest(
    text: &str,
    links: &[Link],
    index: usize,
    before: Option<&Run>,
) -> usize {
    let Some(link) = links.get(index) else {
        return 0;
    };
    let parted = match links.get(index + 1) {
        Some(next) if !next.segment.explicit => next.segment.arguments - next.previous,
        _ => 0,
    };
    let spelled = before.and_then(|run| {
        after(text, links, run, links.len())?[0]
            .as_ref()
            .map(Edit::growth)
    });
    let before_end = link.segment.tail - text_start(link);
    let end = usize::from(text.as_bytes().get(link.segment.tail) != Some(&b'-'));
    let longest = (before_end + parted.saturating_sub(1)).saturating_sub(end);
    longest.saturating_add_signed(spelled.unwrap_or(0).max(0))
}

fn arc(text: &str, links: &[Link], run: &Run) -> Option<Edit> {
    let run_links = &links[run.start..run.end()];
    let (first, last) = (run_links.first()?, run_links.last()?);
    let given = &run.found.given;
    let (letter, end) = end_point(text, run_links)?;
    let mut out = Vec::with_capacity(TEXT);
    out.push(letter);
    let mut after = After::Letter;
    for number in [given.radii.x, given.radii.y, given.rotation.degrees()] {
        after.push(
            &mut out,
            Decimal::round(number, u32::from(decimals_of(number))),
            BelowOne::Short,
        );
    }
    for flag in [given.large_arc, given.sweep] {
        after.push_text(&mut out, if flag { b"1" } else { b"0" });
    }
    match end {
        End::Spelled(range) => after.push_text(&mut out, text[range].as_bytes()),
        End::Sum(sum) => sum
            .into_iter()
            .for_each(|number| after.push(&mut out, number, BelowOne::Short)),
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
/// smooth command, unless one of them begins the next run; `None` where a control point has no exact digits.
fn after(text: &str, links: &[Link], run: &Run, next_run: usize) -> Option<[Option<Edit>; 2]> {
    let Some(next) = links.get(run.end()).filter(|_| run.end() != next_run) else {
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
        after.push(&mut out, number, BelowOne::Short);
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
    Decimal::round(value, decimals_for(value, 12))
}

/// The letter of a command that had none of its own.
fn lettered(link: &Link) -> Option<Edit> {
    (!link.segment.explicit).then(|| Edit {
        range: link.previous..link.segment.arguments,
        text: vec![link.segment.letter],
    })
}
