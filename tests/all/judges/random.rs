//! Random numbers, and documents, path data and lines: well-formed ones, and ones with a few bytes damaged.

use std::path::Path;
use std::sync::OnceLock;

use proptest::prelude::*;
use proptest::sample::Index;

/// A number from 0 to 1, the same ones on every run.
pub(crate) fn uniform(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

/// A source of random numbers.
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn within(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * uniform(&mut self.0)
    }

    pub(crate) fn logarithmic(&mut self, from: f64, to: f64) -> f64 {
        self.within(from.ln(), to.ln()).exp()
    }

    pub(crate) fn point(&mut self, size: f64) -> curveto::kurbo::Point {
        curveto::kurbo::Point::new(self.within(-size, size), self.within(-size, size))
    }

    pub(crate) fn coin(&mut self) -> bool {
        uniform(&mut self.0) < 0.5
    }
}

fn pick(list: &[&'static str]) -> impl Strategy<Value = &'static str> + use<> {
    prop::sample::select(list.to_vec())
}

/// A number as people and programs spell it.
pub(crate) fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        (-99_i32..100).prop_map(|n| n.to_string()),
        (-9999_i32..10000).prop_map(|n| format!("{}", f64::from(n) / 100.0)),
        (0_u32..100).prop_map(|n| format!(".{n}")),
        Just("1e1".to_owned()),
        Just("-0".to_owned()),
        Just("+3.50".to_owned()),
    ]
}

/// One command of path data with its numbers in many spellings.
pub(crate) fn command() -> impl Strategy<Value = String> {
    let separator = || prop_oneof![Just(" "), Just(","), Just(" , "), Just("\n")];
    let numbers = |count: usize| {
        (prop::collection::vec((number(), separator()), count)).prop_map(|list| {
            list.into_iter()
                .fold(String::new(), |text, (number, separator)| {
                    text + separator + &number
                })[..]
                .trim_start_matches([' ', ',', '\n'])
                .to_owned()
        })
    };
    let flag = || prop_oneof![Just('0'), Just('1')];
    let arc = (numbers(3), flag(), flag(), numbers(2), separator())
        .prop_map(|(radii, a, b, end, s)| format!("{radii}{s}{a}{b}{end}"));
    prop_oneof![
        4 => (prop_oneof![Just('a'), Just('A')], prop::collection::vec(arc, 1..4)).prop_map(|(letter, arcs)| format!("{letter}{}", arcs.join(" "))),
        1 => (prop_oneof![Just('m'), Just('M'), Just('l'), Just('L'), Just('t'), Just('T')], numbers(2)).prop_map(|(c, n)| format!("{c}{n}")),
        1 => (prop_oneof![Just('h'), Just('V'), Just('H'), Just('v')], numbers(1)).prop_map(|(c, n)| format!("{c} {n}")),
        2 => (prop_oneof![Just('s'), Just('S'), Just('q'), Just('Q')], numbers(4)).prop_map(|(c, n)| format!("{c}{n}")),
        1 => (prop_oneof![Just('c'), Just('C')], numbers(6)).prop_map(|(c, n)| format!("{c}{n}")),
        1 => Just("z".to_owned()),
    ]
}

/// Path data that begin with a move.
pub(crate) fn path_data() -> impl Strategy<Value = String> {
    prop::collection::vec(command(), 0..8).prop_map(|commands| format!("M1 2{}", commands.concat()))
}

fn attribute() -> impl Strategy<Value = String> {
    let names = [
        "cx", "cy", "r", "rx", "ry", "x", "y", "width", "height", "class", "id", "style", "fill",
    ];
    let odd = [
        "50%",
        "1em",
        "auto",
        "2px",
        ".5in",
        "a",
        "",
        " 7 ",
        "&#49;",
        "fill:red",
        "r:5px",
        "marker:none",
        "-1",
        "url(#a)",
    ];
    let value = prop_oneof![
        6 => number(),
        1 => pick(&odd).prop_map(str::to_owned),
    ];
    let quote = pick(&["\"", "'"]);
    let space = pick(&[" ", "\n  ", "\t"]);
    (pick(&names), value, quote, space)
        .prop_map(|(name, value, quote, space)| format!("{space}{name}={quote}{value}{quote}"))
}

/// Attributes of different names.
fn attributes() -> impl Strategy<Value = String> {
    prop::collection::vec(attribute(), 0..7).prop_map(|list| {
        let name = |text: &str| text.trim().split('=').next().unwrap().to_owned();
        let mut seen = Vec::new();
        list.into_iter()
            .filter(|text| {
                let new = !seen.contains(&name(text));
                seen.push(name(text));
                new
            })
            .collect()
    })
}

