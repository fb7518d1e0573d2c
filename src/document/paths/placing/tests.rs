use crate::document::svg_paths;
use kurbo::Point;

/// Where a file places the point (3, 4), which its path begins with.
fn placed(text: &str) -> Option<Point> {
    let paths = svg_paths(text).unwrap().paths;
    let (_, map) = paths[0].contours.as_ref().ok()?;
    Some(*map * Point::new(3.0, 4.0))
}

fn near(text: &str, x: f64, y: f64) {
    let found = placed(text).unwrap();
    assert!(found.distance(Point::new(x, y)) < 1e-12, "{text}: {found}");
}

const PATH: &str = "<path d='M3 4L5 5'/>";

/// A scale of 5 fits 10 by 10 into 100 by 50, one of 10 covers it.
#[test]
fn a_view_box_fits_as_it_is_asked_to() {
    for (how, x, y) in [
        ("", 40.0, 25.0),
        ("xMidYMid", 40.0, 25.0),
        ("xMinYMin", 15.0, 25.0),
        ("xMaxYMax meet", 65.0, 25.0),
        ("xMidYMid slice", 20.0, 5.0),
        ("xMaxYMin slice", 20.0, 30.0),
        ("xMinYMax slice", 20.0, -20.0),
        ("none", 20.0, 25.0),
        ("xMidYMid  slice", 20.0, 5.0),
        // No such words: as if there were none.
        ("defer xMinYMin", 40.0, 25.0),
        ("xMinYMin meet x", 40.0, 25.0),
        ("xMinYMin,slice", 40.0, 25.0),
        ("xMinYMi", 40.0, 25.0),
        ("xMinYMax cut", 40.0, 25.0),
        ("slice", 40.0, 25.0),
    ] {
        let text = format!(
            "<svg viewBox='0 0 200 100'><svg x='10' y='20' width='100' height='50' viewBox='2 3 10 10' preserveAspectRatio='{how}'>{PATH}</svg></svg>"
        );
        near(&text.replace(" preserveAspectRatio=''", ""), x, y);
    }
}

#[test]
fn a_viewport_has_the_size_of_the_one_around_it() {
    let inner = format!("<svg viewBox='0 0 10 10' preserveAspectRatio='none'>{PATH}</svg>");
    for outer in [
        "viewBox='0 0 200 100'",
        "width='200' height='100'",
        "width='7' height='7' viewBox='5 5 200 100'",
        "viewBox=' 5-5,200 ,\n100 '",
    ] {
        near(&format!("<svg {outer}>{inner}</svg>"), 60.0, 40.0);
    }
    for unknown in [
        "",
        "width='200'",
        "viewBox='0 0 0 5'",
        "viewBox='0 0 5 0'",
        "viewBox='0 0 5'",
        "viewBox='0 0 5 5 5'",
        "viewBox='0 0 inf 5'",
        "viewBox='0 0 1e999 5'",
        "viewBox='0 0 5,,5'",
        "viewBox='0 0 5 5,'",
    ] {
        assert_eq!(
            placed(&format!("<svg {unknown}>{inner}</svg>")),
            None,
            "{unknown}"
        );
    }
    let between = "<svg width='100' height='50' viewBox='0 0 10 10'>";
    near(&format!("<svg>{between}{inner}</svg></svg>"), 40.0, 20.0);
    let without = "<svg x='10' y='20' width='100' height='50'>";
    near(&format!("<svg>{without}{PATH}</svg></svg>"), 13.0, 24.0);
    near(&format!("<svg>{without}{inner}</svg></svg>"), 40.0, 40.0);
    // The first `svg` is the outermost one, whatever stands around it.
    near(
        &format!("<g><svg x='9' width='100' height='50' viewBox='0 0 1 1'>{PATH}</svg></g>"),
        3.0,
        4.0,
    );
}

/// A quarter turn about (x, y) takes (3, 4) to (x + y - 4, y - x + 3).
#[test]
fn a_transform_has_its_origin() {
    let text = |origin: &str, size: &str| {
        format!(
            "<svg {size}><path transform='rotate(90)' transform-origin='{origin}' d='M3 4L5 5'/></svg>"
        )
    };
    for (origin, x, y) in [
        ("10 20", 10.0, 20.0),
        ("10px 20px", 10.0, 20.0),
        ("left top", 0.0, 0.0),
        ("top left", 0.0, 0.0),
        ("right bottom", 200.0, 100.0),
        ("bottom right", 200.0, 100.0),
        ("center", 100.0, 50.0),
        ("center left", 0.0, 50.0),
        ("top center", 100.0, 0.0),
        ("bottom", 100.0, 100.0),
        ("10", 10.0, 50.0),
        ("25% 10%", 50.0, 10.0),
        ("TOP", 100.0, 0.0),
        ("right 7px", 200.0, 7.0),
    ] {
        near(
            &text(origin, "viewBox='0 0 200 100'"),
            x + y - 4.0,
            y - x + 3.0,
        );
    }
    near(&text("left top", ""), -4.0, 3.0);
    for origin in ["center", "right top", "10", "50% 1", "1 2 3", "a b"] {
        assert_eq!(placed(&text(origin, "")), None, "{origin}");
    }
    for origin in [
        "left right",
        "top bottom",
        "top 7",
        "7 left",
        "inf% 0",
        "NaN% 0",
        "1e999 0",
        "5%% 0",
    ] {
        let sized = text(origin, "viewBox='0 0 200 100'");
        assert_eq!(placed(&sized), None, "{origin}");
    }
}

#[test]
fn units_stand_where_css_has_them() {
    let path = |transform: &str| format!("<svg><path transform='{transform}' d='M3 4L5 5'/></svg>");
    for (transform, x, y) in [
        ("translate(5px, 6px)", 8.0, 10.0),
        ("rotate(90deg) , translate(1px)", -4.0, 4.0),
        ("skewX(45deg)scale(2)", 14.0, 8.0),
    ] {
        near(&path(transform), x, y);
    }
    for transform in [
        "scale(2deg)",
        "scale(2px)",
        "matrix(1 0 0 1 0 0px)",
        "translate(5deg)",
        "rotate(5px)",
        "translate(px5)",
        "rotate(1rad)",
    ] {
        assert_eq!(placed(&path(transform)), None, "{transform}");
    }
}

#[test]
fn what_is_not_read_is_refused() {
    let style = |style: &str| format!("<svg><path style='{style}' d='M3 4L5 5'/></svg>");
    for said in [
        "translate:none",
        "rotate : none",
        "transform:none",
        "transform:scale(1);transform-box:fill-box",
    ] {
        near(&style(said), 3.0, 4.0);
    }
    near(
        &style("transform:scale(2);transform-origin:1px 1px;transform-box:view-box"),
        5.0,
        7.0,
    );
    for said in [
        "translate:1px",
        "rotate:5deg",
        "scale:2",
        "offset-path:none;offset-path:path(\"\")",
        "offset:path(\"M1 1\") 50%",
        "transform:scale(2);transform-box:fill-box",
        "transform:scale(2);transform-origin:1px 1px;transform-box:fill-box",
    ] {
        assert_eq!(placed(&style(said)), None, "{said}");
    }
}
