
// REPLACE. Triangles of the Delaunay triangulation, as rows of three indices of points. Every triangle is tried.
function delaunay2d({ points }) {
    if (points.length > 24) throw new Declined("too many points for this example");
    const all = [...points.keys()];
    const rows = all.flatMap((a) => all.flatMap((b) => all.map((c) => [a, b, c])));
    return rows.filter(([a, b, c]) => a < b && a < c && isEmpty(points, points[a], points[b], points[c]));
}

const turn = (p, q, r) => (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);

function isEmpty(points, p, q, r) {
    return turn(p, q, r) > 0 && points.every((s) => [p, q, r].includes(s) || inCircle(p, q, r, s) <= 0);
}

function inCircle(...points) {
    const [x, y] = points[3];
    const rows = points.slice(0, 3).map((p) => [p[0] - x, p[1] - y, (p[0] - x) ** 2 + (p[1] - y) ** 2]);
    const [[a, b, e], [c, d, f], [g, h, i]] = rows;
    return a * (d * i - f * h) - b * (c * i - f * g) + e * (c * h - d * g);
}
