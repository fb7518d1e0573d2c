//! The pages of `explore` and `compare -f html`. What they do in a browser is tested there: `make test-browser`.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::judges::program::{drawn_text as printed, refused, words};

/// What a page holds.
fn data(page: &str) -> Value {
    let (_, rest) = page
        .split_once("<script type=\"application/json\" id=\"data\">")
        .unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn a_page_of_all_methods_is_one_small_file_that_asks_for_nothing() {
    for command in [
        "explore ellipse 120 50 --rotation 20",
        "compare -f html --by rms,area",
    ] {
        let page = printed(command);
        assert!(page.len() < 400_000, "{command}: {}", page.len());
        assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
        assert!(page.contains("default-src 'none'"));
        for outside in [" src=", "@import", "url(", "https:", "fetch(", "import("] {
            assert!(!page.contains(outside), "{command}: {outside}");
        }
        // The namespace of SVG is the only address in it, and is never asked for.
        assert_eq!(page.matches("http:").count(), 1);
        assert!(!page.contains('@') || !page.contains("@DATA@"));
        let held = data(&page);
        assert_eq!(held["methods"].as_array().unwrap().len(), 28);
        assert_eq!(held["shapes"].as_array().unwrap().len(), 3, "{command}");
        for method in curveto::Method::ALL {
            assert!(page.contains(&format!(">{}</th>", method.id())), "{method}");
        }
    }
}

#[test]
fn every_drawing_of_a_page_is_the_one_that_its_command_draws() {
    let page = data(&printed(
        "explore arc 10 20 --start 30 --sweep -100 --rotation 15 -m minimax,quadratic-minimax -n 1,3",
    ));
    let mut compared = 0;
    for shape in page["shapes"].as_array().unwrap() {
        for step in shape["steps"].as_array().unwrap().iter().step_by(4) {
            for drawing in step["drawings"].as_array().unwrap() {
                let command = format!(
                    "{} -m {} -n {} -p {}",
                    step["words"].as_str().unwrap(),
                    drawing["method"].as_str().unwrap(),
                    drawing["segments"],
                    drawing["precision"]
                );
                assert_eq!(
                    drawing["path"].as_str().unwrap(),
                    printed(&command).trim_end()
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 20, "{compared}");
}

#[test]
fn figures_are_those_of_compare_and_profiles_reach_the_peak() {
    let page = data(&printed("compare -m minimax,chen-3 -n 4,8 -f html"));
    for (criterion, by) in ["peak", "square", "mean", "rms", "area", "length"]
        .iter()
        .enumerate()
    {
        let compared = printed(&format!(
            "compare -m minimax,chen-3 -n 4,8 --by {by} -f json"
        ));
        let compared: Value = serde_json::from_str(&compared).unwrap();
        let drawings = page["shapes"][0]["steps"][0]["drawings"]
            .as_array()
            .unwrap();
        assert_eq!(drawings.len(), 4);
        for drawing in drawings {
            let row = compared["methods"].as_array().unwrap();
            let row = row
                .iter()
                .find(|row| row["method"] == drawing["method"])
                .unwrap();
            let column = usize::from(drawing["segments"] == 8);
            let exact = row["values"][column].as_f64().unwrap();
            let shown = drawing["figures"][criterion].as_f64().unwrap();
            assert!(
                shown >= exact * (1.0 - 1e-12) && shown <= exact * (1.0 + 1.1e-5),
                "{by}"
            );
            let kinds = drawing["profiles"].as_array().unwrap();
            let parts = kinds.iter().flat_map(|kind| kind.as_array().unwrap());
            let largest = parts
                .map(|part| part.as_i64().unwrap().abs())
                .max()
                .unwrap();
            assert!((980..=1000).contains(&largest), "{largest}");
        }
    }
}

#[test]
fn sliders_hold_all_methods_and_counts_where_few_were_asked_for_and_fill_the_page_where_many() {
    let methods_and_counts = |page: &str| {
        let held = data(page);
        let drawn = |choice: &Value| {
            let steps = choice["steps"].as_array().unwrap().iter();
            let drawings = steps.flat_map(|step| step["drawings"].as_array().unwrap());
            let pairs: BTreeSet<String> = drawings
                .map(|drawing| format!("{} {}", drawing["method"], drawing["segments"]))
                .collect();
            pairs.len()
        };
        ["ellipse", "arc"].map(|id| {
            let mut choices = held["shapes"].as_array().unwrap().iter();
            drawn(choices.find(|choice| choice["id"] == id).unwrap())
        })
    };
    let few = printed("explore circle 50 -m minimax,midpoint,chen-3");
    // Six counts on ellipses; on arcs 1 as well, with which Chen's Formulation III ends before 8.
    let [on_ellipses, on_arcs] = methods_and_counts(&few);
    assert_eq!(on_ellipses, 3 * 6);
    assert!(on_arcs >= 3 * 6, "{on_arcs}");
    let many = printed("explore circle 50");
    assert!((370_000..400_000).contains(&many.len()), "{}", many.len());
    let [on_ellipses, on_arcs] = methods_and_counts(&many);
    assert!(on_ellipses > 20 && on_arcs > 18, "{on_ellipses} {on_arcs}");
}

#[test]
fn spans_become_a_slider_over_arcs_of_one_segment() {
    let page = data(&printed(
        "compare -m minimax,midpoint --spans 30,60,90 -f html",
    ));
    let asked = &page["shapes"][0];
    let values = asked["steps"]
        .as_array()
        .unwrap()
        .iter()
        .map(|step| step["value"].as_f64().unwrap());
    assert_eq!(values.collect::<Vec<_>>(), [30.0, 60.0, 90.0]);
    assert_eq!(asked["counts"], serde_json::json!([1]));
    assert!(
        page["command"]
            .as_str()
            .unwrap()
            .ends_with("--spans 30,60,90 -o page.html")
    );
}

#[test]
fn what_papers_print_stands_beside_what_is_true() {
    let page = data(&printed("explore circle 1 -m minimax -n 4"));
    let rows = |source: usize| page["sources"][source]["rows"].as_array().unwrap();
    assert_eq!([rows(0).len(), rows(1).len(), rows(2).len()], [16, 7, 12]);
    for (source, label, printed, truth) in [
        (0, "Peak, 4 splines by 0.551784", "0.000265718", 2.65563e-4),
        (
            0,
            "Average, 6 splines by 0.3572045",
            "1.20421e-05",
            1.09718e-5,
        ),
        (0, "Peak lower than the normal one by", "24", 2.556_53),
        (
            1,
            "Table 1, π/2: Formulation II, exact arc length",
            "0.01903",
            0.017_695_683_7,
        ),
        (
            1,
            "Table 1, π/2: Formulation II, two-point Gauss",
            "0.01903",
            0.019_031_9,
        ),
        (1, "Table 2, π/4: Formulation III", "0.00010", 0.000_980_75),
        (2, "E, φ = 360°/4: 3φ⁶/4096", "0.0110022", 0.015_594_119_47),
        (
            2,
            "E*, φ = 360°/4: 3φ⁶/16384",
            "0.00275056",
            0.003_929_226_469,
        ),
    ] {
        let row = rows(source)
            .iter()
            .find(|row| row["label"] == label)
            .unwrap();
        assert_eq!(row["printed"], printed, "{label}");
        let found = row["true"].as_f64().unwrap();
        assert!((found / truth - 1.0).abs() < 1e-5, "{label}: {found}");
    }
}

#[test]
fn what_cannot_be_a_page_is_refused() {
    for (command, message) in [
        ("explore circle 50 -n 2000", "more than 400 kB"),
        (
            "explore circle 50 -m apprich -n 2",
            "apprich cannot do this",
        ),
        (
            "explore arc 5 --start 0 --sweep 0",
            "there is nothing to look at",
        ),
        (
            "explore circle 50 -o page.svg",
            "its formats are html and json",
        ),
        ("explore circle 50 -m nonesuch", "unknown method"),
        (
            "explore conic --from 0,0 --control 5,9 --to 10,0 --weight 1",
            "no arc of an ellipse",
        ),
        ("explore", "error: explore: the shape is missing"),
    ] {
        let said = refused(&words(command));
        assert!(said.contains(message), "{command}: {said}");
    }
}
