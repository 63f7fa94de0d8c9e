
// REPLACE. For each segment a list of points with coordinates that are multiples of `side`. This rounds ends and
// crossings, one by one.
function snap2d({ segments, side }) {
    const rounded = (point) => point.map((x) => Math.round(x / side) * side);
    return segments.map(([a, b]) => [a, ...crossings(a, b, segments), b].map(rounded));
}

function crossings(a, b, segments) {
    const parts = segments.flatMap(([c, d]) => {
        const sides = [turn(c, d, a), turn(c, d, b)];
        const crosses = sides[0] * sides[1] < 0 && turn(a, b, c) * turn(a, b, d) < 0;
        return crosses ? [sides[0] / (sides[0] - sides[1])] : [];
    });
    return parts.sort((p, q) => p - q).map((part) => [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])]);
}

const turn = (p, q, r) => (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
