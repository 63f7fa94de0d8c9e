// The npm package earcut. It wants an outer ring and then holes. Other nests of rings, such as islands in holes, are
// declined.

import fs from "node:fs";
import earcut from "earcut";
import { outerFirst, serve } from "../node/predicament_engine.mjs";

const manifest = new URL("node_modules/earcut/package.json", import.meta.url);

function triangulate({ points, rings }) {
    const sorted = outerFirst(rings, points);
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
