
// REPLACE. Pairs of simplices that meet, each with the indices of its points. Of edges, each pair is tried.
function contacts2d({ points, a, b }) {
    if ([...a, ...b].some((simplex) => simplex.length !== 2)) throw new Declined("this example takes edges");
    const placed = (edge) => edge.map((v) => points[v]);
    return a.flatMap((s) => b.filter((t) => meet(placed(s), placed(t))).map((t) => [s, t]));
}

function meet(s, t) {
    const isApart = [0, 1].some((axis) => {
        const [one, other] = [s, t].map((edge) => edge.map((p) => p[axis]));
        return Math.max(...one) < Math.min(...other) || Math.max(...other) < Math.min(...one);
    });
    const crosses = (p, q) => turn(...p, q[0]) * turn(...p, q[1]) <= 0;
    return !isApart && crosses(s, t) && crosses(t, s);
}

const turn = (p, q, r) => (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
