//! Faults of algorithms of the line and the plane.

use super::Seen::Run;
use super::{Change, Planted, change};

pub(super) const FAULTS: &[Planted] = &[
    Planted {
        name: "closed-interval",
        what: "a point at the end of a cell counts as inside",
        changes: &[change("interval", "algorithm/mod.rs", "_ => Place::AtEnd,", "_ => Place::Inside,")],
        seen: Run("intervals", "exact", &[["topology", "double"]]),
    },
    Planted {
        name: "skipped-edge",
        what: "the grid skips an edge in the middle of the map",
        changes: &[change(
            "polygon-locate",
            "algorithm/index.rs",
            "        let cells = Cells::new(&segments, ",
            "        let mut segments = segments;
        if !segments.is_empty() {
            // An edge without length is never crossed.
            let middle = segments.len() / 2;
            segments[middle] = [segments[middle][0]; 2];
        }
        let cells = Cells::new(&segments, ",
        )],
        seen: Run("tilings", "exact", &[["topology", "shortcut"]]),
    },
    Planted {
        name: "strict-sweep",
        what: "segments that begin at the x at which another one ends are not looked at",
        changes: &[change(
            "crossings",
            "algorithm/mod.rs",
            "reach(segments[j])[0] <= right",
            "reach(segments[j])[0] < right",
        )],
        seen: Run("crossings", "sos", &[["sign_flip", "perturbed crossings"]]),
    },
    Planted {
        name: "unsorted-crossings",
        what: "the crossings of a segment are in the order of the other segments",
        changes: &[change(
            "crossings",
            "algorithm/mod.rs",
            "    insertion_sort(&mut found, |u, v| order(u.0, v.0) == Sign::Negative);\n",
            "",
        )],
        seen: Run("crossings", "exact", &[["missed_zero", "order"], ["sign_flip", "order"]]),
    },
    Planted {
        name: "flat-corners",
        what: "three vertices in line are cut off as a triangle at the lower end of a chain",
        changes: &[change(
            "triangulate",
            "algorithm/sweep.rs",
            "            if !(sign == Sign::Positive || sign == Sign::Zero && !is_past) {
                if !is_past {
                    self.out.broken(Contradiction::Chain);
                }
                return low;",
            "            if !(sign == Sign::Positive || sign == Sign::Zero) {
                if !is_past {
                    self.out.broken(Contradiction::Chain);
                }
                return low;",
        )],
        seen: Run("polygons", "exact", &[["topology", "positive"]]),
    },
    Planted {
        name: "hidden-helper",
        what: "a split vertex is joined to the left end of the lower edge, which it may not see",
        changes: &[change(
            "triangulate",
            "algorithm/sweep.rs",
            "        self.splits.push([corner, self.nodes[last as usize].corner]);",
            "        let last = if last == NONE { last } else { self.regions[below as usize].low };
        self.splits.push([corner, self.nodes[last as usize].corner]);",
        )],
        seen: Run("polygons", "exact", &[["topology", "positive"], ["topology", "overlap"]]),
    },
    Planted {
        name: "blind-ears",
        what: "ears are cut off whether there are vertices in them or not",
        changes: &[change(
            "triangulate",
            "algorithm/ears.rs",
            "match self.blocker(corner) {",
            "match self.blocker(corner).filter(|_| false) {",
        )],
        seen: Run("polygons", "sos", &[["topology", "positive"], ["topology", "overlap"]]),
    },
    Planted {
        name: "dropped-triangle",
        what: "the last triangle is missing",
        changes: &[change(
            "triangulate",
            "algorithm/mod.rs",
            "    out.made\n}",
            "    out.made.triangles.pop();\n    out.made\n}",
        )],
        seen: Run(
            "polygons",
            "sos",
            &[["topology", "area"], ["topology", "boundary"], ["topology", "count"], ["topology", "diagonals"]],
        ),
    },
    Planted {
        name: "hull-collinear-kept",
        what: "of three vertices in one line the hull keeps the one in the middle",
        changes: &[change("hull", "algorithm/chains.rs", "turn == Sign::Positive\n", "turn != Sign::Negative\n")],
        seen: Run("hulls", "exact", &[["topology", "extreme"], ["topology", "extreme vertices"]]),
    },
    Planted {
        name: "hull-half-tangent",
        what: "the common tangent of two hulls moves along the first one only",
        changes: &[change(
            "hull",
            "algorithm/chains.rs",
            "while j + 1 < right.len()",
            "while j + 1 < right.len().min(1)",
        )],
        seen: Run("hulls", "exact", &[["topology", "convex"], ["topology", "extreme vertices"]]),
    },
    Planted {
        name: "delaunay-neighbours-only",
        what: "of the triangles whose circle a vertex is in, only neighbours of the first one are replaced",
        changes: &[
            change(
                "delaunay",
                "algorithm/insert.rs",
                "        self.mesh.unmark();\n",
                "        self.mesh.unmark();\n        let mut reached = 0;\n",
            ),
            change(
                "delaunay",
                "algorithm/insert.rs",
                "            is_in_circle(session, mesh, outside, v)\n",
                "            reached += 1;
            reached <= 3 && is_in_circle(session, mesh, outside, v)\n",
            ),
        ],
        seen: Run("delaunay", "exact", &[["topology", "empty circle"], ["topology", "positive"]]),
    },
    Planted {
        name: "delaunay-one-edge-seen",
        what: "a vertex outside of the hull is joined to one edge of it only",
        changes: &[change(
            "delaunay",
            "algorithm/insert.rs",
            "        Sign::Positive => true,",
            "        Sign::Positive => false,",
        )],
        seen: Run("delaunay", "exact", &[["topology", "convex"], ["topology", "area"]]),
    },
    Planted {
        name: "delaunay-lines-outside",
        what: "a vertex in the line of an edge of the hull is joined to that edge",
        changes: &[change(
            "delaunay",
            "algorithm/insert.rs",
            "        Sign::Zero => is_between(session, a, b, v),",
            "        Sign::Zero => is_between(session, a, b, v) || v != a,",
        )],
        seen: Run("delaunay", "exact", &[["topology", "positive"]]),
    },
    Planted {
        name: "delaunay-faces-left",
        what: "faces of vertices on one circle are not cut as fans from their smallest index",
        changes: &[change(
            "delaunay",
            "algorithm/faces.rs",
            "            if self.mesh.is_infinite(triangle) || !self.mesh.has_round(triangle)",
            "            if triangle < self.mesh.len() || !self.mesh.has_round(triangle)",
        )],
        seen: Run("delaunay", "exact", &[["topology", "fan"]]),
    },
    Planted {
        name: "delaunay-copies-forgotten",
        what: "vertices in the place of another one are not listed",
        changes: &[change("delaunay", "algorithm/answer.rs", "copies: resolved(&self.copies),", "copies: Vec::new(),")],
        seen: Run("delaunay", "exact", &[["topology", "copies"]]),
    },
    Planted {
        name: "delaunay-constraint-stopped",
        what: "a constraint that goes through a vertex ends there",
        changes: &[change(
            "delaunay",
            "algorithm/constrained.rs",
            "            if v != w {",
            "            if v != w && v == u {",
        )],
        seen: Run("delaunay", "exact", &[["topology", "constraint"]]),
    },
    Planted {
        name: "open-boxes",
        what: "segments whose boxes only touch are not compared",
        changes: &[change(
            "overlay",
            "algorithm/overlay/cells.rs",
            "(a[0] <= b[2]) & (b[0] <= a[2]) & (a[1] <= b[3]) & (b[1] <= a[3])",
            "(a[0] < b[2]) & (b[0] < a[2]) & (a[1] < b[3]) & (b[1] < a[3])",
        )],
        seen: Run("overlays", "exact", &[["topology", "undiscovered crossing"]]),
    },
    Planted {
        name: "forgotten-touches",
        what: "a vertex on another segment does not divide it",
        changes: &[change(
            "overlay",
            "algorithm/overlay/chains.rs",
            "    on.append(&mut touches);\n",
            "    touches.clear();\n    on.append(&mut touches);\n",
        )],
        seen: Run("overlays", "exact", &[["topology", "undiscovered crossing"]]),
    },
    Planted {
        name: "unsorted-chains",
        what: "the vertices on a segment are in the order of their ids",
        changes: &[change(
            "overlay",
            "algorithm/overlay/chains.rs",
            "    sort_by_sign(inner, |a, b| along.order(a, b));\n",
            "    inner.sort_unstable();\n    sort_by_sign(inner, |_, _| Sign::Zero);\n",
        )],
        seen: Run("overlays", "exact", &[["topology", "chain"]]),
    },
    Planted {
        name: "single-counts",
        what: "edges that several input edges pass are counted once",
        changes: &[
            change(
                "overlay",
                "algorithm/overlay/chains.rs",
                "segment: number(segment), label });",
                "segment: number(segment), label: label.map(i32::signum) });",
            ),
            change(
                "overlay",
                "algorithm/overlay/chains.rs",
                "                    *sum = sum.saturating_add(direction * more);",
                "                    *sum = sum.saturating_add(0 * direction * more);",
            ),
        ],
        seen: Run("overlays", "exact", &[["topology", "winding"], ["topology", "area"], ["topology", "membership"]]),
    },
    Planted {
        name: "outside-nests",
        what: "components in a face of another are taken to be outside",
        changes: &[change(
            "overlay",
            "algorithm/overlay/nest.rs",
            "        if leftmost.len() < 2 {",
            "        if leftmost.len() < usize::MAX {",
        )],
        seen: Run("overlays", "exact", &[["topology", "nesting"], ["topology", "area"], ["topology", "membership"]]),
    },
    Planted {
        name: "dropped-holes",
        what: "the holes of results are left out",
        changes: &[change(
            "overlay",
            "algorithm/overlay/result.rs",
            "            result.regions.push(Region { outer: outer.edges.clone(), holes });",
            "            let none = holes.into_iter().take(0).collect();
            result.regions.push(Region { outer: outer.edges.clone(), holes: none });",
        )],
        seen: Run("overlays", "exact", &[["topology", "area"], ["topology", "membership"]]),
    },
    Planted {
        name: "snap-crossing-forgotten",
        what: "every third crossing is not hot",
        changes: &[Change {
            package: "overlay",
            file: "task/snap/mod.rs",
            is: "    let points = points(session.scene());",
            becomes: "    let crossings: Vec<[u32; 2]> =
        crossings.into_iter().enumerate().filter(|(at, _)| at % 3 != 2).map(|(_, one)| one).collect();
    let points = points(session.scene());",
        }],
        seen: Run("snaps", "exact", &[["topology", "all hot pixels"], ["topology", "no new crossing"]]),
    },
    Planted {
        name: "snap-points-only",
        what: "ends and crossings are rounded, and edges are left to pass over the vertices beside them",
        changes: &[Change {
            package: "overlay",
            file: "task/snap/mod.rs",
            is: "snap(drawing, content.pixel, content.method)",
            becomes: "snap(drawing, content.pixel, crate::algorithm::snap::Method::Naive)",
        }],
        seen: Run("snaps", "exact", &[["topology", "all hot pixels"], ["topology", "no vertex near an edge"]]),
    },
];
