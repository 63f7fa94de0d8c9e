//! The counts of a cascade's samples, counted independently.

use std::collections::{BTreeMap, BTreeSet};

use predicament_exact::Exact as Backend;
use predicament_judge::{nearest, rational};
use predicament_overlay::algorithm::overlay::{Edge, Method, Polygon, Region, Rule, combine, overlay};
use predicament_predicates::{Backend as _, Construction, Off, Plane, Predicates as _, Scene, Vertex};
use predicament_studies::cascades::{Cascade, Cascades, Followed, Measured, Operand};
use predicament_studies::{Common, Study as _};
use rug::{Integer, Rational};

use crate::cascades::{Exact, cascades, exactly, measured};

type Loops = Vec<Vec<[f64; 2]>>;

fn of<'m>(measured: &'m Measured, name: &str) -> &'m Followed {
    measured.followed.iter().find(|one| one.method.to_string() == name).unwrap()
}

fn turn([a, b, p]: [&Exact; 3]) -> Rational {
    let minus = |p: &Exact, i: usize| Rational::from(&p[i] - &a[i]);
    minus(b, 0) * minus(p, 1) - minus(b, 1) * minus(p, 0)
}

/// The point where the lines of two edges meet.
fn meet([a, b]: [&Exact; 2], [c, d]: [&Exact; 2]) -> Exact {
    let [n, m] = [a, b].map(|p| turn([c, d, p]));
    let part = &n / Rational::from(&n - &m);
    [0, 1].map(|i: usize| Rational::from(&b[i] - &a[i]) * &part + &a[i])
}

/// The digits between the first and the last nonzero one; a denominator of 1 is not written.
fn digits(x: &Integer) -> usize {
    let text = x.to_string_radix(2);
    let digits = text.trim_start_matches('-').trim_end_matches('0').len();
    if digits == 1 { 0 } else { digits }
}

#[test]
fn two_squares_make_a_star_of_sixteen_corners() {
    let methods = ["exact", "sos", "naive", "exact+round", "exact+snap", "thick", "tolerance+contacts"];
    let found = measured(&cascades(Cascade::Rotate, &methods, 1));
    let (start, operands) = Cascade::Rotate.steps(1, 1);
    let [first, second] = [exactly(&start), exactly(&operands[0].corners)];
    let edges = |corners: &[Exact]| -> Vec<[Exact; 2]> {
        corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| [a.clone(), b.clone()]).collect()
    };
    let mut corners = [first.clone(), second.clone()].concat();
    for [a, b] in edges(&first) {
        for [c, d] in edges(&second) {
            let apart = |p: [&Exact; 3], q: [&Exact; 3]| turn(p).cmp0() == turn(q).cmp0();
            if !apart([&a, &b, &c], [&a, &b, &d]) && !apart([&c, &d, &a], [&c, &d, &b]) {
                corners.push(meet([&a, &b], [&c, &d]));
            }
        }
    }
    assert_eq!(corners.len(), 16);
    let bits = corners.iter().flatten().map(|x| digits(x.numer()) + digits(x.denom())).max().unwrap();
    for name in ["exact", "sos", "naive", "exact+round", "exact+snap", "thick:1e-9", "tolerance+contacts"] {
        let [sample] = of(&found, name).samples.as_slice() else { panic!("one step") };
        assert_eq!((sample.regions, sample.edges, sample.constructed), (1, 16, 8), "{name}");
        assert_eq!((sample.held, sample.collapsed, sample.lost), (16, 0, 0), "{name}");
        assert_eq!(sample.thickness > 0.0, name.starts_with("thick"), "{name}");
        let rounds = ["naive", "exact+round"].contains(&name);
        assert_eq!(sample.turned, rounds.then_some(0), "{name}");
        let is_exact = ["exact", "sos"].contains(&name);
        assert!(if is_exact { sample.bits as usize == bits } else { sample.bits <= 53 }, "{name}: {}", sample.bits);
    }
}

