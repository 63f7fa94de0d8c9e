//! Scenes with constructions: a first level, deeper levels, and a definition that gives no point; with queries about
//! all of them and the exact answers.

use std::sync::LazyLock;

use predicament_judge::{determinant, point};
use predicament_predicates::{Axis, Construction, Dimension, Plane, Predicates, Question, Scene, Share, Sign, Vertex};
use rug::Rational;

/// The random number generator xorshift64 (Marsaglia 2003).
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from((self.0 >> 20) % n as u64).unwrap()
    }

    fn distinct<const N: usize>(&mut self, from: &[Vertex]) -> [Vertex; N] {
        let mut left = from.to_vec();
        std::array::from_fn(|_| left.swap_remove(self.below(left.len())))
    }

    /// Three planes of input vertices only: deeper constructions have long rows, too slow for a judge in rationals.
    fn definition(&mut self, dimension: Dimension, from: &[Vertex]) -> Construction {
        match dimension {
            _ if self.below(4) == 0 => {
                let numerator = i64::try_from(self.below(9)).unwrap() - 2;
                Construction::Ratio { ends: self.distinct(from), share: Share::new(numerator, 7).unwrap() }
            }
            Dimension::Two => Construction::Ssi([self.distinct(from), self.distinct(from)]),
            Dimension::Three if !from[0].is_constructed() && self.below(3) == 0 => {
                Construction::Tpi([self.distinct(from), self.distinct(from), self.distinct(from)])
            }
            Dimension::Three => Construction::Lpi { line: self.distinct(from), plane: self.distinct(from) },
        }
    }
}

pub struct Case {
    /// Two meshes, for the backend that needs them; the last points are for `degenerate`.
    pub scene: Scene,
    /// Constructions from input vertices.
    pub first: Vec<Construction>,
    /// Constructions from the first level, and in the plane also from each other.
    pub deep: Vec<Construction>,
    /// Parallel lines, or a line parallel to a plane.
    pub degenerate: Construction,
    /// The queries about each constructed vertex, in the order of the vertices.
    asked: Vec<Vec<Asked>>,
}

/// A question, its vertices, and the exact sign.
pub type Asked = (Question, Vec<Vertex>, Sign);

impl Case {
    /// The queries about the vertices of some constructions and about earlier vertices.
    pub fn asked(&self, constructed: std::ops::Range<usize>) -> impl Iterator<Item = &Asked> {
        self.asked[constructed].iter().flatten()
    }

    /// The constructed vertices of the levels that a session has constructed completely.
    pub fn known(&self, session: &dyn Predicates) -> std::ops::Range<usize> {
        let (first, constructed) = (self.first.len(), session.scene().constructions().len());
        let levels = [0, first, first + self.deep.len()];
        0..levels.into_iter().rfind(|&level| level <= constructed).unwrap_or(0)
    }
}

/// The two cases: first the plane, then space.
pub static CASES: LazyLock<[Case; 2]> = LazyLock::new(|| [case(Dimension::Two), case(Dimension::Three)]);

/// Builds a case; all points are random except the last ones.
fn case(dimension: Dimension) -> Case {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let points = 8;
    // Large, so that rounding is larger than any epsilon; of few bits, so that cascades stay short.
    #[allow(clippy::cast_precision_loss)] // below 2^21
    let mut coordinates: Vec<f64> = (0..points * dimension.count()).map(|_| (random.below(16) << 17) as f64).collect();
    let v = |at: usize| Vertex::input(points + at);
    let degenerate = match dimension {
        Dimension::Two => {
            coordinates.extend([0.0, 0.0, 64.0, 32.0, 0.0, 16.0, 64.0, 48.0]);
            Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])
        }
        Dimension::Three => {
            coordinates.extend([0.0, 0.0, 0.0, 64.0, 0.0, 0.0, 0.0, 64.0, 0.0, 8.0, 8.0, 8.0, 16.0, 32.0, 8.0]);
            Construction::Lpi { line: [v(3), v(4)], plane: [v(0), v(1), v(2)] }
        }
    };
    let scene = Scene::new(dimension, coordinates).unwrap();
    let scene = scene.with_second_mesh((0..points).step_by(2).map(Vertex::input));
    let inputs: Vec<Vertex> = (0..points).map(Vertex::input).collect();
    let mut grown = scene.clone();
    let first = level(&mut random, &mut grown, &inputs, 6);
    let mut deep = Vec::new();
    // One level in space: the rationals of the judge grow far faster than the rows of a backend.
    let levels = if dimension == Dimension::Two { 2 } else { 1 };
    for _ in 0..levels {
        let last = grown.constructions().len() - 4..grown.constructions().len();
        let from: Vec<Vertex> = last.map(Vertex::constructed).chain(inputs[..2].iter().copied()).collect();
        deep.extend(level(&mut random, &mut grown, &from, 4));
    }
    let asked = asked(&grown, first.len());
    Case { scene, first, deep, degenerate, asked }
}

