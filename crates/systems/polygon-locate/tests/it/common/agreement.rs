//! Comparison of all methods of point location.
//!
//! The truth is winding numbers in rationals. The paper's own test runs in its plain form and in its indexed form. The
//! generic code runs twice, by its shortcut and with a query about every edge.

use predicament_exact::Exact;
use predicament_mesh::PolygonMap;
use predicament_polygon_locate::algorithm::special::{self, OnEdge, Point};
use predicament_polygon_locate::algorithm::{LocateIndex, Location, Scratch};
use predicament_predicates::{Backend, Off, Plane, Predicates, Scene, Sign, Vertex};
use predicament_sos::Sos;
use rug::Rational;

use super::maps::problem;
use crate::common::winding::{Truth, brute_force, with};

/// A map with positions that are probed twice: by a vertex numbered before all of the map's vertices, and by a vertex
/// numbered after them.
pub struct Probed {
    pub map: PolygonMap,
    pub scene: Scene,
    index: LocateIndex,
    places: usize,
}

/// The sign of the paper's determinant, written out along its first column.
pub fn sign_of_d(l: Point, r: Point, p: Point) -> Sign {
    let [l, r, p] = [l, r, p].map(|point| point.map(|c| Rational::from_f64(c).expect("finite")));
    let minor = |v: &[Rational; 2], w: &[Rational; 2]| Rational::from(&v[1] - &w[1]);
    let d = &l[0] * minor(&r, &p) - &r[0] * minor(&l, &p) + &p[0] * minor(&l, &r);
    Sign::from(d.cmp0())
}

/// The sign of D for p + (ε, ε²) where D is zero: moved to the right and less up.
pub fn sign_of_moved_d(l: Point, r: Point, p: Point) -> Sign {
    match sign_of_d(l, r, p) {
        Sign::Zero if l[1] < r[1] => Sign::Negative,
        Sign::Zero => Sign::Positive,
        sign => sign,
    }
}

impl Probed {
    pub fn new(points: &[[f64; 2]], regions: &[Vec<Vec<usize>>], places: &[[f64; 2]]) -> Probed {
        let (map, _) = problem(points, regions);
        let all: Vec<[f64; 2]> = [places, points, places].concat();
        let (map, scene) = (map.shifted(places.len()), Scene::from_points2(&all).expect("finite"));
        Probed { index: LocateIndex::new(&map, &scene), map, scene, places: places.len() }
    }

    /// The two vertices at a position: the one before the map, and the one after it.
    pub fn probes(&self, place: usize) -> [Vertex; 2] {
        [place, self.scene.len() - self.places + place].map(Vertex::input)
    }

    /// Asserts that all methods agree about all positions.
    pub fn check(&self) {
        let sos = Sos::default();
        let sessions = (Exact.prepare(&self.scene, Off).unwrap(), sos.prepare(&self.scene, Off).unwrap());
        if let Some(first) = self.disagreements(&sessions.0, &sessions.1, &sign_of_d).first() {
            panic!("{first}\nin {:?}\nof {:?}", self.map, self.scene);
        }
    }

    /// Descriptions of the positions at which a session that should be exact, one that should break ties, or a
    /// determinant that should be right, is wrong.
    pub fn disagreements(
        &self,
        exact: &impl Predicates,
        sos: &impl Predicates,
        sign_of_d: &impl Fn(Point, Point, Point) -> Sign,
    ) -> Vec<String> {
        let mut found = Vec::new();
        for place in 0..self.places {
            let [before, after] = self.probes(place);
            let point = self.scene.point2(Plane::Xy, before);
            let truths = brute_force(&self.map, &self.scene, before);
            let (inside, boundary) = (with(&truths, Truth::Inside), with(&truths, Truth::Boundary));
            let mut expect = |is: bool, what: &str| {
                if !is {
                    found.push(format!("{what}, at {point:?}"));
                }
            };
            for q in [before, after] {
                expect(self.generic(exact, q) == Some([inside.clone(), boundary.clone()]), "exact");
            }

            let special = special::locate(&self.map, &self.scene, point, sign_of_d);
            let of = |answer| of_answer(&special, answer);
            let (crossed, silent) = (of(Ok(true)), of(Ok(false)));
            let special = Some([crossed.clone(), of(Err(OnEdge))]);
            expect(self.specially(before, sign_of_d) == special, "the special forms");
            expect(of(Err(OnEdge)).iter().all(|on| boundary.contains(on)), "step 5 has an error off a boundary");
            let off = |regions: &[u32]| -> Vec<u32> {
                regions.iter().copied().filter(|region| !boundary.contains(region)).collect()
            };
            expect(off(&crossed) == inside, "the special test");

            // ties are broken as the paper does, wherever it has an answer
            let [sos_before, sos_after] = [before, after].map(|q| self.generic(sos, q));
            let answers = |q: &Option<[Vec<u32>; 2]>| q.as_ref().map(|[inside, _]| inside.clone()).unwrap_or_default();
            expect(sos_before.as_ref().is_some_and(|[_, on]| on.is_empty()), "sos sees a boundary");
            expect(sos_after.as_ref().is_some_and(|[_, on]| on.is_empty()), "sos sees a boundary from the last vertex");
            let sos_before = answers(&sos_before);
            expect(crossed.iter().all(|region| sos_before.contains(region)), "sos misses what the special test has");
            expect(silent.iter().all(|region| !sos_before.contains(region)), "sos has what the special test misses");
            expect(off(&answers(&sos_after)) == inside, "sos, from the last vertex");
            let moved = special::locate(&self.map, &self.scene, point, &|l, r, p| match sign_of_d(l, r, p) {
                Sign::Zero => sign_of_moved_d(l, r, p),
                sign => sign,
            });
            expect(of_answer(&moved, Ok(true)) == sos_before, "sos against the special test of the moved point");
        }
        found
    }

    /// The regions that contain `q`, and those whose boundary does, if the shortcut and the query about every edge
    /// agree.
    fn generic(&self, session: &impl Predicates, q: Vertex) -> Option<[Vec<u32>; 2]> {
        let mut scratch = Scratch::new();
        let shortcut = lists(self.index.locate(session, q, &mut scratch));
        (shortcut == lists(self.index.question(session, q, &mut scratch))).then_some(shortcut)
    }

    /// The regions by both indexed forms of the paper's test, if they agree.
    fn specially(&self, q: Vertex, sign_of_d: &impl Fn(Point, Point, Point) -> Sign) -> Option<[Vec<u32>; 2]> {
        let mut scratch = Scratch::new();
        let point = self.scene.point2(Plane::Xy, q);
        let shortcut = lists(self.index.locate_specially(point, sign_of_d, &mut scratch));
        let all_asked = lists(self.index.question_specially(&self.scene, q, sign_of_d, &mut scratch));
        (shortcut == all_asked).then_some(shortcut)
    }
}

fn lists(location: Location) -> [Vec<u32>; 2] {
    [location.inside, location.boundary].map(<[u32]>::to_vec)
}

fn of_answer(answers: &[Result<bool, OnEdge>], wanted: Result<bool, OnEdge>) -> Vec<u32> {
    (0..).zip(answers).filter(|(_, answer)| **answer == wanted).map(|(region, _)| region).collect()
}

/// All points with coordinates from `low` to `high` in steps of `step`.
pub fn grid(low: f64, high: f64, step: f64) -> Vec<[f64; 2]> {
    let along: Vec<f64> = std::iter::successors(Some(low), |x| Some(x + step)).take_while(|x| *x <= high).collect();
    along.iter().flat_map(|&y| along.iter().map(move |&x| [x, y])).collect()
}
