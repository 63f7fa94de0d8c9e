
// REPLACE. The parts of a closed mesh that is cut by planes, as meshes. A plane is three points. This gives the mesh as it is
// if no plane goes through it.
function slice({ vertices, triangles, planes }) {
    for (const [a, b, c] of planes) {
        const sides = triangles.flat().map((v) => volume(a, b, c, vertices[v]));
        if (Math.min(...sides) < 0 && Math.max(...sides) > 0)
            throw new Declined("this example takes planes that miss the mesh");
    }
    return [{ vertices, triangles }];
}

function volume(a, b, c, d) {
    const [p, q, r] = [a, b, c].map((point) => point.map((x, axis) => x - d[axis]));
    return (
        p[2] * (q[0] * r[1] - r[0] * q[1]) + q[2] * (r[0] * p[1] - p[0] * r[1]) + r[2] * (p[0] * q[1] - q[0] * p[1])
    );
}
