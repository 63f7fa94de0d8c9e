//! The parts of two meshes that a step processes.
//!
//! A triangle beyond the other mesh's box is not in the other mesh. So an overlay only needs the part of a mesh that
//! meets the other's box, and the triangles that a ray straight up from there can meet: these decide the location.

use std::sync::Arc;

use predicament_grid::Bounds;
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Scene, SceneError, Vertex};

use super::NoStep;
use crate::algorithm::rounding::{Closed, Rounded};
use predicament_overlay::algorithm::overlay::Operation;

/// The triangles in the columns above and below each other's boxes.
pub(super) struct Columns {
    /// The indices of these triangles, for either mesh.
    pub near: [Vec<u32>; 2],
    /// The indices of the other triangles.
    far: [Vec<u32>; 2],
    /// The vertices of near triangles, ascending.
    vertices: [Vec<u32>; 2],
}

impl Columns {
    pub fn of(operands: [&Closed; 2]) -> Columns {
        let bounds = operands.map(|mesh| Bounds::of(mesh.points.iter().copied()));
        let is_near = |mesh: usize, triangle: [u32; 3]| {
            let over = Bounds::of(triangle.map(|v| operands[mesh].points[v as usize]));
            let other = &bounds[1 - mesh];
            (0..2).all(|axis| over.low[axis] <= other.high[axis] && over.high[axis] >= other.low[axis])
        };
        let [first, second] = [0, 1].map(|mesh: usize| {
            (0..).zip(&operands[mesh].triangles).partition::<Vec<_>, _>(|&(_, &triangle)| is_near(mesh, triangle))
        });
        let places = |of: &[(u32, &[u32; 3])]| of.iter().map(|(place, _)| *place).collect::<Vec<u32>>();
        let vertices = |of: &[(u32, &[u32; 3])]| {
            let mut all: Vec<u32> = of.iter().flat_map(|(_, triangle)| **triangle).collect();
            all.sort_unstable();
            all.dedup();
            all
        };
        Columns {
            near: [places(&first.0), places(&second.0)],
            far: [places(&first.1), places(&second.1)],
            vertices: [vertices(&first.0), vertices(&second.0)],
        }
    }

    /// The points of near triangles; the second mesh is the one that moves.
    pub fn scene(&self, operands: [&Closed; 2]) -> Result<Scene, SceneError> {
        let points = |mesh: usize| self.vertices[mesh].iter().map(move |&v| operands[mesh].points[v as usize]);
        let all: Vec<[f64; 3]> = points(0).chain(points(1)).collect();
        let scene = Scene::from_points3(&all)?;
        Ok(scene.with_second_mesh((self.vertices[0].len()..all.len()).map(Vertex::input)))
    }

    /// The near parts of both meshes, over the points of one scene.
    pub fn meshes(&self, operands: [&Closed; 2]) -> Result<[Arc<MaterialMesh>; 2], NoStep> {
        let counts = self.vertices.each_ref().map(Vec::len);
        let mesh = |mesh: usize| {
            let before = if mesh == 0 { 0 } else { counts[0] };
            let mut places = vec![0; operands[mesh].points.len()];
            self.vertices[mesh].iter().zip(before..).for_each(|(&v, at)| places[v as usize] = at);
            let triangle =
                |&place: &u32| operands[mesh].triangles[place as usize].map(|v| Vertex::input(places[v as usize]));
            let triangles = self.near[mesh].iter().map(triangle).collect();
            let part = MaterialMesh::part_of_closed(counts[0] + counts[1], triangles);
            part.map(Arc::new).map_err(|why| NoStep::Mesh(mesh, why))
        };
        Ok([mesh(0)?, mesh(1)?])
    }

    /// The result of an operation: the kept part of the far triangles, and the result of the near ones (`None` if one
    /// of the meshes has no near part). The second value is, for each point, true if a vertex has moved there.
    pub fn joined(&self, operands: [&Closed; 2], operation: Operation, near: Option<&Rounded>) -> (Closed, Vec<bool>) {
        // Vertices by mesh and index, then new ones.
        let [first, second] = operands.map(|mesh| mesh.points.len());
        let mut of = vec![u32::MAX; first + second + near.map_or(0, |near| near.vertices.len())];
        let mut result = Closed::default();
        let mut moved = Vec::new();
        let mut place = |at: usize, point: [f64; 3], has_moved: bool| {
            if of[at] == u32::MAX {
                of[at] = u32::try_from(result.points.len()).expect("fewer than 2^32 vertices");
                result.points.push(point);
                moved.push(false);
            }
            moved[of[at] as usize] |= has_moved;
            of[at]
        };
        for (mesh, operand) in operands.into_iter().enumerate() {
            // These triangles are beyond the other mesh's box. If there is no near part, the whole mesh is outside the
            // other.
            if !operation.holds([mesh == 0, mesh == 1]) {
                continue;
            }
            let near = if near.is_none() { &self.near[mesh][..] } else { &[] };
            for &triangle in near.iter().chain(&self.far[mesh]) {
                let corners = operand.triangles[triangle as usize];
                let before = mesh * first;
                result.triangles.push(corners.map(|v| place(before + v as usize, operand.points[v as usize], false)));
            }
        }
        if let Some(Rounded { closed, vertices, moved, .. }) = near {
            let counts = self.vertices.each_ref().map(Vec::len);
            let name = |at: usize| match vertices[at].construction() {
                Some(_) => first + second + at,
                None => {
                    let index = vertices[at].index();
                    let of_first = self.vertices[0].get(index).map(|&v| v as usize);
                    of_first.unwrap_or_else(|| first + self.vertices[1][index - counts[0]] as usize)
                }
            };
            for corners in &closed.triangles {
                result
                    .triangles
                    .push(corners.map(|v| place(name(v as usize), closed.points[v as usize], moved[v as usize])));
            }
        }
        (result, moved)
    }
}
