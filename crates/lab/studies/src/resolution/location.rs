//! The distance between a shallow crossing and the place where it is registered.
//!
//! A tolerance bounds distances from an edge, not positions along it. If two edges cross at a small angle, an end of
//! one can be within τ of the other far from the crossing, and is registered there.

use predicament_corpus::Random;
use predicament_error_calculus::vector::{minus, perp};
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::AnswerError;
use rayon::prelude::*;
use rug::Rational;

use super::pose::Pose;
use super::{Ask, LENGTHS};
use crate::Precision;

/// The number of angles per decade, and the decades.
const STEPS: i32 = 10;
const DECADES: std::ops::RangeInclusive<i32> = -9..=0;
/// The maximum number of redraws of edges that don't cross after rounding.
const TRIES: u32 = 100;

/// The crossings at one angle, as registered.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Location {
    /// The angle between the edges, in radians.
    pub angle: f64,
    /// The number of pairs of edges: after rounding fewer cross if the angle is tiny.
    pub crossed: u32,
    /// The number of pairs with any registration.
    pub registered: u32,
    /// The number of pairs registered as crossings.
    pub crossings: u32,
    /// The largest distance on the first edge between the registered position and the crossing, in units of L.
    pub worst: f64,
    /// The mean of that distance over all registered pairs.
    pub mean: f64,
}

/// Crosses two edges at each angle `trials` times, anywhere along them.
///
/// # Errors
/// [`AnswerError`] if the backend declines.
pub fn location(
    ask: &Ask,
    length: f64,
    precision: Precision,
    trials: u32,
    seed: u64,
) -> Result<Vec<Location>, AnswerError> {
    let angles: Vec<i32> = (DECADES.start() * STEPS..=DECADES.end() * STEPS).collect();
    let at = angles.par_iter().map(|&step| {
        let angle = 10_f64.powf(f64::from(step) / f64::from(STEPS));
        let mut random = Random::new("location", &format!("{step}"), seed);
        let (mut crossed, mut registered, mut crossings, mut worst, mut sum) = (0_u32, 0_u32, 0_u32, 0.0_f64, 0.0);
        for _ in 0..trials {
            let Some((scene, crossing)) = (0..TRIES).find_map(|_| crossing(angle, precision, &mut random)) else {
                continue;
            };
            crossed += 1;
            let edge = |at: usize| {
                let edges = vec![[at, at + 1].map(Vertex::input)];
                Complex::new(&scene, &Simplices { edges, ..Simplices::default() }).expect("two vertices are an edge")
            };
            let contacts = ask(&scene, &edge(0), &edge(2))?;
            let Some(first) = contacts.registered.first() else { continue };
            registered += 1;
            crossings += u32::from(first.a.rank == 1 && first.b.rank == 1);
            let error = contacts.registered.iter().map(|contact| {
                let fraction = match contact.a.rank {
                    0 => f64::from(contact.a.index),
                    _ => contact.on_a[1],
                };
                (fraction - crossing).abs() * LENGTH / length
            });
            let error = error.fold(0.0, f64::max);
            worst = worst.max(error);
            sum += error;
        }
        let mean = if registered == 0 { 0.0 } else { sum / f64::from(registered) };
        Ok(Location { angle, crossed, registered, crossings, worst, mean })
    });
    at.collect()
}

/// The length of the first edge; in every rotation it is at most half of L along an axis.
const LENGTH: f64 = 0.5;

/// Two edges that cross at about this angle, and the crossing's position on the first, from 0 to 1.
///
/// The position is computed from the rounded points. `None` if the rounded edges do not cross.
fn crossing(angle: f64, precision: Precision, random: &mut Random) -> Option<(Scene, f64)> {
    let (on_first, on_second) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
    let pose = Pose::of_plane(random);
    let (sin, cos) = angle.sin_cos();
    let along = |way: f64| [on_first * LENGTH + way * cos, way * sin, 0.0];
    let ends = [[0.0; 3], [LENGTH, 0.0, 0.0], along(-on_second * LENGTH), along((1.0 - on_second) * LENGTH)];
    let points = ends.map(|end| pose.turn(end, precision)).map(|[x, y, _]| [x, y]);
    let [at_a, at_b] = [[0, 2, 3], [1, 2, 3]].map(|corners| area(corners.map(|i| points[i])));
    let [at_p, at_q] = [[2, 0, 1], [3, 0, 1]].map(|corners| area(corners.map(|i| points[i])));
    let opposite = |a: &Rational, b: &Rational| a.cmp0() == b.cmp0().reverse() && a.cmp0().is_ne();
    if !opposite(&at_a, &at_b) || !opposite(&at_p, &at_q) {
        return None;
    }
    let fraction = (at_a.clone() / (at_a - at_b)).to_f64();
    let scene = Scene::from_points2(&points).expect("the points are finite");
    let second = [2, 3].map(predicament_predicates::Vertex::input);
    Some((scene.with_primitive_lengths(LENGTHS).with_second_mesh(second), fraction))
}

/// Twice the signed area, exactly.
fn area([a, b, c]: [[f64; 2]; 3]) -> Rational {
    let exact = |point: [f64; 2]| point.map(|x| Rational::from_f64(x).expect("the points are finite"));
    let [a, b, c] = [a, b, c].map(exact);
    perp(&minus(&b, &a), &minus(&c, &a))
}

#[cfg(test)]
mod tests {
    use predicament_contacts::algorithm::pairs::{Contact, Contacts, contacts};
    use predicament_exact::Exact;
    use predicament_mesh::Simplex;
    use predicament_predicates::{Backend, Off};

    use super::*;

    #[test]
    fn exact_arithmetic_finds_every_crossing_where_it_is() {
        let exactly = |scene: &Scene, a: &Complex, b: &Complex| Ok(contacts(&Exact.prepare(scene, Off).unwrap(), a, b));
        for precision in [Precision::Single, Precision::Double] {
            let found = location(&exactly, 1.0, precision, 10, 1).unwrap();
            for at in &found {
                assert_eq!((at.registered, at.crossings), (at.crossed, at.crossed), "{at:?}");
            }
            let steep = found.iter().filter(|at| at.angle > 0.1);
            // Weights are plain floating point.
            assert!(steep.clone().all(|at| at.crossed == 10 && at.worst < 1e-12));
        }
    }

    #[test]
    fn the_error_is_the_distance_along_the_edge() {
        let at_first_vertex = |_: &Scene, _: &Complex, _: &Complex| {
            let (a, b) = (Simplex { rank: 0, index: 0 }, Simplex { rank: 1, index: 0 });
            let on = [1.0, 0.0, 0.0, 0.0];
            Ok(Contacts { registered: vec![Contact { a, b, on_a: on, on_b: on }], ..Contacts::default() })
        };
        let found = location(&at_first_vertex, 2.0, Precision::Double, 200, 1).unwrap();
        let last = found.last().unwrap();
        assert_eq!((last.registered, last.crossings), (200, 0));
        assert!(last.worst <= LENGTH / 2.0 && last.worst > 0.24, "{last:?}");
        assert!((last.mean - LENGTH / 4.0).abs() < 0.02, "{last:?}");
    }
}
