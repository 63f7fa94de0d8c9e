//! Predicates from formulas in a session: the static filter of the scene never changes a sign.

use predicament_exact::{Exact, derived::static_bound, stage};
use predicament_predicates::formula::{Definition, Formula};
use predicament_predicates::{Backend, Derived, Dimension, Off, Predicates, Scene, Sign, Vertex};

use crate::common::Random;

/// Asks a session about queries, and compares it with exact arithmetic alone; counts queries by stage, and those whose
/// estimate has the wrong sign.
fn ask(scene: &Scene, derived: Derived, queries: &[Vec<Vertex>]) -> ([usize; 7], usize) {
    let session = Exact.prepare(scene, Off).unwrap();
    let (mut stages, mut wrong) = ([0; 7], 0);
    for query in queries {
        let (sign, stage) = session.decide_derived(derived, query);
        let (truth, value) = derived.with_points(scene, query, |points| {
            (Sign::from(derived.formula().unfiltered(points).0), derived.formula().value(points))
        });
        assert_eq!((sign, session.sign(derived, query)), (truth, truth), "{} {query:?} at {stage}", derived.name());
        stages[stage] += 1;
        wrong += usize::from(Sign::of(value) != truth);
    }
    (stages, wrong)
}

fn queries(scene: &Scene, derived: Derived, count: usize, random: &mut Random) -> Vec<Vec<Vertex>> {
    let one = |random: &mut Random| Vertex::input(random.below(scene.len()));
    (0..count).map(|_| (0..derived.arity()).map(|_| one(random)).collect()).collect()
}

#[test]
fn most_queries_about_random_points_are_settled_by_the_bound_of_the_scene() {
    let mut random = Random(3);
    for &derived in Derived::shipped() {
        let count = derived.dimension().count();
        for points in [50, 3000] {
            let coordinates = (0..points * count).map(|_| random.unit()).collect();
            let weights = (0..points).map(|_| random.unit() / 64.0).collect();
            let scene = Scene::new(derived.dimension(), coordinates).unwrap().with_weights(weights).unwrap();
            let queries = queries(&scene, derived, 300, &mut random);
            // A vertex that occurs twice makes many a formula zero.
            let (stages, _) = ask(&scene, derived, &queries);
            assert!(stages[stage::STATIC] > 200, "{}: {stages:?}", derived.name());
        }
    }
}

/// Weights that make lifted points nearly coplanar, and much larger than the coordinates.
#[test]
fn bounds_cover_weights() {
    let mut random = Random(5);
    let derived = Derived::named("side_of_power_circle").unwrap();
    let points: Vec<[f64; 2]> = (0..60).map(|_| [random.unit(), random.unit()]).collect();
    let weights = points.iter().map(|[x, y]| x * x + y * y - 1e6 * (x - 0.7 * y)).collect();
    let scene = Scene::new(Dimension::Two, points.concat()).unwrap().with_weights(weights).unwrap();
    let (stages, wrong) = ask(&scene, derived, &queries(&scene, derived, 2000, &mut random));
    assert!(wrong > 100 && stages[stage::STATIC] < 100, "{wrong} {stages:?}");
}

/// Points far from the origin, nearly on one line through it; the formula reads coordinates and not differences.
#[test]
fn bounds_cover_coordinates_that_are_larger_than_their_differences() {
    let mut random = Random(7);
    let formula = Formula::new(Definition::anonymous("a.x*b.y - a.y*b.x")).unwrap();
    let derived = Derived::new(formula).unwrap();
    let points: Vec<[f64; 2]> = (0..60).map(|_| 1e6 + random.unit()).map(|x| [x, x * 0.3]).collect();
    let scene = Scene::new(Dimension::Two, points.concat()).unwrap();
    let (stages, wrong) = ask(&scene, derived, &queries(&scene, derived, 2000, &mut random));
    assert!(wrong > 100 && stages[stage::STATIC] < 100, "{wrong} {stages:?}");
}

/// One point far away makes the bound of the scene useless; more formulas than bounds are kept.
#[test]
fn a_useless_bound_is_not_asked_and_formulas_without_a_slot_go_on() {
    let mut random = Random(9);
    let mut coordinates: Vec<f64> = (0..6000).map(|_| random.unit()).collect();
    coordinates[0] = 1e30;
    let scene = Scene::new(Dimension::Two, coordinates).unwrap();
    let derived = Derived::named("side_of_bisector").unwrap();
    let near: Vec<Vec<Vertex>> = queries(&scene, derived, 300, &mut random);
    let near: Vec<_> = near.into_iter().filter(|query| query.iter().all(|v| v.index() > 0)).collect();
    assert_eq!(ask(&scene, derived, &near).0[stage::STATIC], 0);
    assert!(static_bound(&scene, derived) > 1e30);

    let scene = Scene::new(Dimension::Two, (0..40).map(|_| random.unit()).collect()).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    let query = [0, 1].map(Vertex::input);
    let stages: Vec<usize> = (1..=9)
        .map(|factor| {
            let definition = Definition::anonymous(&format!("{factor}*a.x - {factor}*b.x + b.y*b.y"));
            let derived = Derived::new(Formula::new(definition).unwrap()).unwrap();
            session.decide_derived(derived, &query).1
        })
        .collect();
    assert_eq!(stages[..8], [stage::STATIC; 8]);
    assert_eq!(stages[8], stage::SEMI_STATIC);
}
