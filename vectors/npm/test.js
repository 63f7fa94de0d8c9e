// The package `robust-predicates` on all rows about input points: it is wrong only where doubles underflow or overflow.
import assert from 'node:assert';
import { incircle, insphere, orient2d, orient3d } from 'robust-predicates';
import { double, points, sign, vectors } from './index.js';

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
