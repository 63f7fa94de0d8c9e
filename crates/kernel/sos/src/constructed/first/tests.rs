//! Decisions by the first vertices, against the search through all monomials.

use predicament_exact::Exact;
use predicament_predicates::{Backend, Construction, Dimension, Off, Plane, Predicates};

use super::*;

use crate::constructed::testing::{Random, constructions, search_all};

/// The number of ties by result.
///
/// The index is the deciding degree, 0 for identities, and 4 for ties that remain open.
type Counts = [usize; 5];

fn check<const N: usize>(scene: &Scene, rows: &Rows, question: Question, args: [Vertex; N], counts: &mut Counts) {
    let known = decide(scene, rows, question, args, 1);
    let place = match &known {
        Known::Broken(_, degree) => (*degree).min(3),
        Known::Identity => 0,
        Known::Open => 4,
    };
    counts[place] += 1;
    let known = match known {
        Known::Broken(sign, degree) => Some((sign, degree)),
        Known::Identity => None,
        Known::Open => return,
    };
    assert_eq!(known, search_all(scene, question, &args), "{question:?} of {args:?} in {scene:?}");
}

/// Asks about `ties` ties of any vertices, or of constructed ones only.
fn ask(random: &mut Random, scene: &Scene, ties: usize, with_inputs: bool, counts: &mut Counts) {
    let (exact, rows) = (Exact.prepare(scene, Off).unwrap(), Rows::new(scene));
    let inputs = if with_inputs { scene.len() } else { 0 };
    let mut all: Vec<Vertex> = (0..inputs).map(Vertex::input).collect();
    // Constructed vertices twice as often.
    all.extend((0..scene.constructions().len()).flat_map(|at| [Vertex::constructed(at); 2]));
    if all.len() < 4 {
        return;
    }
    let mut found = 0;
    for _ in 0..20 * ties {
        if found == ties {
            return;
        }
        let [a, b, c, d] = std::array::from_fn(|_| all[random.below(all.len())]);
        if [a, b, c, d].iter().all(|v| !v.is_constructed()) || [b, c, d].contains(&a) || [c, d].contains(&b) || c == d {
            continue;
        }
        let axis = [Axis::X, Axis::Y, Axis::Z][random.below(scene.dimension().count())];
        let plane =
            [Plane::Xy, Plane::Yz, Plane::Zx][if scene.dimension() == Dimension::Two { 0 } else { random.below(3) }];
        match random.below(scene.dimension().count()) {
            0 if exact.compare(axis, a, b).is_zero() => check(scene, &rows, Question::Compare(axis), [a, b], counts),
            1 if exact.orient2d(plane, a, b, c).is_zero() => {
                check(scene, &rows, Question::Orient2d(plane), [a, b, c], counts);
            }
            2 if exact.orient3d(a, b, c, d).is_zero() => check(scene, &rows, Question::Orient3d, [a, b, c, d], counts),
            _ => continue,
        }
        found += 1;
    }
}

/// Points of a grid with a separate step along each axis.
///
/// Steps have one bit or many bits, are subnormal or large, and far from each other.
fn grid(random: &mut Random, dimension: usize, side: usize, points: usize, round: usize) -> Scene {
    let long = 2f64.powi(50) - 3.0;
    let units = [
        [1.0, 1.0, 1.0],
        [3.0, 7.0, 5.0],
        [long, 1.0, long - 8.0],
        [5e-324, 3.0 * 5e-324, 7.0 * 5e-324],
        [long * 2f64.powi(970), 1.0, long * f64::from_bits(1)],
    ][round % 5];
    let mut coordinates = Vec::new();
    for _ in 0..points {
        coordinates
            .extend((0..dimension).map(|axis| units[axis] * f64::from(u32::try_from(random.below(side)).unwrap())));
    }
    Scene::new(if dimension == 2 { Dimension::Two } else { Dimension::Three }, coordinates).unwrap()
}

