//! What the long help of a command ends in: three worked examples, which the tests run, and the exit codes.

use clap::Command;

/// Commands, and below each its examples.
const EXAMPLES: &str = r"
curveto
  curveto circle 50
  curveto ellipse 30 20 -t 0.01 -o ellipse.svg --show joints,handles
  curveto measure circle 50 -m minimax,midpoint
circle
  curveto circle 50
  curveto circle 50 -t 0.001 -f json
  curveto circle 50 -m midpoint -o circle.svg --show joints,truth,error=500
ellipse
  curveto ellipse 30 20 --rotation 15 --center 100,80
  curveto ellipse 120 50 -n 6 --adaptive -v
  curveto ellipse 120 50 -t 0.01% -o ellipse.pdf --size 80x60mm
arc
  curveto arc 10 --start 0 --end 90
  curveto arc --svg 'M0 0A25 25 0 0 1 50 50' -f tikz
  curveto arc --from 0,0 --to 10,0 --bulge 1 -o arc.dxf
conic
  curveto conic --from 0,0 --control 5,8 --to 10,0 --weight 0.7
  curveto conic --from 0,0 --control 5,8 --to 10,0 --weight 1 -f ps
  curveto conic --from 0,0 --control 5,8 --to 10,0 --weight 2 -t 0.001 -v
path
  curveto path 'M0 0H20A10 10 0 0 1 20 20H0Z'
  curveto path 'M0 0A5 5 0 0 1 10 0Z' --to quadratics -f canvas
  curveto circle 50 | curveto path - --to arcs -t 0.01
batch
  echo 'circle 0 0 5' | curveto batch -f json
  printf 'circle 0 0 5\ncircle 9 0 5\n' | curveto batch -o both.svg
  echo 'polyline 0 0 1 10 0 0 close' | curveto batch -t 0.001
spline
  curveto spline --points '0,0 5,8 10,0' --ends natural
  curveto spline --points '0,0 10,0 10,10 0,10' --ends cyclic -o ring.svg
  printf '0,0\n5,8\n9,0\n' | curveto spline --points-file - --ends free
sphere
  curveto sphere 100 -o sphere.svg
  curveto sphere 100 --meridians 12 --view 30,20 --hidden dash -o sphere.eps
  curveto sphere 50 -m midpoint -n 8 -f json
procset
  curveto procset > ellipses.ps
  curveto procset -m midpoint --with reporter,trig
  curveto procset -m lancaster-drawellipse -o lancaster.ps
methods
  curveto methods
  curveto methods minimax
  curveto methods -f csv
measure
  curveto measure circle 50 -m minimax,midpoint -n 4
  curveto measure --path 'M0 0C0 5.52 4.48 10 10 10' --against circle:10,0,10
  curveto measure circle 1 -m apprich --plot d2.svg --quantity curvature-d2
compare
  curveto compare -m minimax,midpoint,apprich -n 3,4,8
  curveto compare --ellipse 0.5 --by rms -f csv
  curveto compare -m all -n 2,3,4,5,6,8 -o errors.svg
diff
  curveto diff golden.svg new.svg -t 0.001
  curveto arc 5 --end 90 | curveto diff - 'M5 0A5 5 0 0 1 0 5' -t 0.01
  curveto diff a.ps b.ps -q || echo changed
explore
  curveto explore circle 50 -o circle.html
  curveto explore ellipse 120 50 -m minimax,apprich -n 4,8 -o ellipse.html
  curveto explore arc 10 --start 0 --end 120 -o arc.html
convert
  curveto convert logo.svg -t 0.01 -o logo-as-curves.svg
  curveto convert icons --in-place
  curveto convert icons --check
completions
  curveto completions bash > curveto.bash
  curveto completions zsh > _curveto
  curveto completions fish > curveto.fish
man
  curveto man > curveto.1
  curveto man --out-dir pages
  curveto man --out-dir pages && ls pages
";

/// What each exit code of a command means.
fn exit_codes(command: &str) -> &'static str {
    match command {
        "batch" => {
            "0 done; 1 a failure while running, such as a line that cannot be drawn; 2 a wrong or impossible request; 129, 130, 143 ended by SIGHUP, SIGINT, SIGTERM."
        }
        "diff" => "0 within T; 1 beyond; 2 trouble.",
        "convert" => {
            "0 done; 1 a failure while running, some files failed, or --check found work; 2 a wrong or impossible request; 129, 130, 143 ended by SIGHUP, SIGINT, SIGTERM."
        }
        _ => {
            "0 done; 1 a failure while running; 2 a wrong or impossible request; 129, 130, 143 ended by SIGHUP, SIGINT, SIGTERM."
        }
    }
}

/// Stands for a blank where help must not wrap a line: clap does so at blanks.
pub(crate) const BLANK: char = '\u{a0}';

/// The examples of a command, and what each of its exit codes means.
pub(crate) fn find(command: &str) -> Option<(Vec<&'static str>, &'static str)> {
    let mut lines = EXAMPLES.lines();
    lines.find(|line| *line == command)?;
    let examples = lines.map_while(|line| line.strip_prefix("  ")).collect();
    Some((examples, exit_codes(command)))
}

/// The examples of a command and its exit codes.
pub(crate) fn of(command: &str) -> String {
    let words = find(command).map(|(examples, codes)| {
        let examples = examples.join("\n  ");
        format!("Examples:\n  {examples}\n\nExit codes: {codes}")
    });
    unbroken(&words.unwrap_or_default())
}

/// A text of which no indented line is wrapped: those are to be copied.
fn unbroken(text: &str) -> String {
    let line = |line: &str| {
        if line.starts_with("  ") {
            line.replace(' ', &BLANK.to_string())
        } else {
            line.to_owned()
        }
    };
    text.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// A command whose long help ends in them, after what it ended in before.
pub(crate) fn ended(command: Command) -> Command {
    let before = command
        .get_after_long_help()
        .or_else(|| command.get_after_help());
    let before = before.map_or_else(String::new, |words| format!("{words}\n\n"));
    let own = of(command.get_name());
    command.after_long_help(unbroken(&before) + &own)
}
