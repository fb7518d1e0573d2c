//! Joints whose largest error is least where a longer segment may err less than a shorter one: beside the sharp ends of a flat ellipse.
//!
//! Marching finds no such joints, since a segment that ends early may spare the next one a sharp end. So the joints are a path through
//! places on a grid whose worst step is least (Bellman's recursion over their number), and then through places beside those, ever nearer.

use core::cell::RefCell;

use super::{BARE, Balance, GRID, Joints};

/// A sharp end that is wider than this part of a segment (its width as an angle being the ratio of the radii) leaves no such joints.
const WIDE: f64 = 1.0 / 60.0;

/// The most segments whose joints are looked for so, and the shortest, in degrees, for which the places of half a turn are few.
const MOST: usize = 40;
const SHORTEST: f64 = 3.0;

/// How many places a segment passes on the grid, nearly, and how many a quarter has at least.
const PER_SEGMENT: f64 = 12.0;
const PER_QUARTER: f64 = 24.0;

/// How far beyond what is allowed, as a multiple, joints on every other place of the grid may err, and on all of them, that others beside them
/// may bring within.
const PROMISING: [f64; 2] = [2.0, 1.4];

/// Where a joint may move, in units of how far: by half as far each time, down to such a part of a segment.
const BESIDE: [f64; 5] = [-1.0, -0.5, 0.0, 0.5, 1.0];
const NEAREST: f64 = 1e-5;

/// A part of an arc from its start on, and how many joints it has inside.
#[derive(Clone, Copy)]
struct Prefix {
    end: f64,
    joints: usize,
    /// Whether its last segment goes on beyond the end for as long.
    is_astride: bool,
    /// The longest segment, in degrees.
    longest: f64,
}

impl Prefix {
    /// The path through one place of each layer whose worst step is least.
    fn through(self, layers: &[Vec<f64>], error: impl Fn(f64, f64) -> f64) -> Option<Path> {
        // The places of a layer with the least worst step to each, and for all layers the place before.
        let mut reached = vec![(0.0, 0.0_f64)];
        let mut before: Vec<Vec<usize>> = Vec::with_capacity(layers.len());
        for (i, layer) in layers.iter().enumerate() {
            let is_astride = self.is_astride && i == self.joints;
            let times = if is_astride { 2.0 } else { 1.0 };
            let least = |&way: &f64| {
                let mut least = (0, f64::INFINITY);
                for (place, &(start, worst)) in reached.iter().enumerate() {
                    let size = times * (way - start);
                    if worst < least.1 && size > 0.0 && size <= self.longest {
                        let worst = worst.max(error(start, size));
                        if worst < least.1 {
                            least = (place, worst);
                        }
                    }
                }
                least
            };
            let (places, worst): (Vec<usize>, Vec<f64>) = layer.iter().map(least).unzip();
            reached = layer.iter().copied().zip(worst).collect();
            before.push(places);
        }
        let most = reached.first()?.1;
        let mut ways = Vec::with_capacity(layers.len() + 1);
        let mut place = 0;
        for (layer, before) in layers.iter().zip(&before).rev() {
            ways.push(layer[place]);
            place = before[place];
        }
        ways.push(0.0);
        ways.reverse();
        most.is_finite().then_some(Path { ways, most })
    }
}

/// The ways to joints, both ends of the part included, and the largest error between them, over the larger radius.
struct Path {
    ways: Vec<f64>,
    most: f64,
}

/// The errors of segments between places on a grid that has the axes, those of mirror images once.
struct Grid<'a> {
    balance: &'a Balance,
    step: f64,
    /// How many places half a turn has, and how many the longest segment passes.
    half: i64,
    longest: i64,
    known: RefCell<Vec<f64>>,
}

impl<'a> Grid<'a> {
    fn new(balance: &'a Balance, segment: f64, longest: f64) -> Self {
        let quarter = (90.0 * PER_SEGMENT / segment).max(PER_QUARTER).ceil();
        let step = 90.0 / quarter;
        let (half, longest) = (2 * quarter as i64, (longest / step) as i64);
        Self {
            balance,
            step,
            half,
            longest,
            known: RefCell::new(vec![f64::NAN; (half * (longest + 1)) as usize]),
        }
    }

    /// Every so many of the places between the start and this way.
    fn places(&self, every: f64, end: f64) -> Vec<f64> {
        let step = every * self.step;
        let start = self.balance.past_axis(0.0) / step;
        let first = start.floor() + 1.0 - start;
        let places = (0..).map(|i| (first + f64::from(i)) * step);
        places.take_while(|&way| way < end).collect()
    }

