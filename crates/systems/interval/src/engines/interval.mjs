
// REPLACE. For each probe the number of its cell, -1 outside of all, -2 at an end. Cells are pairs of numbers.
function interval({ cells, probes }) {
    const locate = (probe) => cells.findIndex(([left, right]) => left < probe && probe < right);
    return probes.map((probe) => (cells.some((cell) => cell.includes(probe)) ? -2 : locate(probe)));
}
