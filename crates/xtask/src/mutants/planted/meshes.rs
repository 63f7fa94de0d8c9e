//! Faults of overlays of meshes, and of what makes meshes of doubles of them.

use super::Seen::{Run, Test};
use super::{Change, Planted, change};

/// Without this a limit with a fault is found open, and there is none.
const OPEN: Change = change(
    "mesh-intersect",
    "algorithm/limit/mod.rs",
    "if !self.open().is_empty() {",
    "if self.open().len() == usize::MAX {",
);

pub(super) const FAULTS: &[Planted] = &[
    Planted {
        name: "mesh-overlay-two-sides",
        what: "the third edge of a triangle is not looked at",
        changes: &[change(
            "mesh-intersect",
            "algorithm/overlay/meet.rs",
            "let third = side(c, a);",
            "let third = first;",
        )],
        seen: Run("intersections", "sos", &[["topology", "two triangles meet in one segment"]]),
    },
    Planted {
        name: "mesh-overlay-backwards",
        what: "points on an edge are sorted backwards",
        changes: &[change(
            "mesh-intersect",
            "algorithm/overlay/points.rs",
            "            points.sort(session, near.edges[many[at] as usize], &mut places);\n",
            "            points.sort(session, near.edges[many[at] as usize], &mut places);\n            places.reverse();\n",
        )],
        seen: Run(
            "intersections",
            "sos:per-mesh",
            &[["topology", "vertices that no triangle parts are in one region"]],
        ),
    },
    Planted {
        name: "mesh-overlay-drops-a-piece",
        what: "a cut triangle loses a piece",
        changes: &[change(
            "mesh-intersect",
            "algorithm/overlay/mod.rs",
            "    done(Step::Faces);\n",
            "    pieces[0].pop();\n    done(Step::Faces);\n",
        )],
        seen: Run(
            "intersections",
            "sos",
            &[["topology", "region not closed"], ["topology", "face area"], ["topology", "volume"]],
        ),
    },
    Planted {
        name: "mesh-overlay-components",
        what: "a component without cuts is taken to be outside",
        changes: &[change(
            "mesh-intersect",
            "algorithm/overlay/regions.rs",
            "        if unknown.is_empty() {
            return Ok(Vec::new());
        }\n",
            "        if mesh.triangles().len() < usize::MAX {
            return Ok(unknown.into_keys().map(|root| (root, OUTSIDE)).collect());
        }\n",
        )],
        seen: Run("intersections", "sos", &[["topology", "region of a piece"], ["topology", "point in a result"]]),
    },
    Planted {
        name: "mesh-overlay-sides",
        what: "what is in front of a piece is said to be behind it",
        changes: &[change(
            "mesh-intersect",
            "algorithm/overlay/result.rs",
            "            self.meshes[usize::from(*side)].sides()[piece.of as usize].map(pair)\n",
            "            let [front, behind] = self.meshes[usize::from(*side)].sides()[piece.of as usize].map(pair);
            [behind, front]\n",
        )],
        seen: Run("intersections", "sos", &[["topology", "sides of a piece"]]),
    },
    Planted {
        name: "mesh-overlay-turns",
        what: "pieces of the second mesh are not turned over in a difference",
        changes: &[change(
            "mesh-intersect",
            "algorithm/overlay/result.rs",
            "[true, false] => Some(([a, c, b], (source, true))),",
            "[true, false] => Some(([a, b, c], (source, false))),",
        )],
        seen: Run("intersections", "sos", &[["topology", "operation"]]),
    },
    Planted {
        name: "mesh-overlay-loses-a-contact",
        what: "of the registered contacts of edges of the first mesh the last one is lost",
        changes: &[change(
            "mesh-intersect",
            "algorithm/overlay/registered.rs",
            "    done(Step::Passages);\n",
            "    hits[0].pop();\n    done(Step::Passages);\n",
        )],
        seen: Run("intersections", "tolerance", &[["topology", "vertices that no triangle parts are in one region"]]),
    },
    Planted {
        name: "mesh-overlay-clear",
        what: "what both meshes have is set aside wherever it is",
        changes: &[change(
            "mesh-intersect",
            "algorithm/overlay/same.rs",
            "is_same[at] && is_clear(at)",
            "is_same[at] && (is_clear(at) || true)",
        )],
        seen: Test("mesh-intersect", "mesh_overlay_same::"),
    },
    Planted {
        name: "mesh-overlay-apart",
        what: "what both meshes have is set aside although it touches itself",
        changes: &[change(
            "mesh-intersect",
            "algorithm/overlay/same.rs",
            "aside[at as usize] = is_apart;",
            "aside[at as usize] = is_apart || true;",
        )],
        seen: Test("mesh-intersect", "mesh_overlay_same::"),
    },
    Planted {
        name: "mesh-limit-vertices",
        what: "vertices at one place stay apart",
        changes: &[
            change(
                "mesh-intersect",
                "algorithm/limit/mod.rs",
                "        let same = Same::of(session, &self.places, vertices);\n",
                "        let same = Same::of(session, &self.places, Vec::clone(&vertices).split_off(vertices.len()));\n",
            ),
            OPEN,
        ],
        seen: Run("intersections", "sos:per-mesh", &[["topology", "vertices of a limit"]]),
    },
    Planted {
        name: "mesh-limit-sheets",
        what: "what faces each other in one plane stays",
        changes: &[
            change(
                "mesh-intersect",
                "algorithm/limit/mod.rs",
                "    work.uncover(session, overlay)?;\n",
                "    if work.gone.len() == usize::MAX {\n        work.uncover(session, overlay)?;\n    }\n",
            ),
            OPEN,
        ],
        seen: Run("intersections", "sos:per-mesh", &[["topology", "settled result crosses itself"]]),
    },
    Planted {
        name: "mesh-limit-joints",
        what: "edges are not divided at vertices on them",
        changes: &[
            change(
                "mesh-intersect",
                "algorithm/limit/mod.rs",
                "    work.divide(session);\n",
                "    if work.gone.len() == usize::MAX {\n        work.divide(session);\n    }\n",
            ),
            OPEN,
        ],
        seen: Run("intersections", "sos:per-mesh", &[["topology", "settled result not closed"]]),
    },
    Planted {
        name: "mesh-resolve-search",
        what: "no triangles that meet are found",
        changes: &[change(
            "mesh-intersect",
            "algorithm/resolve/mod.rs",
            "let pairs = pairs(session, faces.len(), &triangle, &|v| moved[v as usize]);",
            "let pairs = pairs(session, faces.len(), &triangle, &|v| moved[v as usize]).into_iter().take(0);",
        )],
        seen: Test("mesh-intersect", "mesh_resolve::"),
    },
    Planted {
        name: "mesh-resolve-planes",
        what: "triangles of one plane are cut apart from each other",
        changes: &[change(
            "mesh-intersect",
            "algorithm/resolve/cut.rs",
            "let joined = pairs.iter().filter(|(_, is_coplanar)| *is_coplanar);",
            "let joined = pairs.iter().filter(|(_, is_coplanar)| *is_coplanar).take(0);",
        )],
        seen: Test("mesh-intersect", "mesh_resolve::"),
    },
    Planted {
        name: "mesh-resolve-points",
        what: "corners that touch a triangle inside are no corners of its parts",
        changes: &[change(
            "mesh-intersect",
            "algorithm/resolve/cut.rs",
            "    points.into_iter().for_each(|v| segments.point(v));",
            "    points.into_iter().take(0).for_each(|v| segments.point(v));",
        )],
        seen: Test("mesh-intersect", "mesh_resolve::"),
    },
    Planted {
        name: "mesh-resolve-inside",
        what: "faces with the inside on both sides stay",
        changes: &[change(
            "mesh-intersect",
            "algorithm/resolve/mod.rs",
            "front <= 0 && front + face.times > 0;",
            "front <= 0 && front + face.times > 0 || face.times != 0;",
        )],
        seen: Test("mesh-intersect", "mesh_resolve::"),
    },
    Planted {
        name: "mesh-rounding-search",
        what: "no flaws of rounding are found",
        changes: &[change(
            "mesh-intersect",
            "algorithm/rounding/mod.rs",
            "flaws::flaws(session, &built.triangles, &is_moved, &rounding.turns);",
            "flaws::flaws(session, &built.triangles[..0], &is_moved, &rounding.turns);",
        )],
        seen: Test("mesh-intersect", "mesh_rounding::"),
    },
];
