
// REPLACE. Results by name: "union", "intersection", "difference", "symmetric-difference", all or some of them, as meshes.
// This puts one solid beside the other: a union if they are apart.
function mesh_intersect({ first, second }) {
    const moved = second.triangles.map((triangle) => triangle.map((v) => v + first.vertices.length));
    const vertices = [...first.vertices, ...second.vertices];
    return { union: { vertices, triangles: [...first.triangles, ...moved] } };
}
