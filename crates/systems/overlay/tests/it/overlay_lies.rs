//! Tests with a session whose signs mean nothing: every loop of the algorithm ends, and broken rules are told.

use predicament_overlay::algorithm::overlay::{Method, Operation, Polygon, Region, Rule, combine, overlay};
use predicament_predicates::{Axis, Construction, Predicates, Refused, Scene, Sign, Vertex};

use crate::common::liar::Liar;
use crate::overlay::{Numbers, polygon};

/// A session with meaningless signs and arbitrary vertices.
struct Lies<'s> {
    liar: Liar<'s>,
    own: Scene,
}

impl Predicates for Lies<'_> {
    fn scene(&self) -> &Scene {
        &self.own
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.own.construct_all(definitions, |_, _| Ok(()))
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.liar.compare(axis, a, b)
    }

    predicament_predicates::forward_to!(liar: orient2d, orient3d, incircle, insphere);
}

#[test]
fn signs_that_mean_nothing_end() {
    let mut broken = 0;
    for seed in 0..60 {
        let mut numbers = Numbers(seed);
        let scene = Scene::from_points2(&numbers.points(30, 12)).unwrap();
        let operands = [(); 2].map(|()| polygon(&mut numbers, scene.len(), Rule::EvenOdd));
        for method in [Method::Grid, Method::Sweep] {
            let liar = Liar { scene: &scene, seed, zeros: 3 + seed };
            let mut session = Lies { liar, own: scene.clone() };
            let made = overlay(&mut session, [&operands[0], &operands[1]], method).unwrap();
            for operation in Operation::ALL {
                let of_result = made.regions(operation).broken;
                broken += usize::from(made.arrangement.broken.or(of_result).is_some());
            }
        }
    }
    assert!(broken > 200, "{broken}");
}

#[test]
fn combining_by_signs_that_mean_nothing_ends_and_is_told() {
    let (mut broken, mut of_arrangement) = (0, 0);
    for seed in 0..60 {
        let mut numbers = Numbers(seed);
        let scene = Scene::from_points2(&numbers.points(30, 12)).unwrap();
        let lies = || Lies { liar: Liar { scene: &scene, seed, zeros: 3 + seed }, own: scene.clone() };
        let one = polygon(&mut numbers, scene.len(), Rule::EvenOdd);
        let mut session = lies();
        let made = overlay(&mut session, [&Polygon::default(), &one], Method::Grid).unwrap();
        for operation in Operation::ALL {
            let wanted = made.arrangement.broken.or(made.regions(operation).broken);
            let found = combine(&mut lies(), &[], &one, operation, Method::Grid).unwrap();
            assert_eq!(found.broken, wanted, "seed {seed}, {}", operation.name());
        }
        of_arrangement += usize::from(made.arrangement.broken.is_some());
        let mut session = lies();
        let mut current: Vec<Region> = Vec::new();
        for step in 0..8 {
            let second = polygon(&mut numbers, scene.len(), Rule::NonZero);
            let made = combine(&mut session, &current, &second, Operation::ALL[step % 4], Method::Grid).unwrap();
            broken += usize::from(made.broken.is_some());
            current = made.regions;
        }
    }
    assert!(of_arrangement > 20 && broken > 200, "{of_arrangement} and {broken}");
}
