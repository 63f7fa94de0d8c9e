// 20,000 queries of geometric predicates with their exact signs; docs/VECTORS.md describes the rows.
import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';

/** All rows. */
export function vectors(name = 'vectors.json.gz') {
  const packed = readFileSync(new URL(name, import.meta.url));
  return JSON.parse(gunzipSync(packed).toString('utf8')).rows;
}

/** Whole scenes of tasks. */
export const tasks = () => vectors('tasks.json.gz');

/** The arguments of the predicate, as arrays of doubles in order; null if a vertex is constructed. */
export function points(row) {
  if (row.vertices.some((vertex) => vertex.startsWith('c'))) return null;
  return row.vertices.map((vertex) => row.hex[vertex].map(double));
}

/** The exact sign about the doubles: -1, 0 or 1. */
export const sign = (row) => '-0+'.indexOf(row.doubles) - 1;

/** The double of a hex float as in C: at most 53 bits, so that no step rounds. */
export function double(text) {
  const [, minus, whole, fraction = '', exponent] = /^(-?)0x([0-9a-f]+)(?:\.([0-9a-f]*))?p([+-]?\d+)$/.exec(text);
  const power = Number(exponent) - 4 * fraction.length;
  const half = Math.trunc(power / 2);
  const x = Number(BigInt(`0x${whole}${fraction}`)) * 2 ** half * 2 ** (power - half);
  return minus ? -x : x;
}
