
// REPLACE. For each ray the triangles that it hits, in their order along it. Each triangle is tried.
function mesh_rays({ vertices, triangles, rays, extent }) {
    const solid = triangles.map((triangle) => triangle.map((v) => vertices[v]));
    const counts = (place) => (extent === "line" || place >= 0) && (extent !== "segment" || place <= 1);
    return rays.map((ray) => {
        const hits = solid.flatMap((corners, face) => rayHit(corners, ray).filter(counts).map((place) => [place, face]));
        return hits.sort((one, other) => one[0] - other[0]).map(([, face]) => face);
    });
}

/** The place of the hit on the ray, if there is one: from 0 at its first point to 1 at its second. */
function rayHit([a, b, c], [p, q]) {
    const [along, u, v, fromA] = [minus(q, p), minus(b, a), minus(c, a), minus(p, a)];
    const across = cross(along, v);
    const volume = dot(u, across);
    const second = dot(fromA, across) / volume;
    const other = cross(fromA, u);
    const third = dot(along, other) / volume;
    return second >= 0 && third >= 0 && second + third <= 1 ? [dot(v, other) / volume] : [];
}

const minus = (p, q) => p.map((x, axis) => x - q[axis]);
const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