#[test]
fn lines_of_a_grid() {
    let (mut random, mut counts) = (Random(21), [0; 5]);
    for round in 0..predicament_effort::scaled(2000) {
        let mut scene = grid(&mut random, 2, 3, [6, 12][round / 5 % 2], round);
        constructions(&mut random, &mut scene, 5);
        ask(&mut random, &scene, 6, true, &mut counts);
    }
    assert!(counts.iter().enumerate().all(|(place, &count)| place == 3 || count > 1), "{counts:?}");
}

#[test]
fn planes_of_a_grid() {
    let (mut random, mut counts) = (Random(22), [0; 5]);
    for round in 0..predicament_effort::scaled(1000) {
        // Few points, which are shared, or many.
        let mut scene = grid(&mut random, 3, 3, [7, 12, 27][round / 5 % 3], round);
        constructions(&mut random, &mut scene, 6);
        ask(&mut random, &scene, 4, true, &mut counts);
    }
    assert!(counts.iter().enumerate().all(|(place, &count)| place == 3 || count > 1), "{counts:?}");
    // Three of eight remain for the search, which is right as well: without shared vertices it would be nearly half.
    let open = counts[4] * 5 < counts.iter().sum::<usize>() * 2;
    assert!(open, "{counts:?}");
}

/// Two to four vertices of lines and planes through one point: more vertices give a higher degree.
#[test]
fn points_at_one_place() {
    let (mut random, mut counts) = (Random(23), [0; 5]);
    for round in 0..predicament_effort::scaled(400) {
        let dimension = 2 + round % 2;
        let unit = [1.0, 2f64.powi(45) - 1.0, 5e-324, 2f64.powi(1000)][round / 2 % 4];
        let mut digit = |bound: usize| f64::from(u32::try_from(1 + random.below(bound)).unwrap());
        // Lines are spanned by v and −2v, planes by v, w and −(v + w).
        let mut coordinates: Vec<f64> = Vec::new();
        let mut definitions = Vec::new();
        let mut next = 0;
        let mut flat = |coordinates: &mut Vec<f64>, size: usize, digit: &mut dyn FnMut(usize) -> f64| -> Vec<Vertex> {
            let v: Vec<f64> = (0..dimension).map(|_| unit * (digit(9) - 5.0)).collect();
            let w: Vec<f64> = (0..dimension).map(|_| unit * (digit(9) - 5.0)).collect();
            coordinates.extend(&v);
            if size == 2 {
                coordinates.extend(v.iter().map(|x| -2.0 * x));
            } else {
                coordinates.extend(&w);
                coordinates.extend(v.iter().zip(&w).map(|(x, y)| -(x + y)));
            }
            next += size;
            (next - size..next).map(Vertex::input).collect()
        };
        for at in 0..4 {
            let line = |v: Vec<Vertex>| [v[0], v[1]];
            let plane = |v: Vec<Vertex>| [v[0], v[1], v[2]];
            definitions.push(if dimension == 2 {
                Construction::Ssi([
                    line(flat(&mut coordinates, 2, &mut digit)),
                    line(flat(&mut coordinates, 2, &mut digit)),
                ])
            } else if (at + round / 2) % 3 == 0 {
                Construction::Tpi([(); 3].map(|()| plane(flat(&mut coordinates, 3, &mut digit))))
            } else {
                let [first, second] = if round / 4 % 2 == 0 { [2, 3] } else { [3, 2] };
                let (first, second) =
                    (flat(&mut coordinates, first, &mut digit), flat(&mut coordinates, second, &mut digit));
                let (of_line, of_plane) = if first.len() == 2 { (first, second) } else { (second, first) };
                Construction::Lpi { line: line(of_line), plane: plane(of_plane) }
            });
        }
        let dimension = if dimension == 2 { Dimension::Two } else { Dimension::Three };
        let mut scene = Scene::new(dimension, coordinates).unwrap();
        let mut session = Exact.prepare(&scene, Off).unwrap();
        for definition in definitions {
            // (Some have no point.)
            let _ = session.construct(&[definition]);
        }
        let made = session.scene().constructions().to_vec();
        drop(session);
        for construction in made {
            scene.construct(construction).unwrap();
        }
        ask(&mut random, &scene, 6, round % 8 > 5, &mut counts);
    }
    assert!(counts[1..].iter().all(|&count| count > 1), "{counts:?}");
}
