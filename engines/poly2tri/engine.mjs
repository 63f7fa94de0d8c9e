// The npm package poly2tri. Its page excludes points that coincide: scenes with these are declined, and so are nests of
// rings that are not an outer ring with holes. The package throws `PointError` for input that it does not support.

import fs from "node:fs";
import poly2tri from "poly2tri";
import { Declined, outerFirst, serve } from "../node/predicament_engine.mjs";

const manifest = new URL("node_modules/poly2tri/package.json", import.meta.url);

function triangulate({ points, rings }) {
    const loops = outerFirst(rings, points).map((ring) => ring.map((id) => ({ x: points[id][0], y: points[id][1], id })));
    if (new Set(loops.flat().map(({ x, y }) => `${x + 0} ${y + 0}`)).size < loops.flat().length)
        throw new Declined("points coincide");
    const context = new poly2tri.SweepContext(loops[0]).addHoles(loops.slice(1));
    return context.triangulate().getTriangles().map((triangle) => triangle.getPoints().map(({ id }) => id));
}

serve({
    name: "poly2tri",
    version: JSON.parse(fs.readFileSync(manifest, "utf8")).version,
    tasks: { triangulate },
});
