//! Tests of overlays on any number of threads, and by meaningless signs.

use std::collections::BTreeMap;

use predicament_exact::Exact;
use predicament_mesh_intersect::algorithm::overlay::{MeshOverlay, Piece, Regions, Solid, Undone, Zeros, mesh_overlay};
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{
    Backend, Construction, Off, Predicates, Question, Refused, Scene, Sign, Vertex, answer_by, forward_to,
};
use predicament_sos::{PerMesh, Sos};

use crate::common::liar::{Liar, Slip};
use crate::common::overlaid::Pair;
use crate::common::shapes::{Random, Shape};

/// All data of an overlay.
type Told = (Vec<Construction>, [Vec<Piece>; 2], Vec<Solid>, Regions);

fn told(overlay: &MeshOverlay) -> Told {
    let pieces = [0, 1].map(|mesh| overlay.pieces(mesh).to_vec());
    let solids = Operation::ALL.map(|operation| overlay.solid(operation)).to_vec();
    (overlay.constructions().to_vec(), pieces, solids, overlay.regions())
}

#[test]
fn the_answer_is_the_same_on_any_number_of_threads() {
    let sphere = Shape::sphere(1000.0, 4);
    let moved = sphere.clone().mapped(|[x, y, z]| [x + 300.5, y + 200.25 + z / 64.0, z + 100.125]);
    let pair = Pair::without_truth(sphere, moved);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut session: Box<dyn Predicates> = Box::new(PerMesh.prepare(&pair.scene, Off).unwrap());
            told(&mesh_overlay(&mut session, pair.meshes(), Zeros::Zero).unwrap())
        })
    };
    let one = on(1);
    assert!(one.0.len() > 200 && one.2.iter().all(|solid| solid.triangles.len() > 1_000));
    assert_eq!(one, on(2));
    assert_eq!(one, on(3));
    let mut exact = Exact.prepare(&pair.scene, Off).unwrap();
    assert_eq!(one, told(&mesh_overlay(&mut exact, pair.meshes(), Zeros::Zero).unwrap()), "nothing is tied");
}

#[test]
fn a_zero_is_a_zero_or_positive() {
    // A corner of the second stands on a face of the first, and on nothing else: it counts as behind the face if zeros
    // are positive.
    let stands = Shape::tetrahedron([[3., 2., 8.], [2., 1., 12.], [7., 3., 12.], [4., 6., 12.]]);
    let pair = Pair::new(Shape::cuboid([0.; 3], [8.; 3]), stands);
    let corner = pair.scene.vertices().find(|&v| pair.scene.point3(v) == [3., 2., 8.]).unwrap();
    let mut session = Exact.prepare(&pair.scene, Off).unwrap();
    let overlay = mesh_overlay(&mut session, pair.meshes(), Zeros::Zero).unwrap();
    pair.laws(session.scene(), &overlay);
    let contacts = overlay.contacts();
    assert_eq!((overlay.constructions().len(), contacts.points), (0, vec![corner]), "the corner is on the face");
    assert!(contacts.segments.is_empty() && contacts.faces.is_empty());
    let mut session = Exact.prepare(&pair.scene, Off).unwrap();
    let overlay = mesh_overlay(&mut session, pair.meshes(), Zeros::Positive).unwrap();
    assert_eq!(overlay.constructions().len(), 3, "each edge at the corner passes through");
    pair.laws(session.scene(), &overlay);
    // Moved off the face, the overlay is empty.
    let stands = pair.shapes[1].clone().moved([0., 0., 0.5]);
    let pair = Pair::new(pair.shapes[0].clone(), stands);
    let mut session = Exact.prepare(&pair.scene, Off).unwrap();
    assert!(mesh_overlay(&mut session, pair.meshes(), Zeros::Positive).unwrap().constructions().is_empty());
}

/// A session with arbitrary signs that constructs every point; or a session with right `orient3d` and vertices at their
/// positions.
struct Lies<'s, P> {
    liar: Liar<'s>,
    session: P,
    is_honest_in_space: bool,
}

