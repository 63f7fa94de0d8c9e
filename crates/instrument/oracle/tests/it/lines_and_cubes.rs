//! Cells of a line and unions of cubes: errors of a backend are detected, and classified by its promise.

use predicament_corpus::Suite;
use predicament_cube_union::task::MassRow;
use predicament_formats::Manifest;
use predicament_predicates::{
    Axis, Backend, Contract, Declined, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex, ZeroMeaning,
};
use predicament_records::Row;
use predicament_tasks::{Class, Outcome};

use crate::common::{checks, judged, judged_by_name, load, loaded};

/// A backend that compares by a rule over two coordinates and, for ties, two vertex numbers.
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

fn by_rule(name: &str, zero: ZeroMeaning, rule: fn([f64; 2], [usize; 2]) -> Sign) -> Outcome {
    judged(&load(name), &predicament_bundle::entry(ByRule { zero, rule }))
}

/// The measures that a backend computed for a union, by column name of its table row.
fn mass(outcome: &Outcome) -> impl Fn(&str) -> f64 + use<> {
    let fields = outcome.rows[0].fields.clone();
    move |column| {
        let place = MassRow::COLUMNS.iter().position(|name| *name == column).unwrap();
        fields[place].parse().unwrap()
    }
}

#[test]
fn honest_backends_are_clean_on_lines() {
    for name in ["three-cells", "no-length", "neighbours", "cells-uniform-interval", "cells-degen-interval"] {
        for backend in ["exact", "sos", "sos:edelsbrunner-mucke", "naive", "shewchuk"] {
            let outcome = judged_by_name(&load(name), backend);
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
    // One point of three-cells at an end is reported beyond it, against every promise.
    let never = by_rule("three-cells", ZeroMeaning::Never, exact);
    assert_eq!(checks(&never), [(Class::Inconsistent, "never zero")]);
    let broken = by_rule("three-cells", ZeroMeaning::Exact, smaller_is_further);
    assert_eq!(checks(&broken), [(Class::MissedZero, "cells")]);
    let near = |[a, b]: [f64; 2], _: [usize; 2]| if (a - b).abs() < 1e-9 { Sign::Zero } else { order(a, b) };
    let near = by_rule("cells-uniform-interval", ZeroMeaning::Exact, near);
    assert_eq!(checks(&near), [(Class::Overreach, "cells")]);
    // Probes above 0.5 are compared as if smaller by 0.1: each is in a wrong cell, but in exactly one.
    let shifted = |[a, b]: [f64; 2], [i, j]: [usize; 2]| {
        let probe = |x: f64, at: usize| if at < 402 && x > 0.5 { x - 0.1 } else { x };
        order(probe(a, i), probe(b, j))
    };
    let shifted = by_rule("cells-uniform-interval", ZeroMeaning::Exact, shifted);
    assert!(checks(&shifted).contains(&(Class::SignFlip, "cells")), "{:?}", checks(&shifted));
    // Ties broken the other way: without repeated ends this is a partition, but not the promised one.
    let other = by_rule("three-cells", ZeroMeaning::Never, larger_is_further);
    assert_eq!(checks(&other), [(Class::SignFlip, "half-open rule")]);
    // … and not a partition with repeated ends.
    let other = by_rule("no-length", ZeroMeaning::Never, larger_is_further);
    assert!(checks(&other).contains(&(Class::Topology, "double")), "{:?}", checks(&other));
    // Ties by position: right of one cell's end and left of the next one's beginning, or in both.
    let up = |[a, b]: [f64; 2], _: [usize; 2]| if a >= b { Sign::Positive } else { Sign::Negative };
    assert!(checks(&by_rule("three-cells", ZeroMeaning::Never, up)).contains(&(Class::Topology, "double")));
    let down = |[a, b]: [f64; 2], _: [usize; 2]| if a > b { Sign::Positive } else { Sign::Negative };
    assert!(checks(&by_rule("three-cells", ZeroMeaning::Never, down)).contains(&(Class::Topology, "gap")));
    // An order with a cycle: a probe beyond the last end, and left of the previous end.
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
        for backend in ["sos", "sos:edelsbrunner-mucke", "exact", "tolerance", "naive", "shewchuk"] {
            let outcome = judged_by_name(&load(name), backend);
            assert_eq!((checks(&outcome), outcome.counts.get(Class::Agree)), (vec![], outcome.queries), "{name}");
        }
        assert_eq!(checks(&by_rule(name, ZeroMeaning::Never, smaller_is_further)), []);
    }
    let two = mass(&judged_by_name(&load("corner-in-corner"), "exact"));
    assert_eq!(["volume", "area", "edge_length"].map(&two), [15., 42., 48.]);
    assert_eq!(two("true_volume"), 15.);
    assert_eq!(["cubes", "corners", "edge_faces", "three_faces"].map(&two), [2., 14., 6., 0.]);
    let off_grid = judged_by_name(&load("off-grid"), "exact");
    assert_eq!(checks(&off_grid), []);
    let volume = mass(&off_grid)("volume");
    assert!((volume - 0.125).abs() < 1e-9 && volume > 0.125, "in the scene's units: {volume}");
}

#[test]
fn each_sum_over_a_union_can_be_found_wrong() {
    // A backend that promises zeros is expected to have the union of closed cubes.
    assert_eq!(checks(&by_rule("twins", ZeroMeaning::Exact, |[a, b], _| order(a, b))), []);
    let broken = by_rule("twins", ZeroMeaning::Exact, smaller_is_further);
    let found: Vec<&str> = checks(&broken).iter().map(|(_, check)| *check).collect();
    assert_eq!(found, ["edge length", "vertices"], "stairs instead of edges");
    let tied = by_rule("common-face-apart", ZeroMeaning::Never, |[a, b], _| order(a, b));
    let found: Vec<&str> = checks(&tied).iter().map(|(_, check)| *check).collect();
    assert_eq!(found, ["area", "edge length", "vertices"], "closed cubes do not part");
    // Moved the other way, two cubes separate that should join: the same volume, with other walls.
    let other = by_rule("common-face", ZeroMeaning::Never, larger_is_further);
    let found: Vec<&str> = checks(&other).iter().map(|(_, check)| *check).collect();
    assert_eq!(found, ["area", "vertices"]);
    // Ties by position are not a perturbation: some corners are inside, others outside.
    let up = |[a, b]: [f64; 2], _: [usize; 2]| if a >= b { Sign::Positive } else { Sign::Negative };
    let up = by_rule("slide", ZeroMeaning::Never, up);
    assert!(checks(&up).contains(&(Class::Topology, "euler characteristic")), "{:?}", checks(&up));
}

/// More cubes than the judge measures as a whole: an error in the measured part is detected.
#[test]
fn a_part_of_many_cubes_can_be_found_wrong() {
    let cubes: Vec<String> =
        (0..405).map(|i| format!("[{}, {}, {}, 3]", 2 * (i % 9), 3 * (i / 9 % 9), 4 * (i / 81))).collect();
    let text =
        format!("title = \"t\"\n[[scene]]\nname = \"many\"\ntask = \"cube-union\"\ncubes = [{}]\n", cubes.join(", "));
    let suite = Suite::parse(predicament_bundle::vocabulary(), "many", &text, None, &Manifest::default()).unwrap();
    let many = loaded(&suite.scenes[0]);
    assert_eq!(checks(&judged_by_name(&many, "sos")), []);
    assert_eq!(checks(&judged_by_name(&many, "exact")), []);
    let found = judged_by_name(&many, "fault:compare-greater-on-ties");
    assert!(checks(&found).contains(&(Class::Topology, "part")), "{:?}", checks(&found));
    let broken =
        judged(&many, &predicament_bundle::entry(ByRule { zero: ZeroMeaning::Exact, rule: smaller_is_further }));
    assert!(checks(&broken).contains(&(Class::Topology, "part")), "{:?}", checks(&broken));
}
