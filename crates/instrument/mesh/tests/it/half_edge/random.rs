//! Long random sequences of operations: all invariants hold, counts change as each operation specifies, and inverses
//! restore the mesh.

use predicament_mesh::HalfEdgeMesh;

use super::loops::Loops;
use super::sequence::{Done, KINDS, Sequence};
use super::shapes::{cube, grid, octahedron, polygon_and_fan, two_squares};

/// A linear congruential generator (Knuth's MMIX constants).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        u32::try_from(self.0 >> 32).unwrap()
    }
}

/// The mesh that a sequence starts with.
pub fn start(at: u32) -> HalfEdgeMesh {
    match at % 6 {
        0 => octahedron(),
        1 => cube(),
        2 => grid(4, 3, false),
        3 => grid(4, 5, true),
        4 => polygon_and_fan(9),
        _ => two_squares(),
    }
}

#[test]
fn a_hundred_thousand_operations_keep_every_invariant_and_inverses_restore_the_mesh() {
    let operations = predicament_effort::some_or_all(3_000, 100_000);
    let mut random = Random(7);
    let mut done = [0_usize; KINDS as usize];
    let mut undone = 0;
    let mut at = 0;
    'meshes: for round in 0.. {
        let mut sequence = Sequence::new(start(round));
        let mut loops = Loops::of(&sequence.mesh);
        let mut refused = 0;
        while sequence.mesh.edge_count() < 150 && refused < 300 {
            if at == operations {
                break 'meshes;
            }
            // Kinds that are often refused are tried more often. Removals are rarer, or nothing would be left.
            let kind = match random.next() % (2 * KINDS) {
                kind if kind < KINDS => kind,
                kind => [9, 10, 13][kind as usize % 3],
            };
            if (11..13).contains(&kind) && !random.next().is_multiple_of(4) {
                continue;
            }
            let numbers = [random.next(), random.next()];
            let unhooked = Loops::of(&sequence.unhooked).faces.len();
            let Ok(what) = sequence.step(kind, numbers) else {
                refused += 1;
                assert_eq!(Loops::of(&sequence.mesh), loops, "{kind} was refused and left a trace");
                continue;
            };
            (at, refused) = (at + 1, 0);
            done[kind as usize] += 1;
            sequence.mesh.validate().unwrap_or_else(|why| panic!("{what:?}: {why}"));
            let now = Loops::of(&sequence.mesh);
            now.check().unwrap_or_else(|why| panic!("{what:?}: {why}"));
            let changed = std::array::from_fn(|i| now.counts()[i] - loops.counts()[i]);
            if let Some(expected) = what.change() {
                assert_eq!(changed, expected, "{what:?}: vertices, edges, faces, boundary loops");
            }
            if let Done::Unhook(faces) = what {
                sequence.unhooked.validate().unwrap_or_else(|why| panic!("unhooked: {why}"));
                assert_eq!(-changed[2], i64::try_from(faces).unwrap());
                assert_eq!(sequence.unhooked.face_count(), unhooked + faces);
                if faces == 2 {
                    sequence.unhooked = HalfEdgeMesh::default();
                }
            }
            let mut back = sequence.mesh.clone();
            if what.undo(&mut back).unwrap_or_else(|why| panic!("{what:?} is not undone: {why}")) {
                assert_eq!(Loops::of(&back), loops, "{what:?} is not restored");
                back.validate().unwrap_or_else(|why| panic!("{what:?} undone: {why}"));
                undone += 1;
            }
            loops = now;
        }
    }
    assert!(done.iter().all(|&times| times > operations / 2000), "{done:?}");
    assert!(undone > operations / 2, "{undone}");
}
