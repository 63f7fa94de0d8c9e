
// REPLACE. The triangles of one polygon. `rings` are its rings, as lists of indices of points. This cuts ears.
function triangulate({ points, rings }) {
    if (rings.length > 1) throw new Declined("this example takes polygons without holes");
    const ring = [...rings[0]];
    const area = ring.slice(1).reduce((sum, v, at) => sum + turn(points[ring[0]], points[ring[at]], points[v]), 0);
    if (area < 0) ring.reverse();
    const triangles = [];
    while (ring.length > 3) {
        const ear = Math.max(ring.findIndex((_, at) => isEar(points, ring, at)), 0);
        triangles.push([ring.at(ear - 1), ring[ear], ring[(ear + 1) % ring.length]]);
        ring.splice(ear, 1);
    }
    return [...triangles, ring];
}

function isEar(points, ring, at) {
    const corners = [ring.at(at - 1), ring[at], ring[(at + 1) % ring.length]];
    const [a, b, c] = corners.map((v) => points[v]);
    const isIn = (p) => [turn(a, b, p), turn(b, c, p), turn(c, a, p)].every((side) => side >= 0);
    return turn(a, b, c) > 0 && !ring.some((v) => !corners.includes(v) && isIn(points[v]));
}

const turn = (p, q, r) => (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
