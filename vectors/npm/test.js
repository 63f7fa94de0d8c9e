// The package `robust-predicates` on all rows about input points: it is wrong only where doubles underflow or overflow.
import assert from 'node:assert';
import { incircle, insphere, orient2d, orient3d } from 'robust-predicates';
import { double, points, sign, tasks, vectors } from './index.js';

// Its y axis points down, and its spheres are negative inside.
const predicates = { orient2d: (...x) => -orient2d(...x), orient3d, incircle, insphere: (...x) => -insphere(...x) };
let asked = 0;
let wrong = 0;
for (const row of vectors()) {
  const args = points(row);
  if (!args || !predicates[row.predicate] || (row.predicate === 'orient2d' && args[0].length !== 2)) continue;
  asked += 1;
  const value = predicates[row.predicate](...args.flat());
  if (Number.isNaN(value) || Math.sign(value) !== sign(row)) {
    wrong += 1;
    const excluded = row.flags.includes('underflow') || row.flags.includes('overflow');
    assert(excluded, `${row.id}: ${row.predicate} says ${value}, the truth is ${row.doubles}: ${row.flags}`);
  }
}
assert.strictEqual(double('-0x1p-1074'), -5e-324);
console.log(`robust-predicates: ${wrong} of ${asked} wrong`);
assert(asked > 15000 && wrong > 0);

// Hulls by the monotone chain on exact turns: the same vertices as in the rows, in either direction.
const coordinates = (row) => row.question.points.map(double);
let hulls = 0;
for (const row of tasks().filter((row) => row.task === 'hull2d')) {
  const flat = coordinates(row);
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
