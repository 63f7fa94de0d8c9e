//! Unions of closed cubes: against cells, squares, edges and points of the unit grid, which are counted one by one.

use std::collections::BTreeMap;

use predicament_cube_union::algorithm::{Face, Mass, Order, cube_union, cube_union_by, union_in_order};
use predicament_cube_union::checks::{Measures, Ties, measured_by};
use predicament_exact::Exact;
use predicament_judge::cubes::{Cubes, Shape, shape};
use predicament_predicates::{Axis, Backend, Off, Sign};
use rug::Rational;

use super::backends::scene;
use super::scenes::{Random, lattice};
use super::union::measures;

/// The order by integers, with ties.
struct ByValue<'c> {
    lowers: &'c [[i64; 3]],
    edge: i64,
}

impl Order for ByValue<'_> {
    fn compare(&self, axis: Axis, a: Face, b: Face) -> Sign {
        let [a, b] =
            [a, b].map(|of| self.lowers[of.cube as usize][axis.index()] + if of.upper { self.edge } else { 0 });
        Sign::from(a.cmp(&b))
    }
}

fn closed(lowers: &[[i64; 3]], edge: i64) -> Mass {
    union_in_order(&ByValue { lowers, edge }, lowers, edge).unwrap()
}

/// Measures, Euler characteristic, and the number of vertices of each shape.
type Counted = (Measures, i128, BTreeMap<Shape, u64>);

/// The figures of the union from the cells of the unit grid. Lower corners are not negative.
fn counted(lowers: &[[i64; 3]], edge: i64) -> Counted {
    let side = lowers.as_flattened().iter().max().map_or(0, |most| most + edge) + 2;
    let index = |at: [i64; 3]| usize::try_from(at.into_iter().fold(0, |sum, c| sum * side + c + 1)).unwrap();
    let mut filled = vec![false; usize::try_from(side.pow(3)).unwrap()];
    for lower in lowers {
        for cell in lattice(edge, 1) {
            filled[index([0, 1, 2].map(|axis| lower[axis] + cell[axis]))] = true;
        }
    }
    let has = |at: [i64; 3]| filled[index(at)];
    let (mut sums, mut euler, mut shapes) = (Measures::default(), 0, BTreeMap::new());
    for at in lattice(side - 1, 1) {
        // The element of the grid from `at` along these axes is in the cells that are below or at it along the others.
        let cells = |along: [bool; 3]| {
            let places = lattice(2, 1).into_iter().filter(move |o| (0..3).all(|axis| !along[axis] || o[axis] == 1));
            places.map(move |o| has([0, 1, 2].map(|axis| at[axis] - 1 + o[axis])))
        };
        for along in lattice(2, 1).iter().map(|along| along.map(|c| c == 1)) {
            let dimension = along.iter().filter(|&&is_along| is_along).count();
            let of: Vec<bool> = cells(along).collect();
            euler += i128::from(of.contains(&true)) * if dimension % 2 == 0 { 1 } else { -1 };
            match of[..] {
                [cell] => sums.volume += i128::from(cell),
                [a, b] => sums.area += i128::from(a != b),
                [a, b, c, d] => {
                    let count = [a, b, c, d].iter().filter(|&&cell| cell).count();
                    sums.edge_length += i128::from(count % 2 == 1 || count == 2 && a == d);
                }
                _ => {
                    let octants = of.iter().enumerate().fold(0, |bits, (o, &cell)| bits | u8::from(cell) << o);
                    let is_constant = |axis: usize| (0..8).all(|o: usize| of[o] == of[o ^ 1 << axis]);
                    if !(0..3).any(is_constant) {
                        *shapes.entry(shape(octants)).or_insert(0) += 1;
                    }
                }
            }
        }
    }
    (sums, euler, shapes)
}

fn figures(mass: &Mass) -> Counted {
    let shapes = mass.vertices.by_octants().filter(|of| of.1 > 0).map(|(octants, count)| (shape(octants), count));
    (measures(mass), mass.vertices.of_the_union().expect("a whole characteristic"), shapes.collect())
}

/// Asserts that the algorithm, the sections and the judge's cells find what is counted.
fn check(lowers: &[[i64; 3]], edge: i64) -> Mass {
    let expected = counted(lowers, edge);
    let mass = closed(lowers, edge);
    assert_eq!(figures(&mass), expected, "{lowers:?} of {edge}");
    assert_eq!(measured_by(lowers, edge, Ties::Merged), expected.0, "sections of {lowers:?} of {edge}");
    let judged = Cubes::of_scene(&scene(lowers, edge)).unwrap().closed().unwrap();
    let of = [expected.0.volume, expected.0.area, expected.0.edge_length].map(Rational::from);
    assert_eq!([judged.volume, judged.area, judged.edge_length], of, "the judge about {lowers:?} of {edge}");
    assert_eq!((i128::from(judged.euler_characteristic), judged.vertices), (expected.1, expected.2));
    mass
}

