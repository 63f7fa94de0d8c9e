
// REPLACE. Results by name: "union", "intersection", "difference", "symmetric-difference", all or some of them. A result is
// a list of polygons, and a polygon a list of rings, the outer one first. This clips one convex polygon by another
// (Sutherland and Hodgman 1974).
function overlay2d({ first, second }) {
    const isTaken = first.length === 1 && second.length === 1 && isConvex(first[0]) && isConvex(second[0]);
    if (!isTaken) throw new Declined("this example takes two convex polygons");
    const clip = corners(second[0]).reduce((sum, corner) => sum + turn(...corner), 0) > 0 ? second[0] : [...second[0]].reverse();
    let ring = first[0];
    clip.forEach((a, at) => {
        const b = clip[(at + 1) % clip.length];
        ring = ring.flatMap((q, i) => clipped(a, b, ring.at(i - 1), q));
    });
    return { intersection: ring.length > 0 ? [[ring]] : [] };
}

/** The part of the edge from p to q on the left of the line from a to b, without its start. */
function clipped(a, b, p, q) {
    const [fromP, fromQ] = [turn(a, b, p), turn(a, b, q)];
    const part = fromP === fromQ ? 0 : fromP / (fromP - fromQ);
    const crossing = [p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1])];
    return [...(fromP < 0 !== fromQ < 0 ? [crossing] : []), ...(fromQ >= 0 ? [q] : [])];
}

const turn = (p, q, r) => (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
const corners = (ring) => ring.map((p, at) => [p, ring[(at + 1) % ring.length], ring[(at + 2) % ring.length]]);
const isConvex = (ring) => new Set(corners(ring).map((corner) => turn(...corner) > 0)).size === 1;
