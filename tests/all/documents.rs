//! What the three documents say beyond the methods: their tables, procedures and figures, each by a command.

use serde_json::Value;

use crate::judges::ghostscript;
use crate::judges::program::{json, printed, refused};

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn samples_are_the_points_of_the_curve_beside_the_circle() {
    let k = 0.551_784;
    let found = json(&[
        "measure",
        "arc",
        "1",
        "--start",
        "0",
        "--end",
        "90",
        "-m",
        "lancaster-best",
        "--samples",
        "91",
    ]);
    let samples = found["samples"].as_array().unwrap();
    assert_eq!(samples.len(), 91);
    for (i, sample) in samples.iter().enumerate() {
        let t = i as f64 / 90.0;
        let u = 1.0 - t;
        let x = u * u * u + 3.0 * u * u * t + 3.0 * u * t * t * k;
        let y = 3.0 * u * u * t * k + 3.0 * u * t * t + t * t * t;
        let expected = [
            ("t", t),
            ("x", x),
            ("y", y),
            ("radius", x.hypot(y)),
            ("error", x.hypot(y) - 1.0),
            ("degrees", y.atan2(x).to_degrees()),
        ];
        for (key, value) in expected {
            assert!((number(&sample[key]) - value).abs() < 1e-13, "{key} at {t}");
        }
    }
}

#[test]
fn samples_of_an_ellipse_err_along_its_normal() {
    let found = json(&["measure", "ellipse", "3", "1", "-n", "5", "--samples", "33"]);
    let peak = number(&json(&["measure", "ellipse", "3", "1", "-n", "5"])["error"]["peak"]);
    let samples = found["samples"].as_array().unwrap();
    assert_eq!(samples.len(), 5 * 33);
    let largest = samples
        .iter()
        .map(|s| number(&s["error"]).abs())
        .fold(0.0, f64::max);
    assert!(largest <= peak && largest > 0.9 * peak, "{largest} {peak}");
    // The distance from the centre is another figure.
    assert!((number(&samples[16]["radius"]) - number(&samples[16]["error"]) - 1.0).abs() > 0.1);
}

#[test]
fn samples_as_a_table_and_csv_say_the_same() {
    let words = [
        "measure",
        "circle",
        "50",
        "-m",
        "midpoint,minimax",
        "--samples",
        "3",
    ];
    let csv = printed(&[&words[..], &["-f", "csv"]].concat());
    assert_eq!(csv.lines().count(), 1 + 2 * 4 * 3);
    assert!(csv.starts_with("subject,method,segment,t,x,y,radius,error,degrees\n"));
    let table = printed(&words);
    assert_eq!(table.matches("of 12 points: peak").count(), 2, "{table}");
    assert!(refused(&["measure", "circle", "1", "--samples", "1"]).contains("from 2"));
    assert!(refused(&["measure", "circle", "1", "--samples", "99999999"]).contains("2500000"));
}

#[test]
fn the_reporter_prints_x_before_y() {
    let procedures = printed(&["procset", "--with", "reporter"]);
    let said = ghostscript::run(&format!(
        "{procedures}\nnewpath 10 20 moveto 30 40 lineto 1 2 3 4 5 6.5 curveto closepath reportpath count ="
    ));
    assert_eq!(
        said,
        "10.0 20.0 moveto \n30.0 40.0 lineto \n1.0 2.0 3.0 4.0 5.0 6.5 curveto \nclosepath\n0\n"
            .replace(" \n", "\n")
    );
    // What his own gives: y first, since that lies on top of the stack.
    let his =
        ghostscript::run("newpath 10 20 moveto {== == (moveto\n) print flush} {} {} {} pathforall");
    assert_eq!(his, "20.0\n10.0\nmoveto\n");
}

#[test]
fn the_inverse_trigonometry_is_right_in_all_its_quadrants() {
    let procedures = printed(&["procset", "--with", "trig"]);
    let values = (-20..=20).map(|step| f64::from(step) / 20.0);
    let program = values.clone().fold(procedures, |program, value| {
        let x = 7.0 * value;
        program + &format!("{value} trig.acos = {value} trig.asin = {x} 7 acos = {x} 7 asin =\n")
    });
    let said = ghostscript::run(&(program + "count ="));
    let found: Vec<f64> = said.lines().map(|line| line.parse().unwrap()).collect();
    let expected = values.flat_map(|value| {
        let [acos, asin] = [value.acos().to_degrees(), value.asin().to_degrees()];
        [acos, asin, acos, asin]
    });
    assert_eq!(found.len(), 4 * 41 + 1);
    for (found, expected) in found.iter().zip(expected.chain([0.0])) {
        // It prints six digits.
        assert!((found - expected).abs() < 1e-3, "{found} is not {expected}");
    }
    // His asin, as printed.
    let his = "/asin {2 copy dup mul exch dup mul sub abs sqrt exch pop atan} def -0.5 1 asin =";
    assert_eq!(ghostscript::run(his), "330.0\n");
}

#[test]
fn procedures_are_named_once_and_stand_alone() {
    let all = printed(&["procset", "--with", "trig,reporter,trig"]);
    assert_eq!(all.matches("%%BeginResource").count(), 3);
    assert_eq!(all.matches("%%EndResource").count(), 3);
    let said = ghostscript::run(&format!(
        "/say 7 def {all}\n2 drawcircle reportpath say = count ="
    ));
    assert!(
        said.starts_with("-1.0 0.0 moveto\n") && said.ends_with("curveto\n7\n0\n"),
        "{said}"
    );
    assert!(refused(&["procset", "--with", "printer"]).contains("reporter"));
}