    fn error(&self, way: f64, size: f64) -> f64 {
        let [from, length] = [self.balance.past_axis(way), size].map(|angle| angle / self.step);
        let is_place = |number: f64| (number - number.round()).abs() < 1e-9;
        let (start, length_in_steps) = (from.round() as i64, length.round() as i64);
        if !is_place(from) || !is_place(length) || length_in_steps > self.longest {
            return self.balance.error(way, size);
        }
        let mirrored = -start - length_in_steps;
        let from = start
            .rem_euclid(self.half)
            .min(mirrored.rem_euclid(self.half));
        let at = (from * (self.longest + 1) + length_in_steps) as usize;
        let known = self.known.borrow()[at];
        if !known.is_nan() {
            return known;
        }
        let error = self.balance.error(way, size);
        self.known.borrow_mut()[at] = error;
        error
    }
}

impl Balance {
    /// Joints of this many segments whose largest error is the least, where marching may miss them and they may be within `allowed`, over
    /// the larger radius: such as mirror one another, and others that err far less or, where an error is allowed, less at all.
    pub(crate) fn leaping(&self, count: usize, allowed: f64) -> impl Iterator<Item = Joints> {
        let segment = self.computed(false) / count as f64;
        let is_sharp = self.lobes.short < WIDE * segment.to_radians();
        let serves = is_sharp && segment >= SHORTEST && (2..=MOST).contains(&count);
        let even = serves.then(|| self.even(count, allowed)).flatten();
        let times = if allowed.is_finite() { 1.0 } else { BARE };
        let enough = even
            .as_ref()
            .map_or(f64::INFINITY, |even| even.most / times);
        let any = move || self.least_worst(self.computed(false), count, false, allowed);
        let any = serves.then_some(any).into_iter().filter_map(|any| any());
        even.into_iter()
            .chain(any.filter(move |any| any.most < enough))
            .map(|path| Joints::after(&self.arc, &path.ways))
    }

    /// Such joints that mirror one another, where the shape does.
    fn even(&self, count: usize, allowed: f64) -> Option<Path> {
        let mirrored = self.mirrors() && count.is_multiple_of(2);
        let whole = self.computed(mirrored);
        let middle = whole.copysign(self.arc.sweep.degrees()) / 2.0;
        let is_even = self.on_axis(self.arc.start.degrees() + middle);
        if !mirrored {
            return is_even.then(|| self.least_worst(whole, count, true, allowed))?;
        }
        let mut half = self.least_worst(whole, count / 2, is_even, allowed)?;
        add_images(&mut half.ways, 2.0 * whole, 1);
        Some(half)
    }

    /// Joints of the least largest error, such as mirror one another where `is_even`; `None` where that is far beyond `allowed`.
    fn least_worst(&self, whole: f64, pieces: usize, is_even: bool, allowed: f64) -> Option<Path> {
        let longest = self.longest_within(PROMISING[0] * allowed).min(whole);
        if longest * (pieces as f64) < whole {
            return None;
        }
        let is_odd = !pieces.is_multiple_of(2);
        let part = if is_even {
            Prefix {
                end: whole / 2.0,
                joints: (pieces - 1) / 2,
                is_astride: is_odd,
                longest,
            }
        } else {
            Prefix {
                end: whole,
                joints: pieces - 1,
                is_astride: false,
                longest,
            }
        };
        let mut path = self.path(part, whole / pieces as f64, allowed)?;
        let ways = &mut path.ways;
        for way in &mut ways[1..=part.joints] {
            *way = (*way / GRID).round() * GRID;
        }
        if is_even && is_odd {
            ways.pop();
        }
        if is_even {
            add_images(ways, whole, usize::from(!is_odd));
        }
        Some(path)
    }

    /// A length beyond which no segment is within an error, over the larger radius.
    pub(crate) fn longest_within(&self, allowed: f64) -> f64 {
        if self.errors.sees_ellipse() || !allowed.is_finite() {
            return self.largest_angle;
        }
        self.sizes(allowed)[1]
    }

    fn path(&self, part: Prefix, segment: f64, allowed: f64) -> Option<Path> {
        let grid = Grid::new(self, segment, part.longest);
        let on_every = |every: f64, times: f64| {
            let mut layers = vec![grid.places(every, part.end); part.joints];
            layers.push(vec![part.end]);
            let path = part.through(&layers, |way, size| grid.error(way, size));
            path.filter(|path| path.most <= times * allowed)
        };
        // Half of the places tell mostly that none do.
        on_every(2.0, PROMISING[0])?;
        let mut path = on_every(1.0, PROMISING[1])?;
        let mut layers = vec![vec![part.end]; part.joints + 1];
        let mut far = grid.step / 2.0;
        while far > NEAREST * segment {
            for (layer, way) in layers.iter_mut().zip(&path.ways[1..]).take(part.joints) {
                *layer = BESIDE.iter().map(|times| way + times * far).collect();
            }
            let nearer = part.through(&layers, |way, size| self.error(way, size));
            path = nearer
                .filter(|nearer| nearer.most < path.most)
                .unwrap_or(path);
            far /= 2.0;
        }
        Some(path)
    }
}

/// Goes on with the mirror images of joints, the last `own` of which have none, up to the whole way.
pub(super) fn add_images(ways: &mut Vec<f64>, whole: f64, own: usize) {
    for i in (0..ways.len() - own).rev() {
        ways.push(whole - ways[i]);
    }
}
