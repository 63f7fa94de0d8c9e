// The npm package polygon-clipping. In one of its polygons, rings after the first are holes. So each ring goes in as a polygon
// of its own: the `xor` of an operand's rings is the even-odd rule. (In a ring that crosses itself, the package follows the
// rule of nonzero winding numbers.)

import fs from "node:fs";
import polygonClipping from "polygon-clipping";
import { Declined, serve } from "../node/predicament_engine.mjs";

const manifest = new URL("node_modules/polygon-clipping/package.json", import.meta.url);

const region = (rings) => (rings.length > 1 ? polygonClipping.xor(...rings.map((ring) => [ring])) : rings.map((ring) => [ring]));

function overlay({ first, second, rule }) {
    if (rule !== "even-odd") throw new Declined("the package has no rule of nonzero winding numbers for several rings");
    const [a, b] = [region(first), region(second)];
    return {
        union: polygonClipping.union(a, b),
        intersection: polygonClipping.intersection(a, b),
        difference: polygonClipping.difference(a, b),
        "symmetric-difference": polygonClipping.xor(a, b),
    };
}

serve({
    name: "polygon-clipping",
    version: JSON.parse(fs.readFileSync(manifest, "utf8")).version,
    tasks: { overlay2d: overlay },
});
