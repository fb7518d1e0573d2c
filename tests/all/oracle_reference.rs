//! The oracle against the reference values of `fixtures/reference/methods.json` and of other
//! computations.

use crate::judges::oracle;

use oracle::real::{abs, agrees, ratio};
use oracle::{IDS, Oracle, Real, int, parse, pi, radians, real};
use serde_json::Value;

/// The parsed reference file.
fn reference() -> Vec<Value> {
    let text = include_str!("../../fixtures/reference/methods.json");
    let file: Value = serde_json::from_str(text).expect("valid JSON");
    file["methods"].as_array().expect("a list").clone()
}

/// The angle that a key of the reference file stands for.
fn angle(key: &str) -> Real {
    match key {
        "pi" => pi(),
        "2pi/3" => pi() * ratio(2, 3),
        "pi/2" => pi() * ratio(1, 2),
        "pi/3" => pi() * ratio(1, 3),
        "pi/4" => pi() * ratio(1, 4),
        "pi/6" => pi() * ratio(1, 6),
        "1deg" => radians(&int(1)),
        _ => unreachable!("unknown angle {key}"),
    }
}

/// The angle in degrees by which the path turns at a joint of equal segments, negative if the
/// segment leaves its start to the left of the circle's tangent.
fn joint_corner(points: &[[Real; 2]]) -> Real {
    let across = &points[1][0] - &points[0][0];
    let along = &points[1][1] - &points[0][1];
    (across / along).atan() * int(360) / pi()
}

/// Every number of one entry of the reference file, with its name and the oracle's value.
fn numbers<'a>(entry: &'a Value, oracle: &Oracle) -> Vec<(String, &'a str, Real)> {
    let text = |value: &'a Value| value.as_str().expect("a decimal string");
    let larger = oracle::real::max(oracle.outward.clone(), oracle.inward.clone());
    let curvature = oracle::curvature_derivatives(&oracle.points, false, 0);
    let handle = oracle.handle.clone().expect("a handle");
    let mut rows: Vec<(String, &str, Real)> = [
        ("handle", handle),
        ("end_radius", oracle.end_radius.clone()),
        ("max_abs", larger),
        ("max_out", oracle.outward.clone()),
        ("max_in", -&oracle.inward),
        ("end_curvature", curvature[0].clone()),
        ("joint_corner_deg", joint_corner(&oracle.points)),
    ]
    .map(|(name, value)| (name.to_owned(), text(&entry[name]), value))
    .into();
    let printed = entry["control_points"].as_array().expect("points");
    assert_eq!(printed.len(), oracle.points.len());
    for (i, (printed, point)) in printed.iter().zip(&oracle.points).enumerate() {
        for axis in 0..2 {
            let name = format!("control_points[{i}][{axis}]");
            rows.push((name, text(&printed[axis]), point[axis].clone()));
        }
    }
    rows
}

