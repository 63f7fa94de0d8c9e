//! Vertices where lines and planes meet, and questions about them.
//!
//! Scenes are made patch by patch: a few vertices are constructed, and queries choose among them and some input
//! vertices. Every set of argument positions is constructed in turn, from a single position to all.
//!
//! Ties come from a *base*: a line or plane whose points the question cannot distinguish, as the points of a line have
//! no turn. The constructed vertices lie on it, for one of two reasons, alternating by patch:
//! * the base is one of the lines and planes that meet, and the others are arbitrary: the meeting points differ in
//!   general;
//! * all lines and planes go through one rational point of the base: one point by many constructions.
//!
//! In both cases coordinates have long significands, and meeting points are hardly ever doubles. For queries one ulp
//! beside a tie, each construction has its own base, in which one point is moved.
//!
//! Circles and spheres have ties of their own (`round.rs`).

mod flats;
mod round;

use predicament_predicates::{Construction, Dimension, Question, Vertex};

use super::Cloud;
use crate::Random;
use crate::bits::{scale, step};
use flats::{Flat, Point, Source, meet};

/// The number of constructions in a patch: the maximum number of arguments of a query.
const CONSTRUCTIONS: usize = 4;
/// The number of queries about a patch.
const QUERIES: usize = 8;
/// The maximum number of coordinates of a patch: nine points for each construction, and as many input points as
/// constructions.
const MOST_IN_PATCH: u64 = 3 * 10 * CONSTRUCTIONS as u64;

/// The kinds of constructions in a scene, and their degeneracy.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Arrangement {
    /// The kinds: one, or two between which each construction chooses.
    pub kinds: &'static [Kind],
    /// The degeneracy.
    pub trouble: Trouble,
    /// The number of times that all coordinates are halved. Coordinates keep all bits, but their products underflow.
    pub halvings: i64,
}

/// A kind of construction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Two lines in the plane.
    Ssi,
    /// A line and a plane.
    Lpi,
    /// Three planes.
    Tpi,
}

/// The degeneracy of constructed vertices.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Trouble {
    /// Independent random points.
    Uniform,
    /// Ties.
    Degenerate,
    /// At most `ulps` ulps beside ties.
    Near {
        /// The number of ulps.
        ulps: i64,
    },
}

impl Arrangement {
    /// An approximate upper bound on the number of coordinates of `n` queries.
    #[must_use]
    pub fn coordinates(n: u64) -> u64 {
        n.div_ceil(QUERIES as u64) * MOST_IN_PATCH
    }

    /// The dimension of the points.
    #[must_use]
    pub fn dimension(self) -> Dimension {
        if self.kinds == [Kind::Ssi] { Dimension::Two } else { Dimension::Three }
    }

    /// A scene of `n` queries with their points, placed for the question.
    #[must_use]
    pub fn queries(self, question: Question, n: usize, rng: Random) -> Cloud {
        if question.kind().is_lifted() {
            return round::queries(self, question, n, rng);
        }
        let arity = question.kind().arity();
        let mut scene = Draft { arrangement: self, question, rng, coordinates: Vec::new(), constructions: Vec::new() };
        let mut args = Vec::with_capacity((n + QUERIES) * arity);
        for patch in 0..n.div_ceil(QUERIES) {
            let pool = scene.patch(patch % 2 == 1);
            for query in 0..QUERIES {
                let places = 1 + (patch * QUERIES + query) % ((1 << arity) - 1);
                args.extend(scene.choose(&pool, arity, places));
            }
        }
        args.truncate(n * arity);
        scene.coordinates.iter_mut().for_each(|x| *x = scale(*x, -self.halvings));
        Cloud { coordinates: scene.coordinates, args: Some(args), constructions: scene.constructions }
    }
}

/// A scene under construction.
struct Draft {
    arrangement: Arrangement,
    question: Question,
    rng: Random,
    coordinates: Vec<f64>,
    constructions: Vec<Construction>,
}

/// The vertices available to the queries of a patch.
struct Pool {
    input: Vec<Vertex>,
    constructed: Vec<Vertex>,
}

/// A line or plane of a patch: its points, and their vertices if they exist already.
struct Spanned {
    points: Flat,
    vertices: Option<Vec<Vertex>>,
}

impl Draft {
    /// Constructs the vertices for the next queries.
    fn patch(&mut self, through_one_point: bool) -> Pool {
        let tied = self.arrangement.trouble != Trouble::Uniform;
        let source = match tied && through_one_point {
            true => Source::pencil(self.question, &mut self.rng),
            false => Source::Anywhere,
        };
        let dimension = self.arrangement.dimension();
        let base = if tied {
            source.base(self.question, dimension, &mut self.rng)
        } else {
            source.hyperplane(Dimension::Three, &mut self.rng)
        };
        let input: Vec<Vertex> = base.iter().map(|&point| self.moved_vertex(point)).collect();
        let constructed = (0..CONSTRUCTIONS)
            .map(|_| {
                let kinds = self.arrangement.kinds;
                let kind = if self.rng.one_in(2) { kinds[0] } else { kinds[kinds.len() - 1] };
                let base = (tied && !through_one_point).then_some((base.as_slice(), input.as_slice()));
                self.construct(kind, &source, base)
            })
            .collect();
        Pool { input, constructed }
    }

