
// REPLACE. Pairs of simplices that meet, each with the indices of its points. Of triangles, each pair is tried: an edge of
// one goes through the other.
function contacts3d({ points, a, b }) {
    if ([...a, ...b].some((simplex) => simplex.length !== 3)) throw new Declined("this example takes triangles");
    const placed = (triangle) => triangle.map((v) => points[v]);
    return a.flatMap((s) => b.filter((t) => meet(placed(s), placed(t))).map((t) => [s, t]));
}

function meet(s, t) {
    const edges = (corners) => corners.map((p, at) => [p, corners[(at + 1) % 3]]);
    return edges(s).some((edge) => pierces(edge, t)) || edges(t).some((edge) => pierces(edge, s));
}

function pierces([p, q], [a, b, c]) {
    const sides = [volume(a, b, c, p), volume(a, b, c, q)];
    const turns = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
    const isThrough = sides[0] * sides[1] <= 0 && sides.some((side) => side !== 0);
    return isThrough && (turns.every((turn) => turn >= 0) || turns.every((turn) => turn <= 0));
}

function volume(a, b, c, d) {
    const [p, q, r] = [a, b, c].map((point) => point.map((x, axis) => x - d[axis]));
    return (
        p[2] * (q[0] * r[1] - r[0] * q[1]) + q[2] * (r[0] * p[1] - p[0] * r[1]) + r[2] * (p[0] * q[1] - q[0] * p[1])
    );
}
