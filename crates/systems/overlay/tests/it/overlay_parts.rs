//! Tests that parts which meet nothing are left out without a change of the result.

use predicament_exact::Exact;
use predicament_overlay::algorithm::overlay::{
    Edge, Method, Operation, Polygon, Region, Rule, combine, operate, overlay,
};
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use predicament_sos::Sos;

use crate::overlay::{Numbers, by_place};

/// Tests that parts far from the other operand do not change, and that leaving them out does not change the result.
#[test]
fn combined_results_are_those_of_whole_overlays() {
    fn steps<B: Backend>(backend: &B, numbers: &mut Numbers, round: usize) -> [usize; 2] {
        let side = [14, 30, 60][round % 3];
        // Polygons of a few corners near each other.
        let mut points = Vec::new();
        let mut loops = Vec::new();
        for _ in 0..24 {
            let [x, y] = [numbers.below(side), numbers.below(side)];
            let corners = 3 + numbers.below(4);
            loops.push((0..corners).map(|i| Vertex::input(points.len() + i as usize)).collect::<Vec<_>>());
            let reach = if numbers.below(5) == 0 { side } else { 8 };
            points.extend(
                (0..corners).map(|_| [f64::from(x + numbers.below(reach)), f64::from(y + numbers.below(reach))]),
            );
        }
        let scene = Scene::from_points2(&points).unwrap();
        let mut sessions = [backend.prepare(&scene, Off).unwrap(), backend.prepare(&scene, Off).unwrap()];
        let mut current: Vec<Region> = Vec::new();
        let [mut holes, mut most] = [0, 0];
        for (step, one) in loops.iter().enumerate() {
            let rule = [Rule::EvenOdd, Rule::NonZero][(round + step) % 2];
            let second = Polygon::of_vertices(std::slice::from_ref(one), rule);
            let after = Operation::ALL[if numbers.below(3) > 0 { 0 } else { numbers.below(4) as usize }];
            // For overlapping lines no perturbed crossing is constructed.
            let first = Polygon::from(current.as_slice());
            let Ok(made) = overlay(&mut sessions[0], [&first, &second], Method::Grid) else { break };
            let whole = made.regions(after);
            let local = combine(&mut sessions[1], &current, &second, after, Method::Grid).unwrap();
            assert_eq!((whole.broken, local.broken), (None, None), "round {round}, step {step}");
            let [wanted, found] =
                [by_place(sessions[0].scene(), &whole.regions), by_place(sessions[1].scene(), &local.regions)];
            assert_eq!(found, wanted, "round {round}, step {step}, {}", after.name());
            assert!(local.regions.is_sorted() && local.regions.iter().all(|region| region.holes.is_sorted()));
            holes += local.regions.iter().map(|region| region.holes.len()).sum::<usize>();
            most = most.max(local.regions.iter().flat_map(Region::loops).map(Vec::len).sum());
            // The vertices belong to the session of the next step.
            current = local.regions;
            sessions[0] = backend.prepare(&scene, Off).unwrap();
            let definitions = sessions[1].scene().constructions().to_vec();
            if !definitions.is_empty() {
                sessions[0].construct(&definitions).unwrap();
            }
        }
        [holes, most]
    }
    let mut numbers = Numbers(11);
    let mut seen = [0; 2];
    let rounds = predicament_effort::some_or_all(12, 60);
    for round in 0..rounds {
        let found = steps(&Exact, &mut numbers, round);
        let perturbed = steps(&Sos::default(), &mut numbers, round);
        seen = [0, 1].map(|i: usize| seen[i] + found[i] + perturbed[i]);
    }
    assert!(seen[0] > 16 * rounds && seen[1] > 50 * rounds, "holes and edges: {seen:?}");
}

/// A loop of lattice points: between a few corners, steps that go neither back in x nor in y.
fn staircase(numbers: &mut Numbers, side: u32) -> Vec<[f64; 2]> {
    let corners: Vec<[i64; 2]> =
        (0..3 + numbers.below(4)).map(|_| [numbers.below(side), numbers.below(side)].map(i64::from)).collect();
    let mut points: Vec<[f64; 2]> = Vec::new();
    for (at, &from) in corners.iter().enumerate() {
        let to = corners[(at + 1) % corners.len()];
        let mut here = from;
        while here != to {
            let push = |points: &mut Vec<[f64; 2]>, [x, y]: [i64; 2]| {
                points.push([x, y].map(|x| f64::from(i32::try_from(x).unwrap())));
            };
            push(&mut points, here);
            if numbers.below(60) == 0 {
                // A spike that ends on itself.
                let [x, y] = [0, 1].map(|_: usize| i64::from(numbers.below(5)) - 2);
                push(&mut points, [here[0] + 2 * x, here[1] + 2 * y]);
                push(&mut points, [here[0] + x, here[1] + y]);
            }
            let before = here;
            for axis in 0..2 {
                let most = (to[axis] - here[axis]).abs().min(i64::from(numbers.below(3)));
                here[axis] += most * (to[axis] - here[axis]).signum();
            }
            if here == before && numbers.below(10) > 0 {
                points.pop();
            }
        }
    }
    points
}

