// The npm package cdt2d. Its page excludes points that coincide, and constraints that run through points: scenes with these
// are declined. Constraints through points are found by its own dependency robust-orientation.

import fs from "node:fs";
import cdt2d from "cdt2d";
import orientation from "robust-orientation";
import { Declined, serve } from "../node/predicament_engine.mjs";

const manifest = new URL("node_modules/cdt2d/package.json", import.meta.url);

/** Whether p is on the edge between a and b, but not at its ends. */
function isInside(p, a, b) {
    const isBetween = [0, 1].every((i) => Math.min(a[i], b[i]) <= p[i] && p[i] <= Math.max(a[i], b[i]));
    const isEnd = [a, b].some((q) => p[0] === q[0] && p[1] === q[1]);
    return isBetween && !isEnd && orientation(a, b, p) === 0;
}

function delaunay({ points, constraints = [] }) {
    if (new Set(points.map(([x, y]) => `${x + 0} ${y + 0}`)).size < points.length) throw new Declined("points coincide");
    if (constraints.some(([a, b]) => points.some((p) => isInside(p, points[a], points[b]))))
        throw new Declined("a constraint runs through a point");
    return cdt2d(points, constraints);
}

serve({
    name: "cdt2d",
    version: JSON.parse(fs.readFileSync(manifest, "utf8")).version,
    tasks: { delaunay2d: delaunay },
});