impl<P: Predicates> Predicates for Lies<'_, P> {
    fn scene(&self) -> &Scene {
        self.session.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.session.construct(definitions)
    }

    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        if self.is_honest_in_space { self.session.orient3d(a, b, c, d) } else { self.liar.orient3d(a, b, c, d) }
    }

    forward_to!(liar: compare, orient2d, incircle, insphere);
}

/// A scene in which anything can be constructed.
struct Takes(Scene);

impl Predicates for Takes {
    fn scene(&self) -> &Scene {
        &self.0
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.0.construct_all(definitions, |_, _| Ok(()))
    }

    answer_by!(zero);
}

impl Takes {
    #[allow(clippy::unused_self)] // as `answer_by` calls it
    fn zero<const N: usize>(&self, _: Question, _: [Vertex; N]) -> Sign {
        Sign::Zero
    }
}

fn random_pair(random: &mut Random) -> Pair {
    let shapes = [
        Shape::cuboid([0.; 3], [8.; 3]),
        Shape::sphere(6.0, 1),
        Shape::lattice([1, 1, 1]).mapped(|p| p.map(|x| 7.0 * x)),
        Shape::cubes(&[[0, 0, 0], [1, 1, 0], [2, 1, 0]]).mapped(|p| p.map(|x| 3.0 * x)),
    ];
    let mut shape = || shapes[usize::try_from(random.below(4)).unwrap()].clone().moved(random.point(5));
    let [first, second] = [shape(), shape()];
    Pair::without_truth(first, second)
}

/// The outcome of an overlay that may be wrong: all its results can be computed.
fn outcome(result: Result<MeshOverlay, Undone>) -> &'static str {
    match result {
        Ok(overlay) => {
            told(&overlay);
            "done"
        }
        Err(Undone::Contact(_)) => "contact",
        Err(Undone::Refused(_)) => "refused",
        Err(Undone::Own { .. }) => "own parts",
        Err(Undone::Broken(broken)) => broken.rule(),
    }
}

#[test]
fn signs_that_mean_nothing_end() {
    let mut outcomes: BTreeMap<&str, usize> = BTreeMap::new();
    let (sos, mut random) = (Sos::default(), Random(5));
    for seed in 0..u64::try_from(predicament_effort::scaled(1_200)).unwrap() {
        let pair = random_pair(&mut random);
        let scene = &pair.scene;
        let liar = |zeros: u64| Liar { scene, seed, zeros };
        let mut overlay = |session: &mut dyn Predicates, zeros: Zeros| {
            *outcomes.entry(outcome(mesh_overlay(session, pair.meshes(), zeros))).or_default() += 1;
        };
        overlay(&mut liar(3 + seed), Zeros::Positive);
        let exact = Exact.prepare(scene, Off).unwrap();
        overlay(&mut Slip { honest: &exact, liar: liar(5), odds: 30 }, Zeros::Positive);
        for zeros in [Zeros::Positive, Zeros::Zero] {
            let takes = Takes(scene.clone());
            overlay(&mut Lies { liar: liar(1 << 40), session: takes, is_honest_in_space: false }, zeros);
            let honest = PerMesh.prepare(scene, Off).unwrap();
            overlay(&mut Lies { liar: liar(3 + seed), session: honest, is_honest_in_space: true }, zeros);
            let honest = Exact.prepare(scene, Off).unwrap();
            overlay(&mut Lies { liar: liar(3), session: honest, is_honest_in_space: false }, zeros);
            let honest = Exact.prepare(scene, Off).unwrap();
            overlay(&mut Lies { liar: liar(3 + seed), session: honest, is_honest_in_space: true }, zeros);
            let honest = sos.prepare(scene, Off).unwrap();
            overlay(&mut Lies { liar: liar(1 << 40), session: honest, is_honest_in_space: true }, zeros);
            overlay(&mut Exact.prepare(scene, Off).unwrap(), zeros);
        }
    }
    assert!(outcomes.len() > 5 && outcomes["done"] > 10, "{outcomes:?}");
    assert!(outcomes.contains_key("vertices that no triangle parts are in one region"), "{outcomes:?}");
    // A session that always returns zero.
    let pair = random_pair(&mut random);
    assert_eq!(outcome(mesh_overlay(&mut Takes(pair.scene.clone()), pair.meshes(), Zeros::Positive)), "done");
}