#[test]
fn every_pattern_of_octants_is_what_is_counted() {
    let mut seen = BTreeMap::new();
    for pattern in 0..256_usize {
        // Cubes in the octants around (2, 2, 2).
        let mut lowers: Vec<[i64; 3]> = (0..8).filter(|o| pattern >> o & 1 == 1).map(|o| lattice(2, 2)[o]).collect();
        let mass = check(&lowers, 2);
        for (name, count) in mass.vertices.by_name() {
            *seen.entry(name).or_insert(0) += count;
        }
        lowers.reverse();
        assert_eq!(closed(&lowers, 2), mass, "{pattern:#b} in another order");
    }
    assert!(seen.values().all(|&count| count > 0), "{seen:?}");
}

#[test]
fn random_sets_of_cubes_are_what_is_counted() {
    let mut random = Random::new(40);
    let rounds = if predicament_effort::whole() { 10_000 } else { 40 };
    for round in 0..rounds {
        let (count, end, edge) = (1 + round % 14, 1 + random.below(6), 1 + random.below(3));
        let lowers = random.lowers(count, end);
        let mass = check(&lowers, edge);
        let (found, exponent) = cube_union_by(&Exact.prepare(&scene(&lowers, edge), Off).unwrap()).unwrap();
        // (in other units if all numbers are even)
        if exponent == 0 {
            assert_eq!(found, mass, "{lowers:?} of {edge}");
        }
    }
}

#[test]
fn a_lattice_of_closed_cubes_is_one_block() {
    let mut random = Random::new(41);
    for (n, pitch, edge) in [(3, 3, 3), (4, 2, 3), (6, 5, 5)] {
        let mass = closed(&random.shuffled(&lattice(n, pitch)), edge);
        let side = i128::from((n - 1) * pitch + edge);
        let block = Measures { volume: side.pow(3), area: 6 * side * side, edge_length: 12 * side };
        assert_eq!((measures(&mass), mass.vertices.total(), mass.vertices.corners), (block, 8, 8));
    }
    let identical = closed(&[[4, -5, 6]; 200], 7);
    assert_eq!((identical.volume, identical.area, identical.edge_length), (343, 294, 84));
}

#[test]
fn in_general_position_closed_cubes_are_the_perturbed_ones() {
    let mut random = Random::new(42);
    for count in [1, 2, 10, 60] {
        let [x, y, z] = [(); 3].map(|()| random.shuffled(&(0..60).map(|i| 10 * i).collect::<Vec<i64>>()));
        let lowers: Vec<[i64; 3]> = (0..count).map(|i| [x[i], y[i], z[i]]).collect();
        let moved = cube_union(&lowers, 205).unwrap();
        assert_eq!(closed(&lowers, 205), moved);
        let edges = moved.vertices.euler_characteristic().unwrap();
        assert_eq!(moved.vertices.of_the_union(), Some(edges / 2));
        // One more cube, far away in a common plane, sends all through the table.
        let far: Vec<[i64; 3]> = lowers.iter().copied().chain([[x[0], 5001, 5003]]).collect();
        let (both, cube) = (closed(&far, 205), closed(&[[0; 3]], 205));
        assert_eq!((both.volume, both.area), (moved.volume + cube.volume, moved.area + cube.area));
        assert_eq!(
            (both.edge_length, both.vertices.corners),
            (moved.edge_length + cube.edge_length, moved.vertices.corners + 8)
        );
        assert_eq!(both.vertices.total(), moved.vertices.total() + 8);
    }
}

/// An order without sense: the answers of a hash.
struct Senseless(u64);

impl Order for Senseless {
    fn compare(&self, axis: Axis, a: Face, b: Face) -> Sign {
        let of = |face: Face| 2 * u64::from(face.cube) + u64::from(face.upper);
        let mut random = Random::new(self.0 ^ ((of(a) * 1000 + of(b)) * 3 + axis.index() as u64));
        Sign::from(random.below(3).cmp(&1))
    }
}

#[test]
fn orders_without_sense_do_no_harm() {
    for seed in 0..50 {
        let lowers = Random::new(seed).lowers(12, 5);
        union_in_order(&Senseless(seed), &lowers, 2).unwrap();
    }
}
