
// REPLACE. The volume and the area of a union of cubes, and the length of its edges if you like. A cube has x, y and z of
// its lower corner and the length of its edges. This looks at each cell between the planes of all faces.
function cube_union({ cubes }) {
    if (cubes.length > 12) throw new Declined("too many cubes for this example");
    const planes = [0, 1, 2].map((axis) => {
        const all = new Set(cubes.flatMap((cube) => [cube[axis], cube[axis] + cube[3]]));
        return [...all].sort((a, b) => a - b);
    });
    const isIn = (point) => cubes.some((cube) => point.every((x, axis) => cube[axis] <= x && x < cube[axis] + cube[3]));
    const cell = (at) => at.every((i) => i >= 0) && isIn(at.map((i, axis) => planes[axis][i]));
    let [volume, area] = [0, 0];
    for (let i = 0; i + 1 < planes[0].length; i += 1)
        for (let j = 0; j + 1 < planes[1].length; j += 1)
            for (let k = 0; k + 1 < planes[2].length; k += 1) {
                if (!cell([i, j, k])) continue;
                const [a, b, c] = [i, j, k].map((at, axis) => planes[axis][at + 1] - planes[axis][at]);
                volume += a * b * c;
                // Each face on the lower side has one on the upper side.
                if (!cell([i - 1, j, k])) area += 2 * b * c;
                if (!cell([i, j - 1, k])) area += 2 * a * c;
                if (!cell([i, j, k - 1])) area += 2 * a * b;
            }
    return { volume, area };
}