#[test]
fn oracle_reproduces_every_reference_value() {
    let mut wrong = Vec::new();
    let mut compared = 0;
    for method in reference() {
        let id = method["id"].as_str().expect("an id");
        for (key, entry) in method["values"].as_object().expect("values") {
            let found = oracle::method(id, &angle(key));
            if entry.is_null() || found.is_none() {
                assert_eq!(entry.is_null(), found.is_none(), "{id} at {key}");
                continue;
            }
            for (name, printed, value) in numbers(entry, &found.expect("checked")) {
                compared += 1;
                if !agrees(&value, printed) {
                    let ours = value.to_decimal().value();
                    wrong.push(format!("{id} {key} {name}: {printed}, oracle {ours:.40}"));
                }
            }
        }
    }
    assert!(compared > 2000, "only {compared} numbers compared");
    assert!(wrong.is_empty(), "{}\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn leading_constants_and_orders_hold_at_a_hundredth_degree() {
    let a = radians(&parse("0.01"));
    for method in reference() {
        let id = method["id"].as_str().expect("an id");
        let order = method["order"].as_i64().expect("an order");
        let constant = parse(method["leading_constant"].as_str().expect("a constant"));
        let found = oracle::method(id, &a).expect("defined");
        let error = oracle::real::max(found.outward, found.inward);
        let power = (0..order).fold(int(1), |product, _| product * &a);
        // The next term is a^2 = 3e-8 times a number below 10.
        let deviation = abs(&(error / (&constant * power) - int(1)));
        assert!(deviation < parse("1e-7"), "{id}: {deviation:.3}");
    }
}

/// Handle, largest and smallest signed radial error at an angle in degrees, computed with mpmath
/// in 110 digits from other formulas: the w0 family and `r^2 - 1 = -u^2 (H + G u)`.
const BETWEEN: [(&str, &str, [&str; 3]); 14] = [
    (
        "minimax",
        "0.01",
        [
            "0.00005817764177006499240754461422903856",
            "3.65375682862379773070563e-28",
            "-3.65375682862379773070563e-28",
        ],
    ),
    (
        "goldapp",
        "0.01",
        [
            "0.00005817764177006499240754461422903856",
            "3.65375682862379773070563e-28",
            "-3.65375682862379773070563e-28",
        ],
    ),
    (
        "area",
        "0.01",
        [
            "0.0000581776417700649924055958843836047",
            "3.21906777271223348028212e-28",
            "-4.92919752830624986469223e-28",
        ],
    ),
    (
        "length",
        "0.01",
        [
            "0.0000581776417700649924055958843836047",
            "3.21906777271223347963269e-28",
            "-4.92919752830624986668111e-28",
        ],
    ),
    (
        "mean",
        "0.01",
        [
            "0.00005817764177006499240896062974847101",
            "3.99303415757954954024823e-28",
            "-2.72697683954632680334934e-28",
        ],
    ),
    (
        "mean-angle",
        "0.01",
        [
            "0.00005817764177006499240896062974742737",
            "3.99303415732205490872971e-28",
            "-2.72697684022939228607874e-28",
        ],
    ),
    (
        "rms",
        "0.01",
        [
            "0.00005817764177006499240833452404708672",
            "3.84054124624306857537106e-28",
            "-3.13676206232612150680974e-28",
        ],
    ),
    (
        "chen-2",
        "0.01",
        [
            "0.00005817764173314431915581182426962168",
            "0",
            "-2.41645241090733851829831e-18",
        ],
    ),
    (
        "minimax-g0",
        "0.01",
        [
            "0.00005817764177006499243380898932858303",
            "1.32758279299358071866651e-28",
            "-1.32758279299358071866651e-28",
        ],
    ),
    (
        "minimax",
        "37.3",
        [
            "0.2189350182509371292695176211335302",
            "0.000000985420376712164537952394",
            "-0.000000985420376712164537952394",
        ],
    ),
    (
        "goldapp",
        "37.3",
        [
            "0.2189350182479457273614355369046877",
            "0.000000985420123115336124000193",
            "-0.000000985421094169112061047305",
        ],
    ),
    (
        "area",
        "37.3",
        [
            "0.2189335677162199880691754569295107",
            "0.000000867531206849121782363441",
            "-0.00000133331619359477004787844",
        ],
    ),
    (
        "length",
        "37.3",
        [
            "0.2189335672816913296133134569436223",
            "0.000000867497391567682906251115",
            "-0.00000133342041081949827842024",
        ],
    ),
    (
        "mean",
        "37.3",
        [
            "0.2189360717919295753253746697770317",
            "0.00000107748213557970181221835",
            "-0.000000732739417163195062795274",
        ],
    ),
];

#[test]
fn oracle_agrees_with_an_independent_computation_between_the_reference_angles() {
    for (id, degrees, [handle, outward, inward]) in BETWEEN {
        let found = oracle::method(id, &radians(&parse(degrees))).expect("defined");
        assert!(agrees(&found.handle.expect("a handle"), handle), "{id}");
        assert!(agrees(&found.outward, outward), "{id} outside");
        assert!(agrees(&-found.inward, inward), "{id} inside");
    }
}

#[test]
fn equioscillating_methods_swing_equally_at_every_angle() {
    let equal = [
        "minimax",
        "minimax-g0",
        "minimax-free",
        "apprich-scaled",
        "curvature-scaled",
        "minimax-g0-free",
        "quadratic-minimax",
        "quadratic-minimax-free",
    ];
    for degrees in ["0.01", "0.3", "7", "33.3", "77", "119", "151", "179.9"] {
        let a = radians(&parse(degrees));
        for id in equal {
            let Some(found) = oracle::method(id, &a) else {
                assert!(id == "apprich-scaled" && a > pi() * ratio(2, 3));
                continue;
            };
            let difference = abs(&(&found.outward - &found.inward));
            assert!(
                difference < found.outward * parse("1e-30"),
                "{id} {degrees}"
            );
        }
    }
}

#[test]
fn every_method_is_defined_at_a_quarter_and_none_beyond_its_limit() {
    let quarter = real(std::f64::consts::FRAC_PI_2);
    for id in IDS {
        assert!(oracle::method(id, &quarter).is_some(), "{id}");
        assert!(oracle::method(id, &int(0)).is_none(), "{id}");
        assert!(oracle::method(id, &real(3.15)).is_none(), "{id}");
    }
    for id in ["apprich", "apprich-plus", "apprich-scaled"] {
        assert!(oracle::method(id, &radians(&int(120))).is_some(), "{id}");
        assert!(oracle::method(id, &radians(&int(121))).is_none(), "{id}");
    }
    assert!(oracle::method("lancaster-best", &real(1.0)).is_none());
    assert!(oracle::method("unheard-of", &quarter).is_none());
}

/// Peak and mean over the parameter at the numbers of Lancaster's table, from the formula of
/// `r^2 - 1` in mpmath, and the peaks of the other two methods that the reference file does not hold.
#[test]
fn methods_outside_the_reference_file_have_the_known_errors() {
    let table = [
        (180, "0.0183500453259", "0.00945808824601"),
        (120, "0.00154506101656", "0.000796896992349"),
        (90, "0.000265562700774", "0.00012627804088"),
        (72, "6.80045394481e-5", "3.27535943875e-5"),
        (60, "2.29087155614e-5", "1.0971878223e-5"),
        (45, "3.84305231664e-6", "1.91587908104e-6"),
    ];
    let peak = |id: &str, degrees: i32| {
        let found = oracle::method(id, &radians(&int(degrees))).expect("defined");
        let larger = oracle::real::max(found.outward, found.inward);
        (larger, found.points)
    };
    for (degrees, largest, mean) in table {
        let (error, points) = peak("lancaster-best", degrees);
        assert!(agrees(&error, largest), "{degrees}");
        let average = oracle::mean_abs_radial_error_t(&points);
        assert!(agrees(&average, mean), "{degrees}");
    }
    assert!(agrees(&peak("lancaster-drawellipse", 90).0, "2.38648e-4"));
    assert!(agrees(&peak("apprich-plus", 90).0, "0.36485"));
}
