//! Words that people bring from other tools, and what serves instead.

/// Flags that people try, `=` where they are those of the line above, the commands that they try them on, `*` where these are all, and what
/// serves instead. The first that names flags of the command alone is told.
const FLAGS: &str = "\
--reverse --clockwise --cw --ccw --counterclockwise --counter-clockwise --anticlockwise --anti-clockwise | path | a path runs as its data do
= | conic | a conic runs from --from to --to
= | batch | the sweep of an arc has a sign: arc CX CY R START SWEEP
= | * | --reverse runs the other way round; positive angles turn from +x towards +y, clockwise on an SVG canvas
--radius -r --r | circle | the radius stands alone: circle 50
= | sphere | the radius stands alone: sphere 50
--radius --radii --rx --ry -r | ellipse | the radii stand alone: ellipse 30 20
-j --jobs | circle ellipse arc conic path spline sphere | one shape takes one thread; 'curveto batch -j 4' and 'curveto convert -j 4' take several
-i --inplace | convert | --in-place replaces each file
--dry-run -d --dryrun | convert | --check writes nothing and lists the files with something to do
--stdout -c | convert | the result of one file goes to standard output by itself; --in-place and --out-dir DIR take several
-f --format | convert | the result is SVG; 'curveto path FILE.svg --to arcs -f gcode' draws its shapes in any format
= | procset | it prints PostScript and nothing else
--cx --cy --x --y | batch | a line says where its centre lies: circle CX CY R
--cx --cy -c --x --y | * | --center X,Y says where the centre lies
--width --height -w --color --colour --scale --translate | convert | colours, sizes and places stay as they are: it replaces shapes and arcs alone
--width --height -w | * | --size WxH sets the size of a picture, --stroke-width that of its lines
= | * | --size WxH sets the size of a plot
--color --colour | * | --stroke colours the line, --fill the inside
--decimals --digits --round | * | -p sets the decimals
--circle --ellipse --arc --path --batch --convert | curveto | commands have no dashes: curveto circle 50
--kappa --magic --k -k | * | --handle K is the length of the handles on the unit circle; -m names a method
= | * | -m names a method, which has its handle; 'curveto methods' lists them
--flatness --error --epsilon --accuracy --tol | compare | it tells the error of each number of segments: -n 2,3,4
= | spline | the curve runs through every point, whatever the tolerance
= | * | -t sets the tolerance, how far a curve may stray
--steps --count --points --pieces --parts | * | -n sets the number of segments
--end --sweep --from --to --angle --start-angle --end-angle | circle ellipse | a part of one is an arc: curveto arc 50 --start 0 --end 90
--start-angle --end-angle --angle | arc | angles have flags: curveto arc 50 --start 0 --end 90
--rotation --rotate --angle | circle | --start says where the first joint lies
= | sphere | --view LON,LAT says from where the sphere is seen
--phi --tilt | ellipse arc | --rotation turns an ellipse
--closed --close --cyclic | spline | --ends cyclic closes it
--closed --close | path | Z in the data closes a subpath; --open leaves the closing operators out
= | * | whole turns are closed by themselves; --open leaves the closing operator out
--silent | * | -q silences notes
--path --file --against --fit | measure | a curve that someone else made stands without a shape: curveto measure --path 'M0 0C0 5 5 10 10 10'
--file --out --outfile --save | * | -o FILE says where the output goes
-m --method --id | methods | the id stands alone: curveto methods minimax
--quadratic --quadratics --cubic | * | -m names a method: quadratic-minimax draws quadratics; 'curveto methods' lists them
--radians --degrees --rad --deg | circle ellipse arc sphere | angles take units: 90, 90deg, 1.57rad, 100grad, 0.25turn
--scale --translate | * | --transform 'scale(2) translate(5,0)' takes an SVG transform list
-r -R --recursive | convert | folders are walked by themselves
--threads | batch convert | -j sets the number of threads
--input -i | batch | the file stands alone: curveto batch shapes.txt
--algorithm --list-methods --methods | * | -m names a method; 'curveto methods' lists them";

/// Words that people try as commands, and what serves instead.
const COMMANDS: &str = "\
formats format | 'curveto circle --help' lists the formats
list ls method | 'curveto methods' lists the methods
line polygon polyline rect rectangle curve bezier pie sector square ring star | 'curveto path' draws any path data: curveto path 'M0 0L10 10'
plot error | 'curveto measure' and 'curveto compare' state and plot errors
oval | an ellipse it is: curveto ellipse 30 20
draw shape | name the shape: curveto circle 50
version | 'curveto --version' tells it";

/// Flags that are tried, the commands that they are tried on, and what serves instead.
#[derive(Clone, Copy)]
pub(super) struct ForeignFlags {
    flags: &'static str,
    commands: &'static str,
    pub(super) hint: &'static str,
}

impl ForeignFlags {
    /// In their order.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        let mut above = "";
        FLAGS.lines().filter_map(move |line| {
            let (flags, rest) = line.split_once(" | ")?;
            let (commands, hint) = rest.split_once(" | ")?;
            if flags != "=" {
                above = flags;
            }
            Some(Self {
                flags: above,
                commands,
                hint,
            })
        })
    }

    pub(super) fn flags(self) -> impl Iterator<Item = &'static str> {
        self.flags.split(' ')
    }

    /// The commands; `None` for all.
    pub(super) fn commands(self) -> Option<Vec<&'static str>> {
        (self.commands != "*").then(|| self.commands.split(' ').collect())
    }
}

/// What serves in place of a command that there is not.
pub(super) fn command(word: &str) -> Option<&'static str> {
    let mut rows = COMMANDS.lines().filter_map(|line| line.split_once(" | "));
    rows.find_map(|(words, hint)| words.split(' ').any(|known| known == word).then_some(hint))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_has_its_columns() {
        assert_eq!(ForeignFlags::all().count(), FLAGS.lines().count());
        assert!(ForeignFlags::all().all(|found| found.flags().all(|flag| flag.starts_with('-'))));
        assert!(COMMANDS.lines().all(|line| line.contains(" | ")));
    }
}
