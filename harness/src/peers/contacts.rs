//! Other ways to the pairs of two complexes that cross: the sweep of the crate
//! `geo` over all edges of both (in the plane), and an R-tree of the crate
//! `rstar` over the boxes of the second, with our exact test.
//!
//! Neither knows degenerate contacts, so both are asked only about scenes that
//! have none, where all that meets are pairs of the hierarchy's last level.

use std::hint::black_box;
use std::rc::Rc;
use std::time::{Duration, Instant};

use geo::sweep::{Cross, Intersections};
use geo::{Coord, Line};
use predicament_contacts::algorithm::pairs::{Contact, contacts};
use predicament_contacts::task::Complexes;
use predicament_exact::Exact;
use predicament_judge::Judged;
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Axis, Backend, Dimension, Off, Plane, Predicates, Scene, Vertex};
use predicament_records::Interface;
use predicament_tasks::{AnyCase, Class, Outcome, Stopwatch, digest};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, Point, RTree};

use super::{Peer, Timed};

/// A simplex of each complex.
type Pair = [Simplex; 2];

/// Two complexes, and the pairs of them that meet by the judge's signs.
#[derive(Clone)]
struct Case<'a> {
    scene: &'a Scene,
    complexes: [&'a Complex; 2],
    truth: Rc<[Contact]>,
}

/// Those that can answer about a scene in general position, where the case is one of contacts.
pub fn peers(case: &dyn AnyCase) -> Vec<Peer<'_>> {
    let scene = &case.loaded().scene;
    let case = case.loaded().content::<Complexes>().map(|content| {
        let truth = contacts(&Judged::exact(scene), &content.a, &content.b).registered.into();
        Case { scene, complexes: content.both(), truth }
    });
    case.map(of).unwrap_or_default()
}

fn of(case: Case<'_>) -> Vec<Peer<'_>> {
    let dimension = case.scene.dimension();
    let degenerate = case.truth.iter().any(|contact| usize::from(contact.a.rank + contact.b.rank) < dimension.count());
    let session = || Exact.prepare(case.scene, Off).expect("the truth is known");
    let swept = case.clone();
    let sweep = move |pairs: &mut Vec<Pair>| sweep(&swept, pairs);
    let asked = case.clone();
    let tree_version = env!("PREDICAMENT_RSTAR");
    match dimension {
        Dimension::Two => {
            let session = session();
            let tree = move |pairs: &mut Vec<Pair>| by_tree::<_, [f64; 2]>(&session, &asked, pairs);
            vec![
                peer("geo:sweep", env!("PREDICAMENT_GEO"), &case, degenerate, sweep),
                peer("rstar", tree_version, &case, degenerate, tree),
            ]
        }
        Dimension::Three => {
            let session = session();
            let tree = move |pairs: &mut Vec<Pair>| by_tree::<_, [f64; 3]>(&session, &asked, pairs);
            vec![peer("rstar", tree_version, &case, degenerate, tree)]
        }
    }
}

fn peer<'a>(
    name: &str,
    version: &str,
    case: &Case<'a>,
    degenerate: bool,
    find: impl FnMut(&mut Vec<Pair>) + 'a,
) -> Peer<'a> {
    let [a, b] = case.complexes;
    let queries = (a.len() + b.len()) as u64;
    let (name, version) = (name.to_owned(), version.to_owned());
    if degenerate {
        let why = "it has no answer to degenerate contacts, and the scene has some".to_owned();
        let outcome = Outcome::of_scene(queries, Class::Declined, "general position", why);
        return Peer { name, version, outcome, timed: None, remarks: Vec::new() };
    }
    let mut watch = Watch { find, pairs: Vec::new() };
    watch.pass();
    let judged = watch.digest();
    let mut found = watch.pairs.clone();
    found.sort_unstable();
    let mut truth: Vec<Pair> = case.truth.iter().map(|contact| [contact.a, contact.b]).collect();
    truth.sort_unstable();
    let mut outcome = Outcome { queries, ..Outcome::default() };
    let repeated = found.len();
    found.dedup();
    let repeated = repeated - found.len();
    let agree = truth.iter().filter(|pair| found.binary_search(pair).is_ok()).count();
    let (missing, extra) = (truth.len() - agree, found.len() - agree);
    outcome.counts.add(Class::Agree, agree as u64);
    outcome.counts.add(Class::SignFlip, (missing + extra + repeated) as u64);
    let wrong = missing + extra + repeated > 0;
    let remark = format!("{name} misses {missing} pairs, has {extra} that don't meet, and {repeated} twice");
    let remarks = wrong.then_some(remark).into_iter().collect();
    Peer {
        name,
        version,
        outcome,
        timed: Some(Timed { watch: Box::new(watch), interface: Interface::Whole, judged }),
        remarks,
    }
}

