
// REPLACE. The indices of the hull's corners, one after the other. This is Andrew's monotone chain.
function hull2d({ points }) {
    const order = [...points.keys()].sort((a, b) => points[a][0] - points[b][0] || points[a][1] - points[b][1]);
    if (order.length < 2) return order;
    return [...chain(points, order).slice(0, -1), ...chain(points, [...order].reverse()).slice(0, -1)];
}

function chain(points, order) {
    const found = [];
    for (const at of order) {
        while (found.length > 1 && turn(points[found.at(-2)], points[found.at(-1)], points[at]) <= 0) found.pop();
        found.push(at);
    }
    return found;
}

const turn = (p, q, r) => (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
