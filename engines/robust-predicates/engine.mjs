// The npm package robust-predicates. Its y axis points down, and its circles and spheres are negative inside: orient2d and
// insphere have the opposite of our sign, orient3d and incircle have ours.

import fs from "node:fs";
import { incircle, insphere, orient2d, orient3d } from "robust-predicates";
import { serve } from "../node/predicament_engine.mjs";

const manifest = new URL("node_modules/robust-predicates/package.json", import.meta.url);

serve({
    name: "robust-predicates",
    version: JSON.parse(fs.readFileSync(manifest, "utf8")).version,
    zero: "exact",
    orient2d: (a, b, c) => -orient2d(a[0], a[1], b[0], b[1], c[0], c[1]),
    orient3d: (a, b, c, d) => orient3d(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2]),
    incircle: (a, b, c, d) => incircle(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]),
    insphere: (a, b, c, d, e) =>
        -insphere(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2], e[0], e[1], e[2]),
});
