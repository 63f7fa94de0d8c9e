
// REPLACE. The distance of two objects: of polygons, by loops of points, or of meshes, by triangles. Each vertex is
// measured to each edge of the other object.
function distance({ points, a, b }) {
    const place = (part) => part.map((v) => points[v]);
    const [one, other] = [a.map(place), b.map(place)];
    return Math.min(toObject(one, other), toObject(other, one));
}

function toObject(from, to) {
    const edges = to.flatMap((part) => part.map((p, at) => [p, part[(at + 1) % part.length]]));
    return from.flat().reduce((least, p) => edges.reduce((least, edge) => Math.min(least, toEdge(p, edge)), least), Infinity);
}

function toEdge(p, [a, b]) {
    const along = b.map((x, axis) => x - a[axis]);
    const dot = (u, v) => u.reduce((sum, x, axis) => sum + x * v[axis], 0);
    const from = p.map((x, axis) => x - a[axis]);
    const place = Math.min(Math.max(dot(from, along) / dot(along, along) || 0, 0), 1);
    return Math.hypot(...from.map((x, axis) => x - place * along[axis]));
}
