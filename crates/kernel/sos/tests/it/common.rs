//! Scenes full of ties, and the common checks of all tests.

pub mod substitution;

use predicament_predicates::{Axis, Plane, PredicateKind, Predicates, Question, Scene, SceneError, Sign, Vertex};

/// All questions of a scene of this dimension.
pub fn questions(dimension: usize) -> Vec<Question> {
    use Question::{Compare, Incircle, Insphere, Orient2d, Orient3d};
    let mut questions = vec![Compare(Axis::X), Compare(Axis::Y), Orient2d(Plane::Xy)];
    if dimension == 2 {
        questions.push(Incircle);
    } else {
        questions.extend([Compare(Axis::Z), Orient2d(Plane::Yz), Orient2d(Plane::Zx), Orient3d, Insphere]);
    }
    questions
}

/// The question of a kind that uses the first axes.
pub fn question(kind: PredicateKind) -> Question {
    kind.first_question()
}

pub fn ids<const N: usize>(indices: [usize; N]) -> [Vertex; N] {
    indices.map(Vertex::input)
}

pub fn first(n: usize) -> Vec<Vertex> {
    (0..n).map(Vertex::input).collect()
}

/// The point with this number in the grid {0, …, side − 1}^dimension.
pub fn grid_point(dimension: usize, side: usize, number: usize) -> Vec<f64> {
    let digit = |axis| number / side.pow(u32::try_from(axis).unwrap()) % side;
    (0..dimension).map(|axis| f64::from(u32::try_from(digit(axis)).unwrap())).collect()
}

/// A scene from grid points by number; numbers may repeat.
pub fn grid_scene(dimension: usize, side: usize, numbers: &[usize]) -> Scene {
    let coordinates = numbers.iter().flat_map(|&number| grid_point(dimension, side, number)).collect();
    scene(dimension, coordinates).unwrap()
}

pub fn scene(dimension: usize, coordinates: Vec<f64>) -> Result<Scene, SceneError> {
    use predicament_predicates::Dimension::{Three, Two};
    Scene::new(if dimension == 2 { Two } else { Three }, coordinates)
}

/// All words of `length` digits below `base`.
pub fn words(base: usize, length: u32) -> impl Iterator<Item = Vec<usize>> {
    (0..base.pow(length)).map(move |word| (0..length).map(|place| word / base.pow(place) % base).collect())
}

/// All permutations of 0..n with their signs.
pub fn permutations(n: usize) -> Vec<(Vec<usize>, Sign)> {
    let Some(largest) = n.checked_sub(1) else { return vec![(Vec::new(), Sign::Positive)] };
    let mut all = Vec::new();
    for (shorter, sign) in permutations(largest) {
        for place in 0..n {
            let mut longer = shorter.clone();
            longer.insert(place, largest);
            all.push((longer, if (largest - place) % 2 == 0 { sign } else { -sign }));
        }
    }
    all
}

/// A small generator for reproducible samples (splitmix64).
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^= x >> 31;
        usize::try_from(x % u64::try_from(bound).unwrap()).unwrap()
    }

    pub fn numbers(&mut self, bound: usize, count: usize) -> Vec<usize> {
        (0..count).map(|_| self.below(bound)).collect()
    }
}

/// Asks every permutation of the arguments and checks that all agree up to sign.
pub fn ask_antisymmetric<P: Predicates>(session: &P, question: Question, args: &[Vertex]) -> Sign {
    let answer = question.ask(session, args);
    for (permutation, sign) in permutations(args.len()) {
        let permuted: Vec<Vertex> = permutation.iter().map(|&place| args[place]).collect();
        assert_eq!(question.ask(session, &permuted), answer * sign, "{question:?} {permutation:?}");
    }
    answer
}
