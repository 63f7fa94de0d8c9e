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
  return row.vertices.map((vertex) => row.decimal[vertex].map(Number));
}

/** The exact sign about the doubles: -1, 0 or 1. */
export const sign = (row) => '-0+'.indexOf(row.doubles) - 1;
