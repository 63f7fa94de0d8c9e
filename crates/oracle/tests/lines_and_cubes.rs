//! Cells of a line and unions of cubes: what a backend gets wrong is found, and classed by its promise.

use std::sync::atomic::AtomicBool;

use predicament_corpus::{Cache, Level, Library, LoadedScene};
use predicament_oracle::signs::Budget;
use predicament_oracle::{Case, Class, Contestant, Entry, Outcome, Watch, roster};
use predicament_predicates::{
    Axis, Backend, Contract, Declined, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex, ZeroMeaning,
};

/// Compares by coordinates, then as it is told: by what is left of the tie, the two numbers.
struct ByRule {
    zero: ZeroMeaning,
    rule: fn([f64; 2], [usize; 2]) -> Sign,
}

struct Session<'s> {
    scene: &'s Scene,
    rule: fn([f64; 2], [usize; 2]) -> Sign,
}

impl Backend for ByRule {
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        "by rule".to_owned()
    }
    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: self.zero, proved: false }
    }
    fn stages(&self) -> &'static [&'static str] {
        &[]
    }
    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Session<'s>, Declined> {
        Ok(Session { scene, rule: self.rule })
    }
}

impl Predicates for Session<'_> {
    fn scene(&self) -> &Scene {
        self.scene
    }
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        (self.rule)([a, b].map(|v| self.scene.coordinate(axis, v)), [a.index(), b.index()])
    }
    fn orient2d(&self, _: Plane, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("nobody asks")
    }
    fn orient3d(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("nobody asks")
    }
    fn incircle(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("nobody asks")
    }
    fn insphere(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("nobody asks")
    }
}

fn order(a: f64, b: f64) -> Sign {
    Sign::from(a.total_cmp(&b))
}

fn smaller_is_further([a, b]: [f64; 2], [i, j]: [usize; 2]) -> Sign {
    Sign::from(a.total_cmp(&b).then(j.cmp(&i)))
}

fn larger_is_further([a, b]: [f64; 2], [i, j]: [usize; 2]) -> Sign {
    Sign::from(a.total_cmp(&b).then(i.cmp(&j)))
}

fn load(name: &str) -> LoadedScene {
    let library = Library::embedded().unwrap();
    let scene = library.suites().iter().flat_map(|suite| &suite.scenes).find(|scene| scene.name == name);
    scene.expect("a scene of the corpora").load(Level::Quick, &Cache::new("nowhere")).unwrap()
}

fn judged(name: &str, contestant: &dyn Contestant) -> Outcome {
    let (cancel, silent) = (AtomicBool::new(false), |_| {});
    let watch = Watch::new(&cancel, None, &silent);
    let loaded = load(name);
    Case::new(&loaded, &watch).unwrap().run(contestant, Budget::QUICK, &watch).unwrap()
}

fn by_rule(name: &str, zero: ZeroMeaning, rule: fn([f64; 2], [usize; 2]) -> Sign) -> Outcome {
    judged(name, &Entry::new(ByRule { zero, rule }))
}

/// Classes that occur, with their checks.
fn checks(outcome: &Outcome) -> Vec<(Class, &str)> {
    let mut checks: Vec<_> = outcome.findings.iter().map(|finding| (finding.class, finding.check.as_str())).collect();
    checks.sort_unstable_by_key(|(class, check)| (*class as usize, *check));
    checks.dedup();
    checks
}

#[test]
fn honest_backends_are_clean_on_lines() {
    for name in ["three-cells", "no-length", "neighbours", "cells-uniform-interval", "cells-degen-interval"] {
        for backend in ["exact", "sos", "sos:edelsbrunner-mucke", "naive", "shewchuk"] {
            let outcome = judged(name, roster::backend(backend).unwrap().as_ref());
            assert_eq!(checks(&outcome), [], "{backend} on {name}");
            let ties = outcome.counts.get(Class::TieBroken);
            assert_eq!(ties > 0, backend.starts_with("sos"), "{backend} on {name}");
            assert_eq!(outcome.counts.get(Class::Agree) + ties, outcome.queries);
        }
        assert_eq!(checks(&by_rule(name, ZeroMeaning::Never, smaller_is_further)), []);
    }
}

