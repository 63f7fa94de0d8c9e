
// REPLACE. The triangles of the hull's surface, as rows of three indices of points. Every triangle is tried.
function hull3d({ points }) {
    if (points.length > 24) throw new Declined("too many points for this example");
    const all = [...points.keys()];
    const rows = all.flatMap((a) => all.flatMap((b) => all.map((c) => [a, b, c])));
    const isFace = (row) => all.every((at) => row.includes(at) || volume(...row.map((v) => points[v]), points[at]) > 0);
    return rows.filter(([a, b, c]) => a < b && a < c && b !== c && isFace([a, b, c]));
}

function volume(a, b, c, d) {
    const [p, q, r] = [a, b, c].map((point) => point.map((x, axis) => x - d[axis]));
    return (
        p[2] * (q[0] * r[1] - r[0] * q[1]) + q[2] * (r[0] * p[1] - p[0] * r[1]) + r[2] * (p[0] * q[1] - q[0] * p[1])
    );
}