#[test]
fn what_is_held_and_constructed_adds_up() {
    let methods = ["exact", "naive", "exact+round", "exact+snap:8", "thick:0.0001", "tolerance+contacts"];
    let found = measured(&cascades(Cascade::Stars, &methods, 16));
    let (start, operands) = Cascade::Stars.steps(16, 1);
    let corners = || start.iter().chain(operands.iter().flat_map(|operand| &operand.corners));
    let inputs: BTreeSet<[u64; 2]> = corners().map(|corner| corner.map(f64::to_bits)).collect();
    for name in ["exact", "naive", "exact+round", "exact+snap:8", "thick:1e-4", "tolerance+contacts"] {
        let one = of(&found, name);
        assert!(one.ended.is_none() && one.samples.len() == 16, "{name}");
        for pair in one.samples.windows(2) {
            assert!(pair[0].constructed <= pair[1].constructed && pair[0].collapsed <= pair[1].collapsed, "{name}");
        }
        let last = one.samples.last().unwrap();
        assert!(last.constructed > one.samples[0].constructed, "{name}");
        assert_eq!(last.collapsed > 0, ["thick:1e-4", "tolerance+contacts"].contains(&name), "{name}");
        for sample in &one.samples {
            match name {
                "exact" | "naive" => assert_eq!(sample.held, inputs.len() + sample.constructed, "{name}"),
                // Corners; several thick ones may be one disc.
                "thick:1e-4" => assert!(sample.held <= sample.edges && 0 < sample.held, "{name}"),
                _ => assert_eq!(sample.held, sample.edges, "{name}"),
            }
        }
    }
    // Pixels of a 64th: nothing is between them, and nothing crosses or touches.
    let snapped = &of(&found, "exact+snap:8").samples;
    assert!(snapped.iter().all(|sample| sample.bits <= 8 && sample.defects.touches + sample.defects.crossings == 0));
}

#[test]
fn loops_of_two_corners_are_left_out_and_counted() {
    let found = measured(&cascades(Cascade::Rotate, &["naive+round"], 60));
    let samples = &of(&found, "naive+round").samples;
    assert!(samples.last().unwrap().collapsed > 0);
    // A loop of two corners would run back and forth.
    assert!(samples.iter().all(|sample| sample.defects.flat == 0));
}

#[test]
fn what_no_operand_comes_near_is_on_pixels_too() {
    let study = cascades(Cascade::Generalise, &["exact+snap:8"], 3);
    let found = measured(&study);
    let (start, _) = Cascade::Generalise.steps(3, 1);
    assert!(start.iter().flatten().any(|x| x * 64.0 != (x * 64.0).round()), "not on pixels before");
    assert!(study.holds(&found));
    for sample in &of(&found, "exact+snap:8").samples {
        let error = found.area_error(Cascade::Generalise, sample).unwrap();
        assert!(sample.bits <= 8 && error < 0.02, "{} bits, {error} off", sample.bits);
    }
}

#[test]
fn coarse_pixels_leave_nothing_that_crosses() {
    for seed in 2..4 {
        let methods = ["exact+snap:5", "exact+snap:6"];
        let study = Cascades {
            common: Common { seed, ..Common::default() },
            samples: 25,
            probes: 0,
            ..cascades(Cascade::Stars, &methods, 50)
        };
        let found = measured(&study);
        assert!(study.holds(&found), "seed {seed}");
        let touches = found.followed.iter().flat_map(|one| &one.samples).map(|sample| sample.defects.touches);
        assert_eq!(touches.sum::<usize>(), 0, "seed {seed}");
    }
}

/// All regions of a union, in one overlay of all loops.
#[test]
fn regions_are_those_of_all_operands_at_once() {
    let found = measured(&cascades(Cascade::Stars, &["exact"], 24));
    let (start, operands) = Cascade::Stars.steps(24, 1);
    let loops: Loops = std::iter::once(start).chain(operands.into_iter().map(|operand| operand.corners)).collect();
    let scene = Scene::from_points2(&loops.concat()).unwrap();
    let (mut several, mut holes, mut next) = (0, 0, 0);
    let vertices: Vec<Vec<Vertex>> = loops
        .iter()
        .map(|one| {
            next += one.len();
            (next - one.len()..next).map(Vertex::input).collect()
        })
        .collect();
    for sample in &found.exact[0].samples {
        let all = Polygon::of_vertices(&vertices[..=sample.step], Rule::NonZero);
        let mut session = Backend.prepare(&scene, Off).unwrap();
        let made = overlay(&mut session, [&all, &Polygon::default()], Method::Sweep).unwrap();
        let made = made.regions(predicament_overlay::algorithm::overlay::Operation::Union).regions;
        assert_eq!(sample.regions, made.len(), "after step {}", sample.step);
        several = several.max(made.len());
        holes = holes.max(made.iter().map(|region| region.holes.len()).sum());
    }
    assert!(several > 1 && holes > 1, "{several} regions, {holes} holes");
}

