// The npm package delaunator.

import fs from "node:fs";
import Delaunator from "delaunator";
import { serve } from "../node/predicament_engine.mjs";

const manifest = new URL("node_modules/delaunator/package.json", import.meta.url);

serve({
    name: "delaunator",
    version: JSON.parse(fs.readFileSync(manifest, "utf8")).version,
    tasks: { delaunay2d: ({ points }) => Delaunator.from(points).triangles },
});
