//! Sequences of operations encoded as numbers. The fuzz target for meshes uses this file too.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{Collapsed, Face, HalfEdge, MeshVertex, OperationError, Side};
use predicament_predicates::Vertex;

/// A completed operation, with the data for its inverse.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Done {
    SplitEdge(MeshVertex),
    JoinEdges(HalfEdge, Vertex),
    SplitFace(HalfEdge),
    CutEar(HalfEdge),
    JoinFaces([HalfEdge; 2]),
    InsertAuxiliaryEdge(HalfEdge),
    RemoveAuxiliaryEdge(HalfEdge, HalfEdge),
    Cover(Face),
    Open(HalfEdge),
    Flip(HalfEdge),
    CutAlong(usize),
    RemoveFaces,
    Unhook(usize),
    DivideAtEdge,
    Collapse(Collapsed, Vertex, i64),
    SplitVertex(HalfEdge, i64),
}

/// The number of kinds of operations.
pub const KINDS: u32 = 16;

impl Done {
    /// The change of the numbers of vertices, edges, faces and boundary loops.
    ///
    /// `None` if faces are removed or separated, as the change then depends on what they share.
    pub fn change(&self) -> Option<[i64; 4]> {
        match self {
            Done::SplitEdge(_) => Some([1, 1, 0, 0]),
            Done::JoinEdges(..) => Some([-1, -1, 0, 0]),
            Done::SplitFace(_) | Done::CutEar(_) => Some([0, 1, 1, 0]),
            Done::JoinFaces(_) => Some([0, -1, -1, 0]),
            Done::InsertAuxiliaryEdge(_) => Some([0, 1, 0, -1]),
            Done::RemoveAuxiliaryEdge(..) => Some([0, -1, 0, 1]),
            Done::Cover(_) => Some([0, 0, 1, -1]),
            Done::Open(_) => Some([0, 0, -1, 1]),
            Done::Flip(_) => Some([0; 4]),
            Done::Collapse(.., triangles) => Some([-1, -1 - triangles, -triangles, 0]),
            Done::SplitVertex(_, triangles) => Some([1, 1 + triangles, *triangles, 0]),
            Done::CutAlong(_) | Done::RemoveFaces | Done::Unhook(_) | Done::DivideAtEdge => None,
        }
    }

    /// Undoes the operation; returns false if it has no inverse.
    pub fn undo(self, mesh: &mut HalfEdgeMesh) -> Result<bool, OperationError> {
        match self {
            Done::SplitEdge(v) => drop(mesh.join_edges(v)?),
            Done::JoinEdges(h, scene_vertex) => drop(mesh.split_edge(h, scene_vertex)?),
            Done::SplitFace(h) | Done::CutEar(h) => drop(mesh.join_faces(h)?),
            Done::JoinFaces([first, second]) => drop(mesh.split_face(first, second)?),
            Done::InsertAuxiliaryEdge(h) => drop(mesh.remove_auxiliary_edge(h)?),
            Done::RemoveAuxiliaryEdge(first, second) => drop(mesh.insert_auxiliary_edge(first, second)?),
            Done::Cover(f) => drop(mesh.open_face(f)?),
            Done::Open(h) => drop(mesh.cover_boundary_loop(h)?),
            Done::Flip(h) => mesh.flip_edge(h)?,
            Done::Collapse(collapsed, scene_vertex, _) => drop(mesh.split_vertex(collapsed.sides, scene_vertex)?),
            Done::SplitVertex(h, _) => drop(mesh.collapse_edge(h)?),
            Done::CutAlong(_) | Done::RemoveFaces | Done::Unhook(_) | Done::DivideAtEdge => return Ok(false),
        }
        Ok(true)
    }
}

/// The number of triangles that a collapse closes or a split opens.
fn triangles(sides: [Side; 2]) -> i64 {
    sides.iter().map(|side| i64::from(matches!(side, Side::Edge(_)))).sum()
}

/// A mesh, the faces moved out of it, and the number of vertices ever made.
pub struct Sequence {
    pub mesh: HalfEdgeMesh,
    pub unhooked: HalfEdgeMesh,
    pub made: usize,
}

impl Sequence {
    pub fn new(mesh: HalfEdgeMesh) -> Sequence {
        let made = mesh.vertices().map(|v| mesh.scene_vertex(v).index() + 1).max().unwrap_or(0);
        Sequence { mesh, unhooked: HalfEdgeMesh::default(), made }
    }