#[test]
fn each_way_to_be_wrong_on_a_line_has_its_class() {
    let exact = |[a, b]: [f64; 2], _: [usize; 2]| order(a, b);
    // One point of three-cells that is at an end is said to be beyond it, against any promise.
    let never = by_rule("three-cells", ZeroMeaning::Never, exact);
    assert_eq!(checks(&never), [(Class::Inconsistent, "never zero")]);
    let broken = by_rule("three-cells", ZeroMeaning::Exact, smaller_is_further);
    assert_eq!(checks(&broken), [(Class::MissedZero, "cells")]);
    let near = |[a, b]: [f64; 2], _: [usize; 2]| if (a - b).abs() < 1e-9 { Sign::Zero } else { order(a, b) };
    let near = by_rule("cells-uniform-interval", ZeroMeaning::Exact, near);
    assert_eq!(checks(&near), [(Class::Overreach, "cells")]);
    // Everything above 0.5 is taken for less by 0.1: in the wrong cell, but in one.
    let shifted = |[a, b]: [f64; 2], [i, j]: [usize; 2]| {
        let probe = |x: f64, at: usize| if at < 402 && x > 0.5 { x - 0.1 } else { x };
        order(probe(a, i), probe(b, j))
    };
    let shifted = by_rule("cells-uniform-interval", ZeroMeaning::Exact, shifted);
    assert!(checks(&shifted).contains(&(Class::SignFlip, "cells")), "{:?}", checks(&shifted));
    // Ties broken the other way: a partition where no end is repeated, but not the promised one.
    let other = by_rule("three-cells", ZeroMeaning::Never, larger_is_further);
    assert_eq!(checks(&other), [(Class::SignFlip, "half-open rule")]);
    // … and none where ends are.
    let other = by_rule("no-length", ZeroMeaning::Never, larger_is_further);
    assert!(checks(&other).contains(&(Class::Topology, "double")), "{:?}", checks(&other));
    // Ties by place: right of one cell's end and left of the next one's beginning, or in both.
    let up = |[a, b]: [f64; 2], _: [usize; 2]| if a >= b { Sign::Positive } else { Sign::Negative };
    assert!(checks(&by_rule("three-cells", ZeroMeaning::Never, up)).contains(&(Class::Topology, "double")));
    let down = |[a, b]: [f64; 2], _: [usize; 2]| if a > b { Sign::Positive } else { Sign::Negative };
    assert!(checks(&by_rule("three-cells", ZeroMeaning::Never, down)).contains(&(Class::Topology, "gap")));
    // An order with a cycle: a probe beyond the last end, and left of the one before.
    let cycle = |[a, b]: [f64; 2], [i, j]: [usize; 2]| match (i, j) {
        (2, 10) | (9, 2) => Sign::Positive,
        (10, 2) | (2, 9) => Sign::Negative,
        _ => smaller_is_further([a, b], [i, j]),
    };
    assert_eq!(checks(&by_rule("three-cells", ZeroMeaning::Never, cycle)), [(Class::Topology, "stray")]);
}

#[test]
fn unions_are_measured_as_their_ties_are_broken() {
    for name in ["one", "corner-in-corner", "common-face", "twins", "slide", "cubes-degen-cube-union"] {
        for backend in ["sos", "sos:edelsbrunner-mucke"] {
            let outcome = judged(name, roster::backend(backend).unwrap().as_ref());
            assert_eq!((checks(&outcome), outcome.counts.get(Class::Agree)), (vec![], outcome.queries), "{name}");
        }
        assert_eq!(checks(&by_rule(name, ZeroMeaning::Never, smaller_is_further)), []);
    }
    let mass = judged("corner-in-corner", roster::backend("exact").unwrap().as_ref()).mass.unwrap();
    assert_eq!((mass.found, mass.truth), ([15., 42., 48.], [15., 42., 48.]));
    assert_eq!((mass.cubes, mass.vertices), (2, [14, 6, 0]));
    let off_grid = judged("off-grid", roster::backend("exact").unwrap().as_ref());
    assert_eq!(checks(&off_grid), []);
    let mass = off_grid.mass.unwrap();
    assert!((mass.found[0] - 0.125).abs() < 1e-9 && mass.found[0] > 0.125, "in the scene's units: {mass:?}");
}

#[test]
fn each_sum_over_a_union_can_be_found_wrong() {
    // Closed twins cover each other's corners.
    let exact = judged("twins", roster::backend("exact").unwrap().as_ref());
    let found: Vec<&str> = checks(&exact).iter().map(|(_, check)| *check).collect();
    assert_eq!(found, ["area", "edge length", "volume"]);
    assert_eq!(exact.mass.unwrap().vertices[0], 0, "every corner is in another cube");
    // Moved the other way two cubes part that should be one: the same volume, with other walls.
    let other = by_rule("common-face", ZeroMeaning::Never, larger_is_further);
    let found: Vec<&str> = checks(&other).iter().map(|(_, check)| *check).collect();
    assert_eq!(found, ["area", "vertices"]);
    // Ties by place are no perturbation at all: some corners are in, others out.
    let up = |[a, b]: [f64; 2], _: [usize; 2]| if a >= b { Sign::Positive } else { Sign::Negative };
    let up = by_rule("slide", ZeroMeaning::Never, up);
    assert!(checks(&up).contains(&(Class::Topology, "euler characteristic")), "{:?}", checks(&up));
}
