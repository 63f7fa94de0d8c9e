//! Half-edge meshes: any faces make a valid mesh or are refused, and any operations keep it valid or are refused.
//!
//! The first bytes encode faces over a few vertices; then three bytes encode an operation and its arguments.

use predicament_formats::{Decimals, MeshFormat, mesh, write_mesh};
use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::IndexedFaces;
use predicament_predicates::Vertex;

#[path = "../../crates/instrument/mesh/tests/it/half_edge/sequence.rs"]
mod sequence;

use sequence::{KINDS, Sequence};

const VERTICES: u8 = 12;

/// Reads faces from bytes: one byte for the number of corners, two to five, and one byte for each corner. 255 ends the
/// list.
fn faces(bytes: &mut impl Iterator<Item = u8>) -> IndexedFaces {
    let mut faces = IndexedFaces::default();
    while let Some(head) = bytes.next().filter(|&head| head != 255) {
        let corners: Vec<u32> = bytes.take(usize::from(2 + head % 4)).map(|corner| u32::from(corner % 13)).collect();
        faces.push(corners);
    }
    faces
}

/// Builds a mesh from bytes and operates on it; if the faces are refused, on a fan of triangles.
///
/// # Panics
/// If an invariant is broken, an inverse fails, a written mesh is not read back, or an error is not a single line.
pub fn check(bytes: &[u8]) {
    let mut bytes = bytes.iter().copied();
    let vertices = || (0..usize::from(VERTICES)).map(Vertex::input).collect();
    let made = HalfEdgeMesh::new(vertices(), &faces(&mut bytes)).unwrap_or_else(|why| {
        assert!(!why.to_string().contains('\n'));
        let fan = (2..u32::from(VERTICES)).map(|at| [0, at - 1, at]).collect();
        HalfEdgeMesh::new(vertices(), &fan).expect("a fan")
    });
    made.validate().unwrap_or_else(|why| panic!("{why}"));
    let mut sequence = Sequence::new(made);
    while let (Some(kind), Some(a), Some(b)) = (bytes.next(), bytes.next(), bytes.next()) {
        let before = sequence.mesh.clone();
        let step = sequence.step(u32::from(kind) % KINDS, [a, b].map(u32::from));
        sequence.mesh.validate().unwrap_or_else(|why| panic!("{step:?}: {why}"));
        sequence.unhooked.validate().unwrap_or_else(|why| panic!("{step:?}: {why}"));
        let Ok(done) = step else { continue };
        let [was, is] = [&before, &sequence.mesh].map(counts);
        if let Some(change) = done.change() {
            assert_eq!([0, 1, 2].map(|of| is[of] - was[of]), change[..3], "{done:?}");
        }
        let mut back = sequence.mesh.clone();
        if done.undo(&mut back).unwrap_or_else(|why| panic!("{done:?} is not undone: {why}")) {
            back.validate().unwrap_or_else(|why| panic!("{done:?} undone: {why}"));
            assert_eq!(counts(&back), counts(&before), "{done:?}");
        }
        if sequence.mesh.edge_count() > 200 {
            break;
        }
    }
    written(&sequence.mesh);
}

/// The numbers of vertices, edges and faces.
fn counts(mesh: &HalfEdgeMesh) -> [i64; 3] {
    let counts = [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()];
    counts.map(|count| i64::try_from(count).expect("a few"))
}

/// Writes the faces, with distinct points, in every format that supports them, and reads them back.
fn written(made: &HalfEdgeMesh) {
    let (vertices, faces) = made.to_indexed();
    let points: Vec<[f64; 3]> = (0_u16..).take(vertices.len()).map(|at| [f64::from(at) / 8.0, -0.0, 1.0]).collect();
    for format in MeshFormat::ALL {
        let mut bytes = Vec::new();
        if let Err(why) = write_mesh(&mut bytes, format, &points, &faces) {
            assert!(bytes.is_empty() && !why.to_string().contains('\n'), "{why}");
            continue;
        }
        let read = mesh::read(&format!("a{}", format.extension()), bytes, &Decimals::new(false));
        let read = read.unwrap_or_else(|why| panic!("{format:?}: {why}"));
        assert_eq!((read.points.len(), read.faces.len()), (points.len(), faces.len()), "{format:?}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::bytes;

    #[test]
    fn random_bytes_keep_every_invariant() {
        for run in 0..2000 {
            check(&bytes(run));
            // A face of two corners is refused: all operations are on the fan.
            check(&[&[0, 1, 1, 255], bytes(run).as_slice()].concat());
            // One triangle.
            check(&[&[1, 0, 1, 2, 255], bytes(run).as_slice()].concat());
        }
    }

    #[test]
    fn faces_are_made_and_all_kinds_of_operations_done() {
        let mut done = [0; KINDS as usize];
        let mut refused = 0;
        for run in 0..500 {
            let bytes = bytes(run);
            let fan = (2..u32::from(VERTICES)).map(|at| [0, at - 1, at]).collect();
            let made = HalfEdgeMesh::new((0..usize::from(VERTICES)).map(Vertex::input).collect(), &fan);
            let mut sequence = Sequence::new(made.expect("a fan"));
            for step in bytes.chunks_exact(3) {
                let kind = u32::from(step[0]) % KINDS;
                match sequence.step(kind, [step[1], step[2]].map(u32::from)) {
                    Ok(_) => done[kind as usize] += 1,
                    Err(_) => refused += 1,
                }
            }
        }
        assert!(done.iter().all(|&times| times > 20) && refused > 100, "{done:?}, {refused} refused");
        let mut list = [1, 0, 1, 2, 1, 2, 1, 3, 255, 9].into_iter();
        let faces = faces(&mut list);
        assert_eq!(faces.iter().map(<[u32]>::to_vec).collect::<Vec<_>>(), [vec![0, 1, 2], vec![2, 1, 3]]);
        assert_eq!(list.next(), Some(9));
    }
}
