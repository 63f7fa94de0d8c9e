//! Metamorphic laws: answers that must not change if points move exactly.
//!
//! No truth is needed: two scenes whose points are images of each other have the same signs, or opposite ones.
//! Coordinates are integers of up to 21 bits, and all maps keep them doubles, so that nothing is rounded on the way.
//!
//! A backend that breaks ties may break those of the image differently: it is only checked on tuples without ties. A
//! backend with a band has another band in an image of another shape: there a zero contradicts nothing.

use predicament_corpus::Random;
use predicament_formats::bits::{integer, power_of_two};
use predicament_judge::sign;
use predicament_predicates::{Declined, Plane, PredicateKind, Question, Scene, Sign, Vertex, ZeroMeaning};
use predicament_tasks::Contestant;
use serde::{Deserialize, Serialize};

use crate::Error;

/// A metamorphic law.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Law {
    /// Points times 2^300, and times 2^-300: the same signs.
    Scaling,
    /// The first coordinate negated: opposite signs.
    Reflection,
    /// Points moved by integers: the same signs.
    Translation,
    /// Points mapped by an integer matrix: orientations times the sign of its determinant.
    Affine,
    /// The law that incircle is orient3d of the points lifted to the paraboloid.
    Lift,
    /// The same points in another order of vertices: the same signs.
    Renaming,
}

impl Law {
    /// All six laws.
    pub const ALL: [Law; 6] = [Law::Scaling, Law::Reflection, Law::Translation, Law::Affine, Law::Lift, Law::Renaming];

    /// The law's name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Law::Scaling => "scaling",
            Law::Reflection => "reflection",
            Law::Translation => "translation",
            Law::Affine => "affine map",
            Law::Lift => "lift",
            Law::Renaming => "renaming",
        }
    }

    const fn is_about(self, kind: PredicateKind) -> bool {
        match self {
            Law::Affine => matches!(kind, PredicateKind::Orient2d | PredicateKind::Orient3d),
            Law::Lift => matches!(kind, PredicateKind::Incircle),
            _ => true,
        }
    }

    /// Returns true if a band is the same in the image.
    const fn keeps_bands(self) -> bool {
        !matches!(self, Law::Affine | Law::Lift)
    }
}

/// The number of violations of a law by a backend: a row of `stress-laws.csv`.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Violations {
    /// The law.
    pub law: String,
    /// The predicate.
    pub predicate: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// The number of tuples that were queried twice.
    pub tuples: u64,
    /// The number of tuples whose answers contradict each other.
    pub violations: u64,
    /// The number of tuples without a consequence: broken ties, zeros of bands.
    pub silent: u64,
    /// The first violation: the points, and both answers.
    pub first: String,
}

const KINDS: [PredicateKind; 4] =
    [PredicateKind::Orient2d, PredicateKind::Orient3d, PredicateKind::Incircle, PredicateKind::Insphere];

type Tuple = Vec<Vec<f64>>;

/// All laws for one backend, with this many tuples each.
pub(super) fn violations(backend: &dyn Contestant, tuples: u32, seed: u64) -> Result<Vec<Violations>, Error> {
    let mut all = Vec::new();
    for kind in KINDS {
        let mut random = Random::new("laws", kind.name(), seed);
        let given: Vec<Tuple> = (0..tuples).map(|at| tuple(kind, at % 2 == 0, &mut random)).collect();
        for law in Law::ALL.into_iter().filter(|law| law.is_about(kind)) {
            // A backend that declines is skipped.
            if let Ok(found) = held(backend, law, kind, &given) {
                all.push(found);
            }
        }
    }
    Ok(all)
}

/// Points of small integers, every second tuple degenerate.
fn tuple(kind: PredicateKind, is_degenerate: bool, random: &mut Random) -> Tuple {
    let wide = 1 << 20;
    let dimension = if matches!(kind, PredicateKind::Orient2d | PredicateKind::Incircle) { 2 } else { 3 };
    let mut point = |most: i64| -> Vec<i64> { (0..dimension).map(|_| random.integer(-most, most)).collect() };
    let mut points: Vec<Vec<i64>> = (0..kind.arity()).map(|_| point(wide)).collect();
    if is_degenerate {
        match kind {
            PredicateKind::Orient2d | PredicateKind::Orient3d => {
                // The last is a sum of the others with integer weights.
                points.iter_mut().for_each(|p| p.iter_mut().for_each(|x| *x /= 16));
                let weights: Vec<i64> = (1..kind.arity() - 1).map(|_| random.integer(-3, 3)).collect();
                let along = |axis: usize| {
                    let way = |(p, w): (&Vec<i64>, &i64)| w * (p[axis] - points[0][axis]);
                    points[0][axis] + points[1..].iter().zip(&weights).map(way).sum::<i64>()
                };
                let last: Vec<i64> = (0..dimension).map(along).collect();
                if let Some(end) = points.last_mut() {
                    *end = last;
                }
            }
            _ => {
                // On the circle of radius five, or the sphere of radius three, moved and scaled.
                const CIRCLE: [[i64; 3]; 6] = [[5, 0, 0], [3, 4, 0], [4, -3, 0], [-4, 3, 0], [-3, -4, 0], [0, 5, 0]];
                const SPHERE: [[i64; 3]; 6] = [[3, 0, 0], [1, 2, 2], [-2, 1, 2], [2, -2, 1], [-1, -2, -2], [0, 0, 3]];
                let table = if dimension == 2 { CIRCLE } else { SPHERE };
                let (centre, times) = (point(wide / 4), random.integer(1, 1 << 15));
                let first = usize::try_from(random.integer(0, 5)).unwrap_or(0);
                for (at, p) in points.iter_mut().enumerate() {
                    let on = table[(first + at) % table.len()];
                    *p = centre.iter().zip(on).map(|(c, x)| c + times * x).collect();
                }
            }
        }
    }
    points.into_iter().map(|p| p.into_iter().map(integer).collect()).collect()
}

