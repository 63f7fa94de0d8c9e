// The npm packages robust-orientation and robust-in-sphere. The orientation in the plane and the sphere in space have the
// opposite of our sign.

import fs from "node:fs";
import orient from "robust-orientation";
import inSphere from "robust-in-sphere";
import { serve } from "../node/predicament_engine.mjs";

const version = (name) =>
    JSON.parse(fs.readFileSync(new URL(`node_modules/${name}/package.json`, import.meta.url), "utf8")).version;

serve({
    name: "robust-orientation",
    version: `${version("robust-orientation")}, robust-in-sphere ${version("robust-in-sphere")}`,
    zero: "exact",
    orient2d: (a, b, c) => -orient[3](a, b, c),
    orient3d: (a, b, c, d) => orient[4](a, b, c, d),
    incircle: (a, b, c, d) => inSphere[4](a, b, c, d),
    insphere: (a, b, c, d, e) => -inSphere[5](a, b, c, d, e),
});
