
// REPLACE. For each probe the number of its region, -1 outside of all, -2 on a border. A region is a list of rings of
// points. This counts crossings.
function polygon_locate({ regions, probes }) {
    return probes.map((probe) => regions.findIndex((rings) => isIn(rings, probe)));
}

function isIn(rings, [x, y]) {
    const edges = rings.flatMap((ring) => ring.map((a, at) => [a, ring[(at + 1) % ring.length]]));
    const crossed = edges.filter(
        ([a, b]) => a[1] > y !== b[1] > y && x < a[0] + ((y - a[1]) / (b[1] - a[1])) * (b[0] - a[0]),
    );
    return crossed.length % 2 === 1;
}
