//! Differences that zeros within a band allow, decided by exact determinants.

use predicament_judge::is_within;
use predicament_laws::published;
use predicament_predicates::{Axis, Plane, Predicates, Question, Scene, Vertex};

use super::RayScene;
use crate::answer::{Feature, edges};

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];
const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// The bands of one scene: the largest determinants for which a session may answer zero.
pub(super) struct Bands<'a> {
    scene: &'a Scene,
    content: &'a RayScene,
    orders: [f64; 3],
    turns: [f64; 3],
    side: f64,
}

impl<'a> Bands<'a> {
    /// The published bands of a session; zero if it claims no bands.
    pub(super) fn new(session: &'a dyn Predicates, content: &'a RayScene) -> Bands<'a> {
        let upper = |question: Question| published::band(session, question).map_or(0.0, |band| band.upper);
        Bands {
            scene: session.scene(),
            content,
            orders: AXES.map(|axis| upper(Question::Compare(axis))),
            turns: PLANES.map(|plane| upper(Question::Orient2d(plane))),
            side: upper(Question::Orient3d),
        }
    }

    /// True if a sign that decides whether the query hits this feature, or where, is zero within the bands.
    pub(super) fn allow(&self, query: [Vertex; 2], feature: Feature) -> bool {
        let around = |corners: &&[Vertex; 3]| match feature {
            Feature::Vertex(v) => corners.contains(&v),
            Feature::Edge(ends) => ends.iter().all(|v| corners.contains(v)),
            Feature::Face(face) => self.content.triangles[face as usize] == **corners,
        };
        self.content.triangles.iter().filter(around).any(|corners| self.is_near(query, *corners))
    }

    fn is_near(&self, [p, q]: [Vertex; 2], [a, b, c]: [Vertex; 3]) -> bool {
        let within = |question: Question, args: &[Vertex], limit: f64| {
            limit > 0.0 && is_within(self.scene, question, args, limit)
        };
        let side = |args: [Vertex; 4]| within(Question::Orient3d, &args, self.side);
        edges([a, b, c]).into_iter().any(|[u, v]| side([p, q, u, v]))
            || [p, q].into_iter().any(|end| side([a, b, c, end]))
            || PLANES.into_iter().zip(self.turns).any(|(plane, limit)| {
                let turn = |args: [Vertex; 3]| within(Question::Orient2d(plane), &args, limit);
                [a, b, c].into_iter().any(|v| turn([p, q, v]))
                    || edges([a, b, c]).into_iter().any(|[u, v]| turn([u, v, p]) || turn([u, v, q]))
            })
            || AXES.into_iter().zip(self.orders).any(|(axis, limit)| {
                let close = |u: Vertex, v: Vertex| within(Question::Compare(axis), &[u, v], limit);
                close(p, q) || [a, b, c].into_iter().any(|v| close(v, p) || close(v, q))
            })
    }

    /// True if a sign that may order these two features is zero within the bands.
    pub(super) fn leave_open(&self, one: Feature, other: Feature) -> bool {
        let corners = |feature: Feature| match feature {
            Feature::Vertex(v) => vec![v],
            Feature::Edge(ends) => ends.to_vec(),
            Feature::Face(face) => self.content.triangles[face as usize].to_vec(),
        };
        let (of_one, of_other) = (corners(one), corners(other));
        let beside = |plane: &[Vertex], others: &[Vertex]| match *plane {
            [a, b, c] => others
                .iter()
                .any(|&v| self.side > 0.0 && is_within(self.scene, Question::Orient3d, &[a, b, c, v], self.side)),
            _ => true,
        };
        beside(&of_one, &of_other) || beside(&of_other, &of_one)
    }
}