    /// A vertex where lines and planes of the source meet, including the base if there is one.
    fn construct(&mut self, kind: Kind, source: &Source, base: Option<(&[Point], &[Vertex])>) -> Vertex {
        let dimension = self.arrangement.dimension();
        let flats = loop {
            let inside = kind == Kind::Lpi && self.rng.one_in(2);
            let first = match base {
                Some((points, vertices)) => self.of_base(points, vertices, inside),
                None if inside => Spanned::new(source.line(dimension, &mut self.rng)),
                None => Spanned::new(source.hyperplane(dimension, &mut self.rng)),
            };
            let others = if kind == Kind::Tpi { 2 } else { 1 };
            let others: Vec<Spanned> = (0..others)
                .map(|_| match (kind, inside) {
                    (Kind::Lpi, false) => source.line(dimension, &mut self.rng),
                    _ => source.hyperplane(dimension, &mut self.rng),
                })
                .map(Spanned::new)
                .collect();
            let mut flats: Vec<Spanned> = [first].into_iter().chain(others).collect();
            self.disturb(&mut flats[0]);
            // A line before its plane.
            flats.sort_by_key(|flat| flat.points.len());
            if meet(dimension, &flats.iter().map(|flat| flat.points.as_slice()).collect::<Vec<_>>()) {
                break flats;
            }
        };
        let vertices: Vec<Vec<Vertex>> = flats
            .into_iter()
            .map(|flat| match flat.vertices {
                Some(vertices) => vertices,
                None => flat.points.into_iter().map(|point| self.vertex(point)).collect(),
            })
            .collect();
        let construction = match (kind, vertices.as_slice()) {
            (Kind::Ssi, [first, second]) => Construction::Ssi([line(first), line(second)]),
            (Kind::Lpi, [ends, spanning]) => Construction::Lpi { line: line(ends), plane: plane(spanning) },
            (Kind::Tpi, [first, second, third]) => Construction::Tpi([plane(first), plane(second), plane(third)]),
            _ => unreachable!("two or three parts"),
        };
        self.constructions.push(construction);
        Vertex::constructed(self.constructions.len() - 1)
    }

    /// The base, or a line in it.
    fn of_base(&mut self, points: &[Point], vertices: &[Vertex], line: bool) -> Spanned {
        let left_out = if line { self.rng.integer(0, 2) } else { -1 };
        let kept = |&(at, _): &(usize, _)| i64::try_from(at) != Ok(left_out);
        let (points, vertices) =
            points.iter().copied().zip(vertices.iter().copied()).enumerate().filter(kept).map(|(_, pair)| pair).unzip();
        Spanned { points, vertices: Some(vertices) }
    }

    /// Moves a point of the flat if ties are to be missed; the flat then gets its own vertices.
    fn disturb(&mut self, flat: &mut Spanned) {
        if let Trouble::Near { ulps } = self.arrangement.trouble {
            let last = i64::try_from(flat.points.len()).expect("three at most") - 1;
            let at = self.rng.integer(0, last);
            let point = &mut flat.points[usize::try_from(at).expect("not negative")];
            *point = point.map(|x| step(x, self.rng.integer(-ulps, ulps)));
            flat.vertices = None;
        }
    }

    /// A new vertex, moved if ties are to be missed.
    fn moved_vertex(&mut self, point: Point) -> Vertex {
        match self.arrangement.trouble {
            Trouble::Near { ulps } => {
                let moved = point.map(|x| step(x, self.rng.integer(-ulps, ulps)));
                self.vertex(moved)
            }
            Trouble::Uniform | Trouble::Degenerate => self.vertex(point),
        }
    }

    /// A new vertex, with its first coordinate on the first axis of the question.
    fn vertex(&mut self, point: Point) -> Vertex {
        let first = match self.question {
            Question::Compare(axis) => axis.index(),
            Question::Orient2d(plane) => plane.axes()[0].index(),
            Question::Orient3d | Question::Incircle | Question::Insphere | Question::Derived(_) => 0,
        };
        let width = self.arrangement.dimension().count();
        let vertex = Vertex::input(self.coordinates.len() / width);
        self.coordinates.extend((0..width).map(|axis| point[(axis + width - first) % width]));
        vertex
    }

    /// Different vertices: constructed ones at these argument positions (a bit set), input vertices at the others.
    fn choose(&mut self, pool: &Pool, arity: usize, places: usize) -> Vec<Vertex> {
        let (mut input, mut constructed) = (pool.input.clone(), pool.constructed.clone());
        let mut draw = |from: &mut Vec<Vertex>| {
            let last = i64::try_from(from.len()).expect("a handful") - 1;
            from.swap_remove(usize::try_from(self.rng.integer(0, last)).expect("not negative"))
        };
        (0..arity).map(|place| draw(if places >> place & 1 == 1 { &mut constructed } else { &mut input })).collect()
    }
}

impl Spanned {
    fn new(points: Flat) -> Spanned {
        Spanned { points, vertices: None }
    }
}

fn line(vertices: &[Vertex]) -> [Vertex; 2] {
    vertices.try_into().expect("two points span a line")
}

fn plane(vertices: &[Vertex]) -> [Vertex; 3] {
    vertices.try_into().expect("three points span a plane")
}