    /// Performs one operation of this kind; the numbers choose its arguments, which may be invalid handles.
    pub fn step(&mut self, kind: u32, numbers: [u32; 2]) -> Result<Done, OperationError> {
        let half_edges: Vec<HalfEdge> = self.mesh.half_edges().collect();
        let faces: Vec<Face> = self.mesh.faces().collect();
        let vertices: Vec<MeshVertex> = self.mesh.vertices().collect();
        let no_half_edge = OperationError::NoSuchHalfEdge;
        let Some(&any) = half_edges.first() else { return Err(OperationError::Full) };
        let pick = |number: u32| half_edges[number as usize % half_edges.len()];
        let [a, b] = numbers.map(pick);
        // Often two half-edges of one loop; else any two.
        let mate = self.mesh.loop_of(a).nth(numbers[1] as usize % 7).unwrap_or(b);
        let mesh = &mut self.mesh;
        let before = |h: HalfEdge, mesh: &HalfEdgeMesh| mesh.previous(h).ok_or(no_half_edge(h));
        Ok(match kind % KINDS {
            0 => {
                let vertex = Vertex::input(self.made);
                let done = Done::SplitEdge(mesh.split_edge(a, vertex)?);
                self.made += 1;
                done
            }
            1 => {
                let v = vertices[numbers[0] as usize % vertices.len()];
                let scene_vertex = mesh.scene_vertex(v);
                Done::JoinEdges(mesh.join_edges(v)?, scene_vertex)
            }
            2 => Done::SplitFace(mesh.split_face(a, mate)?),
            3 => Done::CutEar(mesh.cut_ear(a)?),
            4 => {
                let ends = [before(a, mesh)?, before(mesh.opposite(a), mesh)?];
                mesh.join_faces(a)?;
                Done::JoinFaces(ends)
            }
            5 => {
                let from_hole = mesh.is_boundary(a);
                let h = mesh.insert_auxiliary_edge(a, b)?;
                // The inverse leaves the face at the start.
                Done::InsertAuxiliaryEdge(if from_hole { mesh.opposite(h) } else { h })
            }
            6 => {
                let from = before(a, mesh)?;
                let to = mesh.remove_auxiliary_edge(a)?;
                Done::RemoveAuxiliaryEdge(from, to)
            }
            7 => Done::Cover(mesh.cover_boundary_loop(a)?),
            8 => match faces.get(numbers[0] as usize % faces.len().max(1)) {
                Some(&f) => Done::Open(mesh.open_face(f)?),
                None => return Err(no_half_edge(any)),
            },
            9 => {
                mesh.flip_edge(a)?;
                Done::Flip(a)
            }
            10 => {
                // Around a face, or along a part of its loop.
                let along: Vec<HalfEdge> = mesh.loop_of(a).take(1 + numbers[1] as usize % 5).collect();
                let before = mesh.clone();
                mesh.cut_along(&along)?;
                self.renew(before).ok_or(no_half_edge(a))?;
                Done::CutAlong(along.len())
            }
            13 => {
                let touched = touched_edges(mesh, &half_edges);
                let &[first, second, edge] =
                    touched.get(numbers[0] as usize % touched.len().max(1)).ok_or(OperationError::EdgeExists(any))?;
                let before = mesh.clone();
                mesh.divide_at_edge(first, second, edge)?;
                self.renew(before).ok_or(no_half_edge(edge))?;
                Done::DivideAtEdge
            }
            14 => {
                let scene_vertex = mesh.scene_vertex(mesh.start(a));
                let collapsed = mesh.collapse_edge(a)?;
                Done::Collapse(collapsed, scene_vertex, triangles(collapsed.sides))
            }
            15 => {
                let ring: Vec<HalfEdge> = mesh.ring(mesh.end(a)).collect();
                let side = |number: u32| {
                    let h = ring[(number / 2) as usize % ring.len()];
                    if number.is_multiple_of(2) { Side::Corner(h) } else { Side::Edge(h) }
                };
                let sides = [side(numbers[1]), side((numbers[1] / 16).wrapping_add(numbers[0]))];
                let done = Done::SplitVertex(mesh.split_vertex(sides, Vertex::input(self.made))?, triangles(sides));
                self.made += 1;
                done
            }
            kind => {
                let chosen: Vec<Face> = numbers
                    .into_iter()
                    .filter_map(|number| faces.get(number as usize % faces.len().max(1)).copied())
                    .collect();
                if kind == 11 {
                    mesh.remove_faces(&chosen)?;
                    Done::RemoveFaces
                } else {
                    Done::Unhook(mesh.unhook_faces(&chosen, &mut self.unhooked)?.len())
                }
            }
        })
    }

    /// Rebuilds the mesh from its faces, with a separate scene vertex for each vertex: divided vertices share a scene
    /// vertex, and a list of loops could not distinguish them. If a face passes a vertex twice, or an edge has no face,
    /// there is no such mesh: the mesh is then restored to `before`.
    ///
    /// # Panics
    /// If the mesh is not valid.
    fn renew(&mut self, before: HalfEdgeMesh) -> Option<()> {
        self.mesh.validate().unwrap_or_else(|why| panic!("{why}"));
        let (vertices, faces) = self.mesh.to_indexed();
        let names = (0..vertices.len()).map(|at| Vertex::input(self.made + at)).collect();
        let edges = self.mesh.edge_count();
        let Some(again) = HalfEdgeMesh::new(names, &faces).ok().filter(|again| again.edge_count() == edges) else {
            self.mesh = before;
            return None;
        };
        self.made += vertices.len();
        self.mesh = again;
        Some(())
    }
}

/// Edges between two faces whose ends another face touches: the half-edges of that face to the ends, and the edge.
fn touched_edges(mesh: &HalfEdgeMesh, half_edges: &[HalfEdge]) -> Vec<[HalfEdge; 3]> {
    let ending = |v: MeshVertex| half_edges.iter().copied().filter(move |&h| mesh.end(h) == v);
    let mut found = Vec::new();
    for &edge in half_edges {
        let beside = [edge, mesh.opposite(edge)].map(|h| mesh.face(h));
        for first in ending(mesh.start(edge)).filter(|&first| !beside.contains(&mesh.face(first))) {
            let of_face = ending(mesh.end(edge)).filter(|&second| mesh.face(second) == mesh.face(first));
            found.extend(of_face.map(|second| [first, second, edge]));
        }
    }
    found
}
