// The rows by whole numbers, and the package `robust-predicates`, which is wrong only where doubles underflow or overflow.
import assert from 'node:assert';
import { points, sign, tasks, vectors } from './index.js';

const rows = vectors();
const flat = rows.filter((row) => row.predicate === 'orient2d' && !row.plane && points(row));

/** A double as a whole number times 2^-1074. */
function whole(x) {
  const bits = new BigUint64Array(new Float64Array([Math.abs(x)]).buffer)[0];
  const exponent = bits >> 52n;
  const mantissa = exponent ? ((bits & ((1n << 52n) - 1n)) | (1n << 52n)) << (exponent - 1n) : bits;
  return x < 0 ? -mantissa : mantissa;
}

/** Rows of turns whose signs are not those of whole numbers. */
const wrong = (rows) =>
  rows.filter((row) => {
    const [[ax, ay], [bx, by], [cx, cy]] = points(row).map((point) => point.map(whole));
    const turn = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
    return (turn > 0n) - (turn < 0n) !== sign(row);
  });
assert.deepStrictEqual(wrong(flat.filter((_, at) => at % 5 === 0)), []);
const plain = flat.find((row) => row.doubles === '+');
assert.strictEqual(wrong([{ ...plain, doubles: '-' }]).length, 1, 'a corrupted row is noticed');
console.log('signs of whole numbers: ok');

const peer = await import('robust-predicates').catch(() => null);
if (!peer) {
  console.log('NOT RUN: robust-predicates is missing; type `npm install` in vectors/npm');
  process.exit(0);
}
const { incircle, insphere, orient2d, orient3d } = peer;
// Its y axis points down, and its spheres are negative inside.
const predicates = { orient2d: (...x) => -orient2d(...x), orient3d, incircle, insphere: (...x) => -insphere(...x) };
const asked = rows.filter((row) => points(row) && predicates[row.predicate] && !row.plane);
const errs = asked.filter((row) => Math.sign(predicates[row.predicate](...points(row).flat())) !== sign(row));
for (const row of errs) {
  assert(row.flags.includes('underflow') || row.flags.includes('overflow'), `${row.id}: ${row.predicate}: ${row.flags}`);
}
console.log(`robust-predicates: ${errs.length} of ${asked.length} wrong`);
assert(asked.length > 15000 && errs.length > 0);

// Hulls by the monotone chain on exact turns: the same vertices as in the rows, in either direction.
let hulls = 0;
for (const row of tasks().filter((row) => row.task === 'hull2d')) {
  const flat = row.decimal.points.map(Number);
  const all = flat.map((_, i) => i).filter((i) => 2 * i < flat.length).map((i) => [flat[2 * i], flat[2 * i + 1]]);
  const sorted = all.toSorted((p, q) => p[0] - q[0] || p[1] - q[1]);
  const half = (points) => {
    const chain = [];
    for (const p of points) {
      while (chain.length > 1 && predicates.orient2d(...chain.at(-2), ...chain.at(-1), ...p) <= 0) chain.pop();
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  const corners = new Set([...half(sorted), ...half(sorted.toReversed())].map(String));
  const expected = new Set(row.doubles.hull.map((i) => String(all[i])));
  assert.deepStrictEqual(corners, expected, row.id);
  hulls += 1;
}
assert(hulls > 50);
