// The npm package martinez-polygon-clipping. Its sweep counts crossings of an operand's edges, of whatever ring: the even-odd
// rule. So an operand is one polygon with all its rings. The package wants rings that end where they begin.

import fs from "node:fs";
import * as martinez from "martinez-polygon-clipping";
import { Declined, serve } from "../node/predicament_engine.mjs";

const manifest = new URL("node_modules/martinez-polygon-clipping/package.json", import.meta.url);

const region = (rings) => rings.map((ring) => [...ring, ring[0]]);

function overlay({ first, second, rule }) {
    if (rule !== "even-odd") throw new Declined("the package has no rule of nonzero winding numbers");
    const [a, b] = [region(first), region(second)];
    return {
        union: martinez.union(a, b) ?? [],
        intersection: martinez.intersection(a, b) ?? [],
        difference: martinez.diff(a, b) ?? [],
        "symmetric-difference": martinez.xor(a, b) ?? [],
    };
}

serve({
    name: "martinez",
    version: JSON.parse(fs.readFileSync(manifest, "utf8")).version,
    tasks: { overlay2d: overlay },
});