/// Constructions that give points, from these vertices. All of them are added to the scene.
fn level(random: &mut Random, scene: &mut Scene, from: &[Vertex], count: usize) -> Vec<Construction> {
    let mut level = Vec::new();
    while level.len() < count {
        let definition = random.definition(scene.dimension(), from);
        let mut with = scene.clone();
        let vertex = with.construct(definition).unwrap();
        if with.constructions().len() > scene.constructions().len() && point(&with, vertex).is_some() {
            level.push(definition);
            *scene = with;
        }
    }
    level
}

/// The queries about each constructed vertex: whether it is on the lines and planes that define it, and random queries.
/// The random queries about the first vertices use vertices of their level only.
fn asked(scene: &Scene, first: usize) -> Vec<Vec<Asked>> {
    let (axes, planes): (&[Axis], &[Plane]) = match scene.dimension() {
        Dimension::Two => (&[Axis::X, Axis::Y], &[Plane::Xy]),
        Dimension::Three => (&[Axis::X, Axis::Y, Axis::Z], &[Plane::Xy, Plane::Yz, Plane::Zx]),
    };
    let count = scene.constructions().len();
    let all: Vec<Vertex> = scene.vertices().chain((0..count).map(Vertex::constructed)).collect();
    let points: Vec<Vec<Rational>> = all.iter().map(|&v| point(scene, v).unwrap()).collect();
    let mut random = Random(0xbf58_476d_1ce4_e5b9);
    let about = |index: usize| {
        let x = Vertex::constructed(index);
        let mut questions = Vec::new();
        for flat in scene.construction(x).unwrap().flats() {
            let args = [flat, &[x]].concat();
            match flat.len() {
                2 => questions.extend(planes.iter().map(|&plane| (Question::Orient2d(plane), args.clone()))),
                _ => questions.push((Question::Orient3d, args)),
            }
        }
        let known = scene.len() + if index < first { first } else { count };
        let mut other = || all[random.below(known)];
        questions.extend(axes.iter().map(|&axis| (Question::Compare(axis), vec![x, other()])));
        questions.extend(planes.iter().map(|&plane| (Question::Orient2d(plane), vec![other(), x, other()])));
        if scene.dimension() == Dimension::Three {
            questions.push((Question::Orient3d, vec![other(), x, other(), other()]));
        }
        let place = |v: &Vertex| v.construction().map_or(v.index(), |index| scene.len() + index);
        let truth = |(question, args): (Question, Vec<Vertex>)| {
            let sign = truth(question, &args.iter().map(|v| &points[place(v)]).collect::<Vec<_>>());
            (question, args, sign)
        };
        questions.into_iter().map(truth).collect()
    };
    (0..count).map(about).collect()
}

/// The sign of the determinant of differences to the last point.
fn truth(question: Question, points: &[&Vec<Rational>]) -> Sign {
    let axes = match question {
        Question::Compare(axis) => vec![axis.index()],
        Question::Orient2d(plane) => plane.axes().map(Axis::index).to_vec(),
        _ => vec![0, 1, 2],
    };
    let (last, others) = points.split_last().unwrap();
    let row = |p: &&Vec<Rational>| axes.iter().map(|&i| Rational::from(&p[i] - &last[i])).collect();
    determinant(&others.iter().map(row).collect::<Vec<_>>()).cmp0().into()
}