/// Tests that edges found to meet nothing, which are copied, do not change the result.
#[test]
fn results_in_which_most_edges_meet_nothing_are_those_of_whole_overlays() {
    fn results<B: Backend>(backend: &B, scene: &Scene, operands: [&Polygon; 2], what: &str) -> usize {
        let mut sessions = [backend.prepare(scene, Off).unwrap(), backend.prepare(scene, Off).unwrap()];
        // For overlapping lines no perturbed crossing is constructed.
        let Ok(made) = overlay(&mut sessions[0], operands, Method::Grid) else { return 0 };
        let at = |v: Vertex| (!v.is_constructed()).then(|| scene.point(v)).ok_or(v);
        let mut holes = 0;
        for operation in Operation::ALL {
            let whole = made.regions(operation);
            let found = operate(&mut sessions[1], operands, operation, Method::Grid).unwrap();
            assert_eq!((whole.broken, found.broken), (None, None), "{what}");
            let [wanted, is] =
                [by_place(sessions[0].scene(), &whole.regions), by_place(sessions[1].scene(), &found.regions)];
            assert_eq!(is, wanted, "{what}, {}", operation.name());
            holes += found.regions.iter().map(|region| region.holes.len()).sum::<usize>();
            let has_length = |edge: &Edge| edge.from != edge.to && at(edge.from) != at(edge.to);
            // A perturbation separates vertices at one place.
            let is_perturbed = what.ends_with("perturbed");
            assert!(is_perturbed || found.regions.iter().flat_map(Region::loops).flatten().all(has_length), "{what}");
        }
        holes
    }
    let mut numbers = Numbers(23);
    let mut holes = 0;
    let rounds = predicament_effort::some_or_all(32, 600);
    for round in 0..rounds {
        let side = [30, 60, 200, 500][round % 4];
        let mut points: Vec<[f64; 2]> = Vec::new();
        let is_shared = round % 3 == 0;
        let mut polygon = |numbers: &mut Numbers| {
            let mut vertex = |point: [f64; 2]| {
                let known = is_shared.then(|| points.iter().position(|&other| other == point)).flatten();
                Vertex::input(known.unwrap_or_else(|| {
                    points.push(point);
                    points.len() - 1
                }))
            };
            let loops: Vec<Vec<Vertex>> = (0..1 + numbers.below(3))
                .map(|_| staircase(numbers, side).into_iter().map(&mut vertex).collect())
                .collect();
            Polygon::of_vertices(&loops, [Rule::EvenOdd, Rule::NonZero][numbers.below(2) as usize])
        };
        let operands = [polygon(&mut numbers), polygon(&mut numbers)];
        let scene = Scene::from_points2(&points).unwrap();
        let operands = [&operands[0], &operands[1]];
        holes += results(&Exact, &scene, operands, &format!("round {round}"));
        holes += results(&Sos::default(), &scene, operands, &format!("round {round}, perturbed"));
    }
    assert!(holes > 8 * rounds, "{holes} holes");
}

/// Tests a loop whose leftmost vertex is the end of a spike back on itself: without the spike, the leftmost vertex is
/// among edges that meet nothing.
#[test]
fn results_without_the_edges_that_cancel_are_those_of_whole_overlays() {
    // A square on its corner, from the upper corner on, and the end of the spike.
    let around = (0..160).map(|at| [(at + 120) % 160, at].map(|at: i32| f64::from((at - 80).abs() - 40)));
    let points: Vec<[f64; 2]> = around.chain([[-60.0, 40.0]]).collect();
    let scene = Scene::from_points2(&points).unwrap();
    let there: Vec<Vertex> = [0, 160].into_iter().chain(0..160).map(Vertex::input).collect();
    let back: Vec<Vertex> = there.iter().rev().copied().collect();
    for vertices in [there, back] {
        let polygon = Polygon::of_vertices(&[vertices], Rule::NonZero);
        let operands = [&polygon, &Polygon::default()];
        let mut sessions = [Exact.prepare(&scene, Off).unwrap(), Exact.prepare(&scene, Off).unwrap()];
        let whole = overlay(&mut sessions[0], operands, Method::Grid).unwrap().regions(Operation::Union);
        let found = operate(&mut sessions[1], operands, Operation::Union, Method::Grid).unwrap();
        assert_eq!(found, whole);
        assert_eq!(found.regions.iter().map(|region| region.outer.len()).collect::<Vec<_>>(), [160]);
    }
}
