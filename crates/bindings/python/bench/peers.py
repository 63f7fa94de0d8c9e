"""The package beside its peers on the same arrays, in one run: time a query, and wrong answers.

    python bench/peers.py [--node FOLDER] [--queries N]

Peers are the packages `shewchuk`, `libigl` and `cgal` of Python, and `robust-predicates` of Node.js, whose folder
(with `node_modules`) `--node` names. A peer that can't be loaded is named below the table. The truth is the judge's.

Times are what a caller in Python pays for N queries in arrays: a loop where a peer takes one query at a time, with
points made before the time begins. `robust-predicates` is called in a loop inside Node.js, over the same numbers.
"""

import argparse
import importlib.metadata
import json
import platform
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

import predicament

FAMILIES = ["uniform", "near", "kettner", "degen", "wide-scaled"]
TIMED = ["uniform", "near"]
ROUNDS = 5
NODE = """
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";
const [folder, name, file, out, rounds, width, arity] = process.argv.slice(2);
const require = createRequire(pathToFileURL(path.join(folder, "any.js")));
const all = require("robust-predicates");
const f = all[name], step = width * arity, sign = name === "orient2d" || name === "insphere" ? -1 : 1;
const bytes = fs.readFileSync(file), x = new Float64Array(bytes.buffer, bytes.byteOffset, bytes.length / 8);
const count = x.length / step, signs = new Int8Array(count);
const calls = {
    orient2d: (i) => f(x[i], x[i + 1], x[i + 2], x[i + 3], x[i + 4], x[i + 5]),
    orient3d: (i) => f(x[i], x[i + 1], x[i + 2], x[i + 3], x[i + 4], x[i + 5], x[i + 6], x[i + 7], x[i + 8], x[i + 9],
        x[i + 10], x[i + 11]),
    incircle: (i) => f(x[i], x[i + 1], x[i + 2], x[i + 3], x[i + 4], x[i + 5], x[i + 6], x[i + 7]),
    insphere: (i) => f(x[i], x[i + 1], x[i + 2], x[i + 3], x[i + 4], x[i + 5], x[i + 6], x[i + 7], x[i + 8], x[i + 9],
        x[i + 10], x[i + 11], x[i + 12], x[i + 13], x[i + 14]),
};
const call = calls[name];
let best = Infinity;
for (let round = 0; round < rounds; round++) {
    const start = performance.now();
    for (let q = 0; q < count; q++) signs[q] = Math.sign(sign * call(q * step));
    best = Math.min(best, performance.now() - start);
}
fs.writeFileSync(out, signs);
const manifest = path.join(folder, "node_modules/robust-predicates/package.json");
console.log(JSON.stringify({ seconds: best / 1000, version: JSON.parse(fs.readFileSync(manifest, "utf8")).version }));
"""


def timed(work):
    """The least seconds of several rounds, and the result."""
    best = float("inf")
    for _ in range(ROUNDS):
        start = time.perf_counter()
        result = work()
        best = min(best, time.perf_counter() - start)
    return best, np.asarray(result)


def own(name):
    function = getattr(predicament, name)
    return lambda args: timed(lambda: function(*args))


def shewchuk(name):
    import shewchuk

    calls = {
        "orient2d": lambda a, b, c: shewchuk.orientation(*a, *b, *c),
        "incircle": lambda a, b, c, d: shewchuk.incircle_test(*d, *a, *b, *c),
    }
    return loop(calls.get(name), lambda point: point.tolist())


def igl(name):
    import igl.predicates

    function = getattr(igl.predicates, name)
    if name == "orient3d":
        return lambda args: timed(lambda: function(*args))
    return loop(lambda *points: function(*points).value, lambda point: point)


def cgal(name):
    from CGAL.CGAL_Kernel import Point_2, Point_3, orientation

    point = {"orient2d": lambda p: Point_2(*p.tolist()), "orient3d": lambda p: Point_3(*p.tolist())}.get(name)
    sign = -1 if name == "orient3d" else 1
    return loop(point and (lambda *points: sign * int(orientation(*points))), point)


def loop(call, point):
    """Asks one query at a time, about points that are made before."""
    if call is None:
        return None

    def ask(args):
        rows = [tuple(map(point, row)) for row in zip(*args)]
        return timed(lambda: [call(*row) for row in rows])

    return ask


def node(folder):
    def of(name):
        def ask(args):
            with tempfile.TemporaryDirectory() as place:
                place = Path(place)
                (place / "loop.mjs").write_text(NODE)
                np.stack(args, axis=1).tofile(place / "points")
                words = [folder, name, place / "points", place / "signs", ROUNDS, args[0].shape[1], len(args)]
                done = subprocess.run(
                    ["node", place / "loop.mjs", *map(str, words)], capture_output=True, text=True, check=True
                )
                told = json.loads(done.stdout)
                VERSIONS["robust-predicates (Node)"] = told["version"]
                return told["seconds"], np.fromfile(place / "signs", np.int8)

        return ask

    return of


VERSIONS = {"predicament": predicament.__version__}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--node", type=Path)
    parser.add_argument("--queries", type=int, default=20_000)
    options = parser.parse_args()
    missing = {}
    if not (options.node and (options.node / "node_modules" / "robust-predicates").is_dir()):
        missing["robust-predicates (Node)"] = "--node names no folder that has it"
    peers = {"predicament": own, "shewchuk": shewchuk, "libigl": igl, "cgal": cgal}
    if not missing:
        peers["robust-predicates (Node)"] = node(options.node.resolve())
    print(f"{options.queries:,} queries of each of {', '.join(FAMILIES)}; Python {platform.python_version()}\n")
    print("| predicate | package | uniform, ns a query | near, ns a query | wrong answers |")
    print("|---|---|---:|---:|---:|")
    for name in ["orient2d", "orient3d", "incircle", "insphere"]:
        cases = {family: predicament.cases(name, family=family, n=options.queries) for family in FAMILIES}
        for peer, of in peers.items():
            try:
                ask = of(name)
                VERSIONS.setdefault(peer, version(peer))
            except ImportError as error:
                missing[peer] = str(error)
                continue
            if ask is None:
                continue
            seconds, wrong = {}, {}
            for family, case in cases.items():
                args = [np.ascontiguousarray(points) for points in case.args]
                seconds[family], answers = ask(args)
                wrong[family] = len(case.wrong(np.asarray(answers, dtype=np.float64)))
            times = " | ".join(f"{1e9 * seconds[family] / options.queries:,.0f}" for family in TIMED)
            where = ", ".join(f"{count:,} of {family}" for family, count in wrong.items() if count)
            total = f"{sum(wrong.values()):,} of {len(FAMILIES) * options.queries:,}"
            print(f"| `{name}` | {peer} | {times} | {total}{f' ({where})' if where else ''} |", flush=True)
    print("\nVersions: " + ", ".join(f"{peer} {version}" for peer, version in VERSIONS.items() if version) + ".")
    for peer, why in missing.items():
        print(f"NOT RUN: {peer}: {why}")


def version(peer):
    try:
        return importlib.metadata.version(peer)
    except importlib.metadata.PackageNotFoundError:
        return ""


if __name__ == "__main__":
    main()
