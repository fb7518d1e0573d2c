//! Runs Ghostscript and reads what it says.

use std::io::Write;
use std::process::Command;

use resvg::tiny_skia::Pixmap;

/// A path operator and its numbers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Operator {
    pub(crate) name: String,
    pub(crate) numbers: Vec<f64>,
}

/// How much larger user space is made: Ghostscript keeps points on a grid of 1/256 of a device unit.
const SCALE: f64 = 1000.0;
/// The grid on which Ghostscript keeps points, in user units.
pub(crate) const GRID: f64 = 1.0 / 256.0 / SCALE;

/// Numbers are printed as whole multiples of 1 / UNIT, because Ghostscript prints no more than six digits of a real number.
const UNIT: f64 = 1_048_576.0;

/// `report` prints the current path, one operator a line with its numbers before it.
const REPORT: &str = "\
/say { unit mul round cvi 32 string cvs print ( ) print } def
/report {
  { exch say say (moveto\\n) print }
  { exch say say (lineto\\n) print }
  { 6 -1 1 { -1 roll say } for (curveto\\n) print }
  { (closepath\\n) print }
  pathforall
} def
";

/// The path that this program leaves as the current path.
pub(crate) fn path_of(program: &str) -> Vec<Operator> {
    reported(&format!("{program}\nreport\n"))
}

/// The paths that this program strokes.
pub(crate) fn strokes_of(program: &str) -> Vec<Operator> {
    let hooks = "/stroke { report newpath } def /showpage {} def";
    reported(&format!("{hooks}\n{program}\n"))
}

/// The paths that this program strokes or fills, in the coordinates that it begins with.
pub(crate) fn painted_by(program: &str) -> Vec<Operator> {
    let hooks = "/base matrix currentmatrix def /paint { gsave base setmatrix report grestore newpath } def \
                 /stroke { paint } def /fill { paint } def /eofill { paint } def";
    reported(&format!("{hooks}\n{program}\n"))
}

fn reported(program: &str) -> Vec<Operator> {
    let mut path = operators(&run(&format!(
        "/unit {UNIT} def\n{REPORT}{SCALE} dup scale\n{program}"
    )));
    for number in path.iter_mut().flat_map(|operator| &mut operator.numbers) {
        *number /= UNIT;
    }
    path
}

/// Path operators in a text, one a line.
pub(crate) fn operators(text: &str) -> Vec<Operator> {
    text.lines()
        .map(|line| {
            let mut words: Vec<&str> = line.split_whitespace().collect();
            Operator {
                name: words.pop().unwrap_or_default().to_owned(),
                numbers: words.iter().map(|word| word.parse().unwrap()).collect(),
            }
        })
        .collect()
}

/// The picture of an EPS file on white, so many pixels a point, without antialiasing.
pub(crate) fn picture(eps: &str, pixels: u32) -> Pixmap {
    let folder = tempfile::tempdir().unwrap();
    let png = folder.path().join("page.png");
    let options = [
        "-sDEVICE=png16m",
        "-dEPSCrop",
        &format!("-r{}", 72 * pixels),
        &format!("-sOutputFile={}", png.display()),
        // Strokes are to lie where they lie, not on whole pixels.
        "-c",
        "false setstrokeadjust 0.01 setflat",
        "-f",
    ];
    execute(eps, &options);
    Pixmap::decode_png(&std::fs::read(png).unwrap()).unwrap()
}

/// What a program prints that draws on no page.
pub(crate) fn run(program: &str) -> String {
    execute(program, &["-dNODISPLAY"])
}

fn execute(program: &str, options: &[&str]) -> String {
    let mut file = tempfile::NamedTempFile::with_suffix(".ps").unwrap();
    file.write_all(program.as_bytes()).unwrap();
    let output = Command::new("gs")
        .args(["-q", "-dBATCH", "-dNOPAUSE", "-dSAFER"])
        .args(options)
        .arg(file.path())
        .output()
        .unwrap_or_else(|error| {
            panic!(
                "gs does not run ({error}): these tests need Ghostscript; install it with \
                 'apt-get install ghostscript' or 'brew install ghostscript'"
            )
        });
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success() && !text.contains("Error:"),
        "gs refuses the program: {text}{message}"
    );
    text
}
