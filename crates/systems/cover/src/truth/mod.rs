//! The truth about covers: exact areas, exact crossings, and a search of all triangulations of a loop.
//!
//! The computation shares nothing with the algorithm. Areas are square roots of integers. Triangles cross if their
//! points have a circuit across them. The search visits triangulations from an edge inwards and leaves those that
//! cannot be small enough.

mod area;
mod circuit;
mod hunt;

use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};

use predicament_judge::Judged;
use predicament_predicates::{Axis, Plane, Predicates, Question, Scene, Sign, Vertex};
use predicament_tasks::{Stop, Watch};

use crate::answer::{edges, undirected};
use crate::task::content::HoleScene;

pub use area::Areas;
pub use circuit::{is_flat, meet};
pub use hunt::{Found, hunt};

/// A triangle by the places of its corners on the loop, ascending.
pub type Corners = [usize; 3];

/// The truth about a scene: the areas of each loop, and the mesh.
pub struct Truth {
    /// The areas of each loop; `None` if the loop passes a vertex twice.
    pub areas: Vec<Option<Areas>>,
    /// The first triangle of the mesh without area, if there is one: such a mesh is not judged.
    pub flat: Option<usize>,
}

impl Truth {
    /// Computes all areas.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    pub fn new(scene: &Scene, content: &HoleScene, watch: &Watch) -> Result<Truth, Stop> {
        let session = Judged::exact(scene);
        let signs = Signs::new(&session);
        let flat = content.triangles.iter().position(|corners| is_flat(&signs, *corners));
        let areas = |around: &Vec<Vertex>| {
            watch.done(1)?;
            let is_simple = around.iter().collect::<BTreeSet<_>>().len() == around.len();
            Ok(is_simple.then(|| Areas::new(scene, around)))
        };
        Ok(Truth { areas: content.loops.iter().map(areas).collect::<Result<_, _>>()?, flat })
    }
}

/// The triangles that a cover must not cross: those of the mesh, and of covers of earlier loops.
#[derive(Clone, Default, Debug)]
pub struct Around {
    triangles: Vec<[Vertex; 3]>,
    edges: BTreeSet<[Vertex; 2]>,
}

impl Around {
    /// Adds triangles.
    pub fn extend(&mut self, triangles: &[[Vertex; 3]]) {
        self.triangles.extend(triangles);
        self.edges.extend(triangles.iter().flat_map(|corners| edges(corners)).map(undirected));
    }

    /// True if a triangle has this edge.
    #[must_use]
    pub fn has_edge(&self, ends: [Vertex; 2]) -> bool {
        self.edges.contains(&undirected(ends))
    }

    /// The first triangle that has more in common with this one than vertices and an edge of both.
    #[must_use]
    pub fn met(&self, signs: &Signs<'_>, corners: [Vertex; 3]) -> Option<[Vertex; 3]> {
        self.triangles.iter().copied().find(|&other| meet(signs, corners, other))
    }
}

/// The judge's signs, each computed once.
pub struct Signs<'a> {
    session: &'a Judged<'a>,
    known: RefCell<HashMap<(Question, [usize; 4]), Sign>>,
}

impl<'a> Signs<'a> {
    /// The signs of a session of the judge.
    #[must_use]
    pub fn new(session: &'a Judged<'a>) -> Signs<'a> {
        Signs { session, known: RefCell::default() }
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        self.session.scene()
    }

    fn orient3d(&self, args: [Vertex; 4]) -> Sign {
        self.sign(Question::Orient3d, args, |[a, b, c, d]| self.session.orient3d(a, b, c, d))
    }

    fn orient2d(&self, plane: Plane, args: [Vertex; 3]) -> Sign {
        self.sign(Question::Orient2d(plane), args, |[a, b, c]| self.session.orient2d(plane, a, b, c))
    }

    fn compare(&self, axis: Axis, args: [Vertex; 2]) -> Sign {
        self.sign(Question::Compare(axis), args, |[a, b]| self.session.compare(axis, a, b))
    }

    /// The sign of vertices in any order, from the sign of the vertices in ascending order: each exchange negates it.
    fn sign<const N: usize>(
        &self,
        question: Question,
        mut args: [Vertex; N],
        ask: impl FnOnce([Vertex; N]) -> Sign,
    ) -> Sign {
        let mut is_odd = false;
        for end in (1..N).rev() {
            for at in 0..end {
                if args[at + 1] < args[at] {
                    args.swap(at, at + 1);
                    is_odd = !is_odd;
                }
            }
        }
        let mut key = [usize::MAX; 4];
        key.iter_mut().zip(args).for_each(|(place, v)| *place = v.index());
        let known = self.known.borrow().get(&(question, key)).copied();
        let sign = known.unwrap_or_else(|| {
            let sign = ask(args);
            self.known.borrow_mut().insert((question, key), sign);
            sign
        });
        if is_odd { -sign } else { sign }
    }
}
