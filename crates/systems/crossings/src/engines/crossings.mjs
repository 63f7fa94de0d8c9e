
// REPLACE. For each segment the numbers of those that cross it, in their order along it. Each pair is tried.
function crossings({ segments }) {
    return segments.map((segment) => {
        const crossed = segments.flatMap((other, at) => crossing(segment, other).map((part) => [part, at]));
        return crossed.sort((one, other) => one[0] - other[0]).map(([, at]) => at);
    });
}

/** The part of the first segment before the crossing, if there is one. */
function crossing([a, b], [c, d]) {
    const sides = [turn(c, d, a), turn(c, d, b)];
    const crosses = sides[0] * sides[1] < 0 && turn(a, b, c) * turn(a, b, d) < 0;
    return crosses ? [sides[0] / (sides[0] - sides[1])] : [];
}

const turn = (p, q, r) => (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
