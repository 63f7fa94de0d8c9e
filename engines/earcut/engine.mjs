// The npm package earcut. It wants an outer ring and then holes: the outer ring's bounding box has all others in it. Other
// nests of rings, such as islands in holes, are declined.

import fs from "node:fs";
import earcut from "earcut";
import { Declined, serve } from "../node/predicament_engine.mjs";

const manifest = new URL("node_modules/earcut/package.json", import.meta.url);

/** The low corner of a ring's bounding box, then the high corner with its sign changed. */
const extent = (ring) => [0, 1, 0, 1].map((axis, i) => Math.min(...ring.map((point) => (i < 2 ? point[axis] : -point[axis]))));

/** The rings, the outer one first. Declines nests of rings that are not an outer ring with holes. */
function withHoles(rings, points) {
    const boxes = new Map(rings.map((ring) => [ring, extent(ring.map((v) => points[v]))]));
    const holds = (one, other) => one !== other && boxes.get(one).every((x, i) => x <= boxes.get(other)[i]);
    const outer = rings.find((ring) => rings.every((other) => ring === other || holds(ring, other)));
    const holes = rings.filter((ring) => ring !== outer);
    if (outer === undefined || holes.some((hole) => rings.some((other) => holds(hole, other))))
        throw new Declined("the rings are not an outer ring with holes");
    return [outer, ...holes];
}

function triangulate({ points, rings }) {
    const sorted = withHoles(rings, points);
    const corners = sorted.flat();
    let end = 0;
    const holes = sorted.slice(0, -1).map((ring) => (end += ring.length));
    return earcut(corners.flatMap((v) => points[v]), holes).map((at) => corners[at]);
}

serve({
    name: "earcut",
    version: JSON.parse(fs.readFileSync(manifest, "utf8")).version,
    tasks: { triangulate },
});
