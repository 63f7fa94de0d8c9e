// The engine {name}. Each predicate is a plain determinant, which is wrong near a tie.
//
// REPLACE the body of each predicate by a call of your library. Delete a predicate that your library lacks. Only the
// sign of a result counts. predicament_engine.mjs lists the other members that an engine may have.

import { serve } from "./predicament_engine.mjs";

const minus = (p, q) => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];

/** The difference of two points of the plane, and its squared length as z. */
const lifted = (p, q) => {
    const [x, y] = [p[0] - q[0], p[1] - q[1]];
    return [x, y, x * x + y * y];
};

const squared = ([x, y, z]) => x * x + y * y + z * z;

const triple = (p, q, r) =>
    p[2] * (q[0] * r[1] - r[0] * q[1]) + q[2] * (r[0] * p[1] - p[0] * r[1]) + r[2] * (p[0] * q[1] - q[0] * p[1]);

serve({
    name: "{name}",
    version: "1.0", // the version of your library
    zero: "exact", // exact: a zero means that the points are degenerate. never: your library breaks ties

    // REPLACE. Positive where a's coordinate is greater than b's. axis is 0, 1 or 2.
    compare: (axis, a, b) => a[axis] - b[axis],

    // REPLACE. Positive where a, b, c turn counterclockwise.
    orient2d: (a, b, c) => (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]),

    // REPLACE. Positive where d is below the plane of a, b, c, which turn counterclockwise seen from above.
    orient3d: (a, b, c, d) => triple(minus(a, d), minus(b, d), minus(c, d)),

    // REPLACE. Positive where d is inside the circle of a, b, c, which turn counterclockwise.
    incircle: (a, b, c, d) => triple(lifted(a, d), lifted(b, d), lifted(c, d)),

    // REPLACE. Positive where e is inside the sphere of a, b, c, d, whose orient3d is positive.
    insphere: (a, b, c, d, e) => {
        const [p, q, r, s] = [minus(a, e), minus(b, e), minus(c, e), minus(d, e)];
        return (
            squared(s) * triple(p, q, r) -
            squared(r) * triple(p, q, s) +
            (squared(q) * triple(p, r, s) - squared(p) * triple(q, r, s))
        );
    },
});
