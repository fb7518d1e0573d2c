use super::*;

#[test]
fn products_and_differences_are_those_of_the_values() {
    let (p, q) = (
        Polynomial::new(&[1.0, -2.0, 3.0, 0.5]),
        Polynomial::new(&[0.5, 4.0]),
    );
    for i in 0..=10 {
        let t = f64::from(i) / 10.0;
        assert!((p.times(&q).at(t) - p.at(t) * q.at(t)).abs() < 1e-14);
        assert!((p.minus(&q).at(t) - (p.at(t) - q.at(t))).abs() < 1e-14);
    }
}

#[test]
fn roots_at_the_ends_and_in_the_middle_and_double_ones_are_told_apart() {
    let product = |roots: &[f64]| {
        roots.iter().fold(Polynomial::new(&[1.0]), |p, root| {
            p.times(&Polynomial::new(&[-root, 1.0 - root]))
        })
    };
    let found = |roots: &[f64]| product(roots).sign_changes().iter().collect::<Vec<_>>();
    let near = |a: &[f64], b: &[f64], by: f64| {
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= by)
    };
    assert!(near(&found(&[0.0, 0.5, 1.0]), &[0.5], 1e-15));
    assert!(near(&found(&[0.5, 0.5]), &[], 0.0));
    assert!(near(&found(&[0.25, 0.25, 0.75]), &[0.75], 1e-15));
    assert!(near(&found(&[0.5, 0.5, 0.5]), &[0.5], 1e-4));
    assert!(near(&found(&[0.0, 0.0, 0.3, 1.0, 1.0]), &[0.3], 1e-15));
    assert!(near(
        &found(&[0.1, 0.101, 0.5, 0.9]),
        &[0.1, 0.101, 0.5, 0.9],
        1e-12
    ));
    assert!(near(&found(&[-0.1, 1.1]), &[], 0.0));
}

#[test]
fn all_six_roots_are_found() {
    // T6(2t - 1), whose roots are known.
    let chebyshev = Polynomial::new(&[1.0, -11.0, 33.0, -231.0 / 5.0, 33.0, -11.0, 1.0]);
    let found: Vec<f64> = chebyshev.sign_changes().iter().collect();
    assert_eq!(found.len(), 6);
    for (k, t) in found.iter().rev().enumerate() {
        let angle = core::f64::consts::PI * (2.0 * k as f64 + 1.0) / 12.0;
        assert!((2.0 * t - 1.0 - angle.cos()).abs() < 1e-14);
    }
}

#[test]
fn roots_beside_known_places_are_those_found_by_cutting() {
    let places = [-0.125, 0.0, 0.08, 0.34, 0.66, 0.92, 1.0, 1.125];
    let mut told = 0;
    for i in 0..2000 {
        let near = |at: f64, by: f64, k: usize| at + by * ((i * k % 1009) as f64 / 504.5 - 1.0);
        let roots = [
            [near(0.0, 0.03, 7), 0.0][usize::from(i % 5 == 0)],
            near(0.19, 0.14, 11),
            near(0.5, 0.1, 17),
            near(0.8, 0.1, 23),
            near(1.0, 0.05, 29),
        ];
        let product = roots.iter().fold(Polynomial::new(&[1.0]), |p, root| {
            p.times(&Polynomial::new(&[-root, 1.0 - root]))
        });
        let cut: Vec<f64> = product.sign_changes().iter().collect();
        let Some(between) = product.sign_changes_between(&places) else {
            continue;
        };
        told += 1;
        let inside = |t: &f64| (1e-9..1.0 - 1e-9).contains(t);
        let between: Vec<f64> = between.iter().filter(inside).collect();
        let cut: Vec<f64> = cut.into_iter().filter(inside).collect();
        assert_eq!(between.len(), cut.len(), "{roots:?}");
        for (a, b) in between.iter().zip(&cut) {
            assert!((a - b).abs() < 1e-13, "{roots:?}: {a} {b}");
        }
    }
    assert!(told > 1000, "{told}");
    // One root fewer is not told from it.
    let few = Polynomial::new(&[-1.0, 1.0]);
    assert!(few.times(&few).sign_changes_between(&places).is_none());
}