fn element() -> impl Strategy<Value = String> {
    let names = [
        "circle",
        "ellipse",
        "rect",
        "svg:circle",
        "line",
        "o:circle",
    ];
    let other = [
        "<!-- <circle r='1'/> -->",
        "<![CDATA[<circle r='1'/>]]>",
        "<style>.a{fill:red}</style>",
        "<style>circle.a{fill:red}</style>",
        "<style>path:hover,#b>rect{rx:2}</style>",
        "<?target circle?>",
        "text &amp; &#65;",
        "<animate attributeName='r'/>",
        "\r\n",
    ];
    let leaf = prop_oneof![
        4 => (pick(&names), attributes()).prop_map(|(name, list)| format!("<{name}{list}/>")),
        4 => (attributes(), path_data()).prop_map(|(list, d)| format!("<path{list} d='{d}'/>")),
        1 => pick(&other).prop_map(str::to_owned),
    ];
    leaf.prop_recursive(3, 24, 6, |inner| {
        let names = ["g", "circle", "defs", "marker", "text", "rect"];
        let children = prop::collection::vec(inner, 0..6);
        (pick(&names), attributes(), children).prop_map(|(name, list, children)| {
            format!("<{name}{list}>{}</{name} >", children.concat())
        })
    })
}

/// A well-formed SVG document.
pub(crate) fn document() -> impl Strategy<Value = String> {
    prop::collection::vec(element(), 1..6).prop_map(|elements| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:svg='http://www.w3.org/2000/svg' xmlns:o='urn:o' viewBox='0 0 9 9'>{}</svg>",
            elements.concat()
        )
    })
}

/// What a damage puts in.
const PIECES: [&str; 48] = [
    "<",
    ">",
    "/>",
    "</",
    "\"",
    "'",
    "=",
    "&",
    ";",
    "&#49;",
    "&#x41;",
    "&amp;",
    "&e;",
    "&#0;",
    "<!--",
    "-->",
    "<![CDATA[",
    "]]>",
    "<?a ?>",
    "<!DOCTYPE svg [<!ENTITY e '1'>]>",
    "<circle r='5'/>",
    "<style>circle{}</style>",
    "<script/>",
    "xmlns='a'",
    " r='1'",
    " d=''",
    "a5 5 0 0 1 5 5",
    "A1 2 3 1 0 4 5",
    "s1 2 3 4",
    "z",
    "M",
    "a",
    "A",
    "e",
    "E9",
    "-",
    "+",
    ".",
    ",",
    " ",
    "0",
    "1",
    "9",
    "00",
    "\n",
    "\0",
    "\u{feff}",
    "\u{fffe}",
];

/// One damage: what, where, how long.
#[derive(Debug, Clone)]
pub(crate) enum Damage {
    Flip(Index, u8),
    Insert(Index, &'static str),
    Cut(Index, usize),
    /// A part of another text.
    Splice(Index, Index, usize),
    Truncate(Index),
}

pub(crate) fn damages() -> impl Strategy<Value = Vec<Damage>> {
    let index = any::<Index>;
    let length = || prop_oneof![1_usize..4, 1_usize..200];
    let damage = prop_oneof![
        2 => (index(), any::<u8>()).prop_map(|(at, with)| Damage::Flip(at, with)),
        4 => (index(), pick(&PIECES)).prop_map(|(at, piece)| Damage::Insert(at, piece)),
        3 => (index(), length()).prop_map(|(at, length)| Damage::Cut(at, length)),
        2 => (index(), index(), length()).prop_map(|(at, from, length)| Damage::Splice(at, from, length)),
        1 => index().prop_map(Damage::Truncate),
    ];
    prop::collection::vec(damage, 1..5)
}

/// A text with damages; `other` is what splices come from.
pub(crate) fn damaged(text: &[u8], other: &[u8], damages: &[Damage]) -> Vec<u8> {
    let mut text = text.to_owned();
    for damage in damages {
        let place = |at: &Index| at.index(text.len() + 1);
        match damage {
            Damage::Flip(at, with) => {
                let at = place(at);
                text.get_mut(at).into_iter().for_each(|byte| *byte ^= *with);
            }
            Damage::Insert(at, piece) => {
                let at = place(at);
                text.splice(at..at, piece.bytes());
            }
            Damage::Cut(at, length) => {
                let at = place(at);
                text.drain(at..(at + length).min(text.len()));
            }
            Damage::Splice(at, from, length) => {
                let (at, from) = (place(at), from.index(other.len() + 1));
                let part = &other[from..(from + length).min(other.len())];
                text.splice(at..at, part.iter().copied());
            }
            Damage::Truncate(at) => text.truncate(place(at)),
        }
    }
    text
}

/// The documents of fixtures/ and, on long runs, the icons of corpora/ as far as they are there.
pub(crate) fn seeds(long: bool) -> &'static [String] {
    static SEEDS: OnceLock<Vec<String>> = OnceLock::new();
    SEEDS.get_or_init(|| {
        let mut folders = vec!["fixtures/documents"];
        if long {
            folders.push("corpora/lucide-static-1.62.0/package/icons");
            folders.push("corpora/bootstrap-icons-1.13.2/package/icons");
        }
        let mut files: Vec<_> = folders
            .iter()
            .filter_map(|folder| {
                std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).ok()
            })
            .flatten()
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.extension().is_some_and(|extension| extension == "svg"))
            .collect();
        files.sort();
        files
            .iter()
            .map(|path| std::fs::read_to_string(path).unwrap())
            .collect()
    })
}
