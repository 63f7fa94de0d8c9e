//! Faults of algorithms of space.

use super::Seen::{Run, Test};
use super::{Planted, change};

pub(super) const FAULTS: &[Planted] = &[
    Planted {
        name: "hull-lost-conflict",
        what: "a vertex outside of a replaced face is held against one of the new faces only",
        changes: &[change(
            "hull",
            "algorithm/surface.rs",
            "        for &at in made.iter() {",
            "        let tried = if self.step > 1 { 1 } else { made.len() };\n        for &at in &made[..tried] {",
        )],
        seen: Run("hulls", "exact", &[["topology", "extreme vertices"], ["topology", "inside"]]),
    },
    Planted {
        name: "hull-coplanar-left",
        what: "faces of the hull in one plane are not merged",
        changes: &[change(
            "hull",
            "algorithm/faces.rs",
            "                    is_flat = true;",
            "                    is_flat = false;",
        )],
        seen: Run("hulls", "exact", &[["topology", "coplanar faces"]]),
    },
    Planted {
        name: "hull-one-sided-wrap",
        what: "a face that joins two hulls is turned against the vertices of the first one only",
        changes: &[change(
            "hull",
            "algorithm/stitch.rs",
            "self.neighbours(u).chain(self.neighbours(v))",
            "self.neighbours(u)",
        )],
        seen: Run("hulls", "exact", &[["topology", "no vertex is outside of a stitching face"]]),
    },
    // The tool measures unions by comparisons of coordinates; this is the way by integers.
    Planted {
        name: "dropped-border-cube",
        what: "a cube whose upper face is on the border of a cell is not looked at there",
        changes: &[
            change(
                "cube-union",
                "algorithm/mod.rs",
                "                if !is_tight {",
                "                if !is_tight || !cubes.is_empty() {",
            ),
            change(
                "cube-union",
                "algorithm/cell.rs",
                "lower[axis] < cell[axis][1] && lower[axis] + edge >= cell[axis][0])",
                "lower[axis] < cell[axis][1] && lower[axis] + edge > cell[axis][0])",
            ),
        ],
        seen: Test("judge", "cubes::the_algorithm_measures_the_same"),
    },
    // The truth about contacts is found twice, the second time by this algorithm: a run would end with that.
    Planted {
        name: "lost-sub-pair",
        what: "the last pair that a level below full dimension registers is lost",
        changes: &[change(
            "contacts",
            "algorithm/pairs/mod.rs",
            "        let is_last = level + 1 == levels.len();\n",
            "        let is_last = level + 1 == levels.len();
        if !is_last && all.registered.len() > start {
            all.registered.pop();
        }\n",
        )],
        seen: Test("judge", "the_algorithm_with_exact_signs_registers_the_same"),
    },
    Planted {
        name: "skipped-vertices",
        what: "the hierarchy begins with edges and vertices, no two vertices are registered",
        changes: &[change(
            "contacts",
            "algorithm/pairs/mod.rs",
            "        for &ranks in *pairs {",
            "        for &ranks in pairs.iter().filter(|ranks| **ranks != [0, 0]) {",
        )],
        seen: Test("judge", "the_algorithm_with_exact_signs_registers_the_same"),
    },
    Planted {
        name: "forgotten-sub-pairs",
        what: "pairs of which a sub-pair is registered are asked about all the same",
        changes: &[change("contacts", "algorithm/pairs/mod.rs", " && !is_last {", " && level > levels.len() {")],
        seen: Run("contacts", "tolerance", &[["inconsistent", "unasked"]]),
    },
    Planted {
        name: "duplicated-split-points",
        what: "each of the two faces at an edge that crosses the plane has a split point of its own",
        changes: &[
            change(
                "slice",
                "algorithm/cutter.rs",
                "        let vertices = self.session.construct(&definitions)?;\n",
                "        let mut vertices = Vec::with_capacity(definitions.len());
        for (&h, &definition) in edges.iter().zip(&definitions) {
            vertices.extend(self.session.construct(&[definition])?);
            let faces = [h, self.mesh.opposite(h)].map(|h| self.mesh.face(h).map(|f| self.support(f)));
            if let ([Some(first), Some(second)], Construction::Lpi { .. }) = (faces, definition) {
                match self.session.construct(&[Construction::Tpi([first, second, plane])]) {
                    Ok(_) | Err(predicament_predicates::Refused::Definition { .. }) => {}
                    Err(why) => return Err(why.into()),
                }
            }
        }\n",
            ),
            change(
                "slice",
                "algorithm/output.rs",
                "    fn vertex(&self, h: HalfEdge) -> Vertex {
        self.mesh.scene_vertex(self.mesh.end(h))",
                "    fn vertex(&self, h: HalfEdge) -> Vertex {
        use predicament_predicates::Construction;
        let (v, scene) = (self.mesh.scene_vertex(self.mesh.end(h)), self.session.scene());
        let is_odd = |f: Face| self.cap_of(f).is_none() && self.mesh.face_user_data(f) % 2 == 1;
        // The copy was constructed right after it.
        let next = v.construction().map(|index| index + 1);
        let is_copy = |next: &usize| matches!(scene.constructions().get(*next), Some(Construction::Tpi(_)));
        let copy = next.filter(is_copy).filter(|_| self.mesh.face(h).is_some_and(is_odd));
        copy.map_or(v, Vertex::constructed)",
            ),
        ],
        seen: Run("slices", "exact", &[["topology", "part not closed"]]),
    },
    Planted {
        name: "one-loop-capped",
        what: "of a cap with several loops only the first is covered",
        changes: &[change(
            "slice",
            "algorithm/output.rs",
            "        for ((cap, part), loops) in caps {\n",
            "        for ((cap, part), mut loops) in caps {\n            loops.truncate(1);\n",
        )],
        seen: Run("slices", "exact", &[["topology", "part not closed"], ["topology", "volume"]]),
    },
    Planted {
        name: "reversed-caps",
        what: "caps face into the part",
        changes: &[change(
            "slice",
            "algorithm/output.rs",
            "            self.triangulate(&mut out, part, Source::Cap(plane), support, &loops);\n",
            "            let from = out.parts[part as usize].triangles.len();
            self.triangulate(&mut out, part, Source::Cap(plane), support, &loops);
            out.parts[part as usize].triangles[from..].iter_mut().for_each(|triangle| triangle.reverse());\n",
        )],
        seen: Run("slices", "exact", &[["topology", "cap orientation"], ["topology", "part not closed"]]),
    },
    Planted {
        name: "wrong-side",
        what: "the first face is put with the part on the other side",
        changes: &[change(
            "slice",
            "algorithm/output.rs",
            "            let source = Source::Face(",
            "            let is_first = self.parts > 1 && out.parts.iter().all(|part| part.triangles.is_empty());
            let part = if is_first { (part + 1) % 2 } else { part };
            let source = Source::Face(",
        )],
        seen: Run("slices", "exact", &[["topology", "part not closed"], ["topology", "wrong side"]]),
    },
    Planted {
        name: "unsorted-split-points",
        what: "the points of a concave face on the plane are joined in the order of its edges",
        changes: &[change(
            "slice",
            "algorithm/chords.rs",
            "        sort_by_sign(corners, |a, b| self.session.compare(axis, vertex(&a), vertex(&b)));\n",
            "        sort_by_sign(corners, |_, _| Sign::Zero);\n",
        )],
        seen: Run("slices", "exact", &[["topology", "piece orientation"]]),
    },
    Planted {
        name: "skipped-triangle",
        what: "the grid lists a triangle in the cell of one corner only",
        changes: &[change(
            "mesh-locate",
            "algorithm/index.rs",
            "        let grid = TwoLevel::new(&boxes, sizes",
            "        let mut boxes = boxes;
        // A box of a corner alone: the rest of the triangle is in no cell.
        let middle = boxes.len() / 2;
        boxes[middle].high = boxes[middle].low;
        let grid = TwoLevel::new(&boxes, sizes",
        )],
        seen: Test("mesh-locate", "mesh_locate_scale::"),
    },
    Planted {
        name: "mistaken-cavity",
        what: "a set of empty cells inside of a region is taken for the outside",
        changes: &[change(
            "mesh-locate",
            "algorithm/index.rs",
            "        let of_slot = |slot: usize| self.empty",
            "        let mut of_region = of_region;
        if let Some(cavity) = (0..self.empty.len()).find(|&region| !self.empty.is_open(region)) {
            of_region[cavity] = OUTSIDE;
        }
        let of_slot = |slot: usize| self.empty",
        )],
        seen: Run("mesh-points", "exact", &[["topology", "shortcut"]]),
    },
    Planted {
        name: "farther-triangle",
        what: "of two triangles above a point the farther is taken",
        changes: &[change(
            "mesh-locate",
            "algorithm/single.rs",
            "|other| is_nearer(session, direction, corners, other));",
            "|other| is_nearer(session, direction, corners, other).map(|is| !is));",
        )],
        seen: Run("mesh-points", "exact", &[["topology", "shortcut"]]),
    },
];