/// The images of a tuple, and true if signs are opposite there.
fn images(law: Law, points: &Tuple) -> Vec<(Tuple, bool)> {
    let each = |map: &dyn Fn(&[f64]) -> Vec<f64>| points.iter().map(|p| map(p)).collect::<Tuple>();
    match law {
        Law::Scaling => {
            [300, -300].map(|k| (each(&|p| p.iter().map(|x| x * power_of_two(k)).collect()), false)).to_vec()
        }
        Law::Reflection => {
            vec![(each(&|p| p.iter().enumerate().map(|(axis, x)| if axis == 0 { -x } else { *x }).collect()), true)]
        }
        Law::Translation => [integer(12_345), power_of_two(40)]
            .map(|by| (each(&|p| p.iter().map(|x| x + by).collect()), false))
            .to_vec(),
        Law::Affine => {
            // Determinants 1 and -5; in space 1 and -13.
            const MATRICES: [[[f64; 3]; 3]; 2] =
                [[[2., 1., 0.], [1., 1., 0.], [3., 1., 1.]], [[1., 2., 0.], [3., 1., 0.], [0., 1., 1.]]];
            let map = |matrix: [[f64; 3]; 3]| {
                each(&|p| (0..p.len()).map(|row| p.iter().zip(matrix[row]).map(|(x, m)| x * m).sum()).collect())
            };
            vec![(map(MATRICES[0]), false), (map(MATRICES[1]), true)]
        }
        Law::Lift => vec![(each(&|p| [p, &[p[0] * p[0] + p[1] * p[1]]].concat()), false)],
        Law::Renaming => vec![(points.clone(), false)],
    }
}

fn held(backend: &dyn Contestant, law: Law, kind: PredicateKind, given: &[Tuple]) -> Result<Violations, Declined> {
    let question = question(kind);
    let asked = if law == Law::Lift { Question::Orient3d } else { question };
    let zero = backend.contract(kind).zero;
    let mut found = Violations {
        law: law.name().to_owned(),
        predicate: kind.name().to_owned(),
        backend: backend.name(),
        tuples: 0,
        violations: 0,
        silent: 0,
        first: String::new(),
    };
    for points in given {
        let (scene, args) = scene_of(points, false)?;
        let own = answer(backend, question, &scene, &args)?;
        let is_tie = zero == ZeroMeaning::Never && sign(&scene, question, &args).is_zero();
        for (image, is_opposite) in images(law, points) {
            let (scene, args) = scene_of(&image, law == Law::Renaming)?;
            let other = answer(backend, asked, &scene, &args)?;
            found.tuples += 1;
            let is_band = zero == ZeroMeaning::Band && !law.keeps_bands() && (own.is_zero() || other.is_zero());
            if is_tie || is_band {
                found.silent += 1;
            } else if other != if is_opposite { -own } else { own } {
                found.violations += 1;
                if found.first.is_empty() {
                    found.first = format!("{points:?}: {own:?}; {image:?}: {other:?}");
                }
            }
        }
    }
    Ok(found)
}

const fn question(kind: PredicateKind) -> Question {
    match kind {
        PredicateKind::Orient3d => Question::Orient3d,
        PredicateKind::Incircle => Question::Incircle,
        PredicateKind::Insphere => Question::Insphere,
        _ => Question::Orient2d(Plane::Xy),
    }
}

/// A scene of these points, in this order or reversed, and the vertices in the order of the points.
fn scene_of(points: &Tuple, is_reversed: bool) -> Result<(Scene, Vec<Vertex>), Declined> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    if is_reversed {
        order.reverse();
    }
    let scene = if points[0].len() == 2 {
        Scene::from_points2(&order.iter().map(|&at| [points[at][0], points[at][1]]).collect::<Vec<_>>())
    } else {
        Scene::from_points3(&order.iter().map(|&at| [points[at][0], points[at][1], points[at][2]]).collect::<Vec<_>>())
    };
    let scene = scene.map_err(|why| Declined::scene(why.to_string()))?;
    let args = order.iter().map(|&at| Vertex::input(at)).collect();
    Ok((scene, args))
}

fn answer(backend: &dyn Contestant, question: Question, scene: &Scene, args: &[Vertex]) -> Result<Sign, Declined> {
    backend.ask(scene, question, args).map(|(sign, _)| sign)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_have_the_signs_that_laws_say() {
        // By the judge, which does not use the laws.
        for kind in KINDS {
            let mut random = Random::new("laws", "test", 3);
            let mut zeros = 0;
            for at in 0..60 {
                let points = tuple(kind, at % 2 == 0, &mut random);
                let (scene, args) = scene_of(&points, false).unwrap();
                let own = sign(&scene, question(kind), &args);
                zeros += u32::from(own.is_zero());
                for law in Law::ALL.into_iter().filter(|law| law.is_about(kind)) {
                    for (image, is_opposite) in images(law, &points) {
                        let (scene, args) = scene_of(&image, law == Law::Renaming).unwrap();
                        let asked = if law == Law::Lift { Question::Orient3d } else { question(kind) };
                        let wanted = if is_opposite { -own } else { own };
                        assert_eq!(sign(&scene, asked, &args), wanted, "{law:?} {kind:?} {points:?}");
                    }
                }
            }
            assert!(zeros >= 30, "{kind:?}: {zeros}");
        }
    }
}
