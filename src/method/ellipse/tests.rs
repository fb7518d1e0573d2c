//! What the search costs, axes that are turned, the smallest peaks, and what the free variant does not serve.

use super::*;

/// The steps until all has settled, from the start to first order or, off the ellipse, from the best on it.
fn steps(segment: &EllipseSegment, span: &Span) -> usize {
    let (mut fit, mut times) = if segment.is_free {
        let on_ellipse = EllipseSegment {
            is_free: false,
            ..*segment
        };
        let best = on_ellipse.fit(span).unwrap();
        let fit = FittedHandles {
            peak: FREE_PEAK * best.peak,
            ..best
        };
        let times = segment.extremes(&segment.cubic(&fit)).unwrap();
        (fit, times)
    } else {
        segment.start([minimax::handle(span); 2]).unwrap()
    };
    for step in 1..=MOST_STEPS {
        let (next, has_settled) = segment.step(&fit, &mut times).unwrap();
        if has_settled {
            return step;
        }
        fit = next;
    }
    MOST_STEPS
}

#[test]
fn a_search_takes_three_steps_or_so() {
    let mut taken = [0; 2];
    let mut searches = 0;
    for short in [0.9, 0.5, 0.2, 0.1] {
        for size in [30.0, 60.0, 90.0, 120.0] {
            for from in (0..180).step_by(10).map(f64::from) {
                let segment = EllipseSegment::new(short, from, size, false);
                taken[0] += steps(&segment, &Span::from_degrees(size));
                searches += 1;
            }
        }
    }
    for short in (2..100).map(|percent| f64::from(percent) / 100.0) {
        let segment = EllipseSegment::new(short, 0.0, 90.0, true);
        taken[1] += steps(&segment, &Span::from_degrees(90.0));
    }
    assert!(
        taken[0] <= 2 * searches && taken[1] <= 430,
        "{taken:?} of {searches}"
    );
}

/// The control points depend on where a segment lies on the ellipse, not on what its angles are counted from.
#[test]
fn axes_may_lie_at_any_angle() {
    let quarters = [0.0, 90.0, 180.0, 270.0, 360.0];
    for (method, angles) in [
        (Method::MinimaxEllipseFree, quarters),
        (Method::MinimaxEllipse, [10.0, 80.0, 190.0, 240.0, 370.0]),
    ] {
        for sign in [1.0, -1.0] {
            let at = |angle: f64| {
                let axes = Axes { short: 0.3, angle };
                let angles = angles.map(|degrees| sign * degrees + angle);
                pieces(method, axes, &angles, true).unwrap()
            };
            let known = at(0.0);
            for angle in [30.0, 45.0, 90.0, -60.0] {
                // The other axis is the short one where they are a right angle apart.
                assert_eq!(at(angle), known, "{method} {angle}");
            }
        }
    }
}

#[test]
fn the_free_variant_serves_closed_quarters_on_the_axes_only() {
    let axes = Axes {
        short: 0.5,
        angle: 0.0,
    };
    let serves = |angles: &[f64], is_closed| {
        pieces(Method::MinimaxEllipseFree, axes, angles, is_closed).is_ok()
    };
    let quarters = [0.0, 90.0, 180.0, 270.0, 360.0];
    assert!(serves(&quarters, true));
    assert!(!serves(&quarters, false));
    assert!(!serves(&[0.0, 90.0, 180.0, 270.0], true));
    assert!(!serves(&quarters.map(|angle| angle + 10.0), true));
}

/// Peaks fall as the sixth power of the angle, beyond what the search can resolve too.
#[test]
fn the_smallest_peaks_follow_the_law() {
    for short in [0.2, 0.5, 0.9] {
        for middle in [20.0, 45.0, 70.0] {
            let peak = |size: f64| peak(short, middle - size / 2.0, size).unwrap();
            let (small, large) = (peak(2.4), peak(4.0));
            assert!(small < FINEST);
            let law = large * (2.4_f64 / 4.0).powi(6);
            assert!(
                (small / law - 1.0).abs() < 0.006,
                "{short} {middle}: {small:e} {law:e}"
            );
        }
    }
}