/// A step in a separate session, with each vertex rounded to the nearest double.
///
/// Returns the loops, and the number of corners at constructed vertices that turn differently.
fn rounded(regions: &[Loops], operand: &Operand) -> (Vec<Loops>, usize) {
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut places: BTreeMap<[u64; 2], usize> = BTreeMap::new();
    let mut edges = |corners: &Vec<[f64; 2]>| -> Vec<Edge> {
        let mut vertex = |corner: &[f64; 2]| {
            let place = places.entry(corner.map(f64::to_bits)).or_insert(points.len());
            if *place == points.len() {
                points.push(*corner);
            }
            Vertex::input(*place)
        };
        let vertices: Vec<Vertex> = corners.iter().map(&mut vertex).collect();
        vertices.iter().zip(vertices.iter().cycle().skip(1)).map(|(&from, &to)| Edge::whole(from, to)).collect()
    };
    let first: Vec<Region> = regions
        .iter()
        .map(|loops| Region { outer: edges(&loops[0]), holes: loops[1..].iter().map(&mut edges).collect() })
        .collect();
    let second = Polygon { loops: vec![edges(&operand.corners)], rule: Rule::NonZero };
    let inputs = Scene::from_points2(&points).unwrap();
    let mut session = Backend.prepare(&inputs, Off).unwrap();
    let made = combine(&mut session, &first, &second, operand.operation, Method::Sweep).unwrap();
    let scene = session.scene();
    let exact = |v: Vertex| -> Exact {
        let input = |v: Vertex| scene.point2(Plane::Xy, v).map(rational);
        match scene.construction(v) {
            Some(Construction::Ssi([[a, b], [c, d]])) => {
                let [a, b, c, d] = [*a, *b, *c, *d].map(input);
                meet([&a, &b], [&c, &d])
            }
            _ => input(v),
        }
    };
    let mut turned = 0;
    let mut after = |one: &Vec<Edge>| -> Vec<[f64; 2]> {
        let before: Vec<Exact> = one.iter().map(|edge| exact(edge.from)).collect();
        let after: Vec<[f64; 2]> = before.iter().map(|p| p.each_ref().map(nearest)).collect();
        let exactly = exactly(&after);
        for at in 0..one.len() {
            let places = [at, at + 1, at + 2].map(|at| at % one.len());
            let is_new = places.iter().any(|&at| one[at].from.is_constructed());
            let [was, is] = [&before, &exactly].map(|all| turn(places.map(|at| &all[at])).cmp0());
            turned += usize::from(is_new && was != is);
        }
        // Without corners that have been merged.
        (0..after.len()).filter(|&at| after[at] != after[(at + 1) % after.len()]).map(|at| after[at]).collect()
    };
    let regions = made.regions.iter().map(|region| region.loops().map(&mut after).collect()).collect();
    (regions, turned)
}

#[test]
fn rounded_results_are_those_of_each_step_by_itself() {
    for (cascade, steps) in [(Cascade::Stars, 12), (Cascade::Shave, 12)] {
        let found = measured(&cascades(cascade, &["exact+round"], steps));
        let (start, operands) = cascade.steps(steps as usize, 1);
        let mut regions = vec![vec![start]];
        let mut sum = 0;
        for (operand, sample) in operands.iter().zip(&of(&found, "exact+round").samples) {
            let (next, turned) = rounded(&regions, operand);
            assert_eq!(sample.turned, Some(turned), "{cascade:?} after step {}", sample.step);
            regions = next;
            sum += turned;
            let corners: Vec<Vec<Exact>> = regions.iter().flatten().map(|one| exactly(one)).collect();
            assert_eq!(sample.edges, corners.iter().map(Vec::len).sum::<usize>());
            // Twice the area, as triangles with the origin.
            let mut area = Rational::new();
            for one in &corners {
                for (a, b) in one.iter().zip(one.iter().cycle().skip(1)) {
                    area += Rational::from(&a[0] * &b[1]) - Rational::from(&a[1] * &b[0]);
                }
            }
            assert_eq!(sample.area, area, "{cascade:?} after step {}", sample.step);
            // Relative to the true value.
            let truth = &found.exact[0].samples[sample.step - 1].area;
            let wanted = (Rational::from(&area - truth) / truth).abs().to_f64();
            assert_eq!(found.area_error(cascade, sample), Some(wanted));
        }
        assert!(sum > 3 || cascade == Cascade::Shave, "{sum} corners are turned");
    }
}

#[test]
fn samples_are_spread_over_the_steps_and_the_first_that_breaks_is_one() {
    let study = |cascade: Cascade, method: &str, steps: u32, samples: u32| {
        let study = Cascades { samples, ..cascades(cascade, &[method], steps) };
        let found = measured(&study);
        let steps = |one: &Followed| one.samples.iter().map(|sample| sample.step).collect::<Vec<_>>();
        (steps(&found.exact[0]), steps(&found.followed[0]), found.followed[0].broken.map(|(step, _)| step))
    };
    assert_eq!(study(Cascade::Stars, "exact", 7, 2).0, [4, 7]);
    assert_eq!(study(Cascade::Stars, "exact", 9, 4).0, [3, 5, 7, 9]);
    // The step with an empty result is another one.
    let (_, steps, _) = study(Cascade::Stars, "thick:0.001", 40, 1);
    assert!(steps.len() == 1 && steps[0] < 40, "{steps:?}");
    let (_, steps, broken) = study(Cascade::Rotate, "naive+round", 20, 1);
    let broken = broken.expect("signs that are wrong");
    assert!(broken < 20 && steps.contains(&broken), "{steps:?}, broken by step {broken}");
}
