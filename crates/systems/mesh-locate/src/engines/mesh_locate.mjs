
// REPLACE. For each probe 1 inside, 0 outside, -2 on the surface. This counts the triangles above a probe.
function mesh_locate({ vertices, triangles, probes }) {
    if (triangles === undefined) throw new Declined("this example takes triangles");
    const solid = triangles.map((triangle) => triangle.map((v) => vertices[v]));
    return probes.map((probe) => solid.filter((corners) => isAbove(corners, probe)).length % 2);
}

function isAbove([a, b, c], p) {
    const turns = [turn(a, b, p), turn(b, c, p), turn(c, a, p)];
    if (!turns.every((t) => t > 0) && !turns.every((t) => t < 0)) return false;
    const sum = turns[0] + turns[1] + turns[2];
    return (turns[0] * c[2] + turns[1] * a[2] + turns[2] * b[2]) / sum > p[2];
}

const turn = (p, q, r) => (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
