//! Answers that zeros within a band allow, decided by exact determinants.

use crate::algorithm::{Location, Ray};
use predicament_judge::{is_within, sign};
use predicament_laws::published;
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Plane, Predicates, Question, Scene, Sign, Vertex};

use super::ProbedMesh;

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

/// The bands of one scene: the largest determinants for which a session may answer zero.
pub(super) struct Bands<'a> {
    scene: &'a Scene,
    mesh: &'a MaterialMesh,
    /// The bands of `orient2d`, for each of [`PLANES`].
    turns: [f64; 3],
    /// The band of `orient3d`.
    side: f64,
    /// The maximum distance of a registered point from a triangle's box.
    reach: f64,
}

impl<'a> Bands<'a> {
    /// The published bands of a session; zero if it claims no bands.
    pub(super) fn new(session: &'a dyn Predicates, content: &'a ProbedMesh) -> Bands<'a> {
        let upper = |question: Question| published::band(session, question).map_or(0.0, |band| band.upper);
        let turns = PLANES.map(|plane| upper(Question::Orient2d(plane)));
        let (side, reach) = (upper(Question::Orient3d), session.reach());
        Bands { scene: session.scene(), mesh: &content.mesh, turns, side, reach }
    }

    /// True if zeros within the bands explain that a probe is on a triangle or undecided.
    pub(super) fn allow(&self, q: Vertex, answer: Location) -> bool {
        match answer {
            Location::On(triangle) => self.is_on(q, self.mesh.triangles()[triangle as usize]),
            Location::Undecided => Ray::ALL.iter().all(|&ray| self.leaves_open(q, ray)),
            Location::In(_) | Location::Contradiction => false,
        }
    }

    /// True if the probe is within the bands of a triangle's plane and of its projections, and within the reach of its
    /// box.
    fn is_on(&self, q: Vertex, corners: [Vertex; 3]) -> bool {
        let near = (0..3).all(|axis| {
            let [low, high] = self.range(corners, axis);
            let x = self.scene.point3(q)[axis];
            // Outward by more than the rounding error of the sums.
            (low - self.reach).next_down() <= x && x <= (high + self.reach).next_up()
        });
        near && self.is_flat(q, corners) && PLANES.into_iter().all(|plane| !self.is_outside(q, corners, plane))
    }

    /// True if the bands leave open, for some triangle, if the ray passes it.
    fn leaves_open(&self, q: Vertex, ray: Ray) -> bool {
        let (plane, p) = ([Plane::Yz, Plane::Zx, Plane::Xy][ray.axis], self.scene.point3(q));
        self.mesh.triangles().iter().any(|&corners| {
            let may_meet = (0..3).all(|axis| {
                let [low, high] = self.range(corners, axis);
                match (axis == ray.axis, ray.is_up) {
                    (true, true) => p[axis] <= (high + self.reach).next_up(),
                    (true, false) => (low - self.reach).next_down() <= p[axis],
                    (false, _) => (low - self.reach).next_down() <= p[axis] && p[axis] <= (high + self.reach).next_up(),
                }
            });
            may_meet
                && !self.is_outside(q, corners, plane)
                && (self.is_flat(q, corners) || edges(corners).into_iter().any(|edge| self.is_in_line(q, edge, plane)))
        })
    }

    fn range(&self, corners: [Vertex; 3], axis: usize) -> [f64; 2] {
        let along = corners.map(|v| self.scene.point3(v)[axis]);
        [along.into_iter().fold(f64::INFINITY, f64::min), along.into_iter().fold(f64::NEG_INFINITY, f64::max)]
    }

    fn is_flat(&self, q: Vertex, [a, b, c]: [Vertex; 3]) -> bool {
        is_within(self.scene, Question::Orient3d, &[a, b, c, q], self.side)
    }

    fn is_in_line(&self, q: Vertex, [u, v]: [Vertex; 2], plane: Plane) -> bool {
        is_within(self.scene, Question::Orient2d(plane), &[u, v, q], self.turns[plane as usize])
    }

    /// True if the probe is beyond the band of one edge of the projected triangle, and on the other side of another
    /// edge's band.
    fn is_outside(&self, q: Vertex, corners: [Vertex; 3], plane: Plane) -> bool {
        let turn = |[u, v]: [Vertex; 2]| match self.is_in_line(q, [u, v], plane) {
            true => Sign::Zero,
            false => sign(self.scene, Question::Orient2d(plane), &[u, v, q]),
        };
        let turns = edges(corners).map(turn);
        turns.contains(&Sign::Positive) && turns.contains(&Sign::Negative)
    }
}

fn edges([a, b, c]: [Vertex; 3]) -> [[Vertex; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}