struct Watch<F> {
    find: F,
    pairs: Vec<Pair>,
}

impl<F: FnMut(&mut Vec<Pair>)> Stopwatch for Watch<F> {
    fn pass(&mut self) -> Duration {
        self.pairs.clear();
        let start = Instant::now();
        (self.find)(&mut self.pairs);
        black_box(&mut self.pairs);
        start.elapsed()
    }

    fn digest(&self) -> u64 {
        let simplices = self.pairs.as_flattened().iter();
        digest(simplices.flat_map(|simplex| [u32::from(simplex.rank), simplex.index]).flat_map(u32::to_le_bytes))
    }
}

/// An edge as `geo` wants it.
#[derive(Clone, Copy, Debug)]
struct Edge {
    line: Line,
    of_b: bool,
    index: u32,
}

impl Cross for Edge {
    type Scalar = f64;

    fn line(&self) -> Line {
        self.line
    }
}

/// Meeting edges among all of both; those of one complex are dropped.
fn sweep(case: &Case<'_>, pairs: &mut Vec<Pair>) {
    let [a, b] = case.complexes.map(Complex::edges);
    let at = |v: Vertex| {
        let [x, y] = case.scene.point2(Plane::Xy, v);
        Coord { x, y }
    };
    let edges = |of: &[[Vertex; 2]], of_b: bool| -> Vec<Edge> {
        let lines = of.iter().map(|&[p, q]| Line::new(at(p), at(q)));
        lines.zip(0..).map(|(line, index)| Edge { line, of_b, index }).collect()
    };
    let all: Intersections<Edge> = edges(a, false).into_iter().chain(edges(b, true)).collect();
    let simplex = |edge: Edge| Simplex { rank: 1, index: edge.index };
    pairs.extend(all.filter(|(e, f, _)| e.of_b != f.of_b).map(|(e, f, _)| {
        let [e, f] = if e.of_b { [f, e] } else { [e, f] };
        [simplex(e), simplex(f)]
    }));
}

/// A point of the tree's dimension.
trait Place: Point<Scalar = f64> {
    fn of(scene: &Scene, v: Vertex) -> Self;
}

impl Place for [f64; 2] {
    fn of(scene: &Scene, v: Vertex) -> [f64; 2] {
        scene.point2(Plane::Xy, v)
    }
}

impl Place for [f64; 3] {
    fn of(scene: &Scene, v: Vertex) -> [f64; 3] {
        [Axis::X, Axis::Y, Axis::Z].map(|axis| scene.coordinate(axis, v))
    }
}

fn bounds<P: Place>(scene: &Scene, vertices: &[Vertex]) -> AABB<P> {
    let points: Vec<P> = vertices.iter().map(|&v| P::of(scene, v)).collect();
    AABB::from_points(&points)
}

/// For each pair of ranks of the last level, a tree of the second complex' boxes.
fn by_tree<S: Predicates, P: Place>(session: &S, case: &Case<'_>, pairs: &mut Vec<Pair>) {
    let (scene, [a, b]) = (case.scene, case.complexes);
    let ranks: &[[u8; 2]] = match scene.dimension() {
        Dimension::Two => &[[1, 1]],
        Dimension::Three => &[[1, 2], [2, 1]],
    };
    let all = |complex: &Complex, rank: u8| {
        let count = if rank == 1 { complex.edges().len() } else { complex.triangles().len() };
        (0..u32::try_from(count).expect("few")).map(move |index| Simplex { rank, index })
    };
    for &[rank_a, rank_b] in ranks {
        let boxed = |t: Simplex| {
            let bounds = bounds::<P>(scene, b.vertices_of(t));
            GeomWithData::new(Rectangle::from_aabb(bounds), t)
        };
        let tree = RTree::bulk_load(all(b, rank_b).map(boxed).collect());
        for s in all(a, rank_a) {
            let of_s = a.vertices_of(s);
            let near = tree.locate_in_envelope_intersecting(&bounds::<P>(scene, of_s));
            let meet = near.map(|near| near.data).filter(|&t| meets(session, of_s, b.vertices_of(t)));
            pairs.extend(meet.map(|t| [s, t]));
        }
    }
}

fn meets<S: Predicates>(session: &S, s: &[Vertex], t: &[Vertex]) -> bool {
    match (s, t) {
        (&[c, d], &[e, f]) => session.edge_edge([c, d], [e, f]).is_some(),
        (&[p, q], &[c, d, e]) | (&[c, d, e], &[p, q]) => session.triangle_edge([c, d, e], [p, q]).is_some(),
        _ => unreachable!("no pair of the last level of closed curves or surfaces"),
    }
}
