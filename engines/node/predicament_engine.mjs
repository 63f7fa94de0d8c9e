// Predicates in JavaScript for the tool predicament. One file, with Node as its only dependency.
//
// Write an object with your predicates, and call `serve`:
//
//     import { serve } from "../node/predicament_engine.mjs";
//
//     serve({
//         name: "mine",
//         version: "1.0",
//         zero: "exact",              // or "never": ties are broken
//         orient2d: (a, b, c) => …    // a number: its sign counts, and it may be a NaN. undefined declines the query
//     });
//
// Predicates: compare(axis, a, b) (axis 0, 1 or 2), orient2d(a, b, c), orient3d(a, b, c, d), incircle(a, b, c, d),
// insphere(a, b, c, d, e). Predicates that the object lacks are declined. a, b, … are arrays of coordinates, or the objects
// that `prepare` returned for the points. Signs are those of docs/ENGINES.md.
//
// Optional: prepare(points, dimension), called before the first batch of a scene, and again whenever predicates get other
// points (orient2d in a plane of a scene in space gets projected points). It may return an array with one object for each
// point, which predicates get instead. precision: "f32" for predicates that round coordinates to singles. Throw `Declined`
// if a scene is not for this engine.
//
// Whole tasks: a member `tasks` with a function for each task. It gets one object and the tool judges what it returns:
//
//     serve({ name: "mine", version: "1.0", tasks: { delaunay2d: ({ points }) => library.triangulate(points) } });
//
//     delaunay2d({ points })                 indices of the triangles' corners; flat or in rows of three, as all indices
//     hull2d({ points })                     the indices of the hull's corners, one after the other
//     hull3d({ points })                     triangles
//     triangulate({ points, rings })         the triangles of one polygon; rings of indices, in any order
//     overlay2d({ first, second })           { union, intersection, difference, "symmetric-difference" }, or some of these.
//                                            Operands are lists of rings of points; results are lists of polygons, each a
//                                            list of rings, the outer one first
//     "polygon-locate"({ regions, probes })  a label for each probe: the number of its region, -1 outside, -2 on a border;
//                                            a region is a list of rings of points
//     "mesh-locate"({ vertices, triangles, probes })   a label for each probe: 1 inside, 0 outside, -2 on the surface
//     "mesh-rays"({ vertices, triangles, rays, extent })   for each ray the triangles that it hits, in their order along it; a
//                                            ray is a pair of points, and the extent "line", "ray" or "segment"
//     distance({ points, a, b })             the distance of two objects, 0 if they have a common point: `a` and `b` are loops of
//                                            indices in the plane, and triangles in space
//     "mesh-intersect"({ first, second })    as overlay2d, of meshes { vertices, triangles }
//     contacts2d({ points, a, b })           pairs of simplices that meet, each with the indices of both; `a` and `b` are lists
//                                            of simplices by the indices of their points. contacts3d is alike
//     crossings({ segments })                for each segment the numbers of those that cross it, in their order along it; a
//                                            segment is a pair of points
//     interval({ cells, probes })            a label for each probe: the number of its cell, -1 outside, -2 at an end; a cell is
//                                            a pair of numbers, and a probe a number
//     "cube-union"({ cubes })                { volume, area } and, if you like, edge_length; a cube has x, y and z of its lower
//                                            corner and the length of its edges
//     slice({ vertices, triangles, planes }) the parts of a closed mesh, as meshes; a plane is three points
//     snap2d({ segments, side })             for each segment a list of points with coordinates that are multiples of `side`
//
// The object also has `constraints` (delaunay2d: pairs of indices), `rule` (overlay2d: "even-odd" or "non-zero"), `sides`
// (mesh-locate: the regions before and behind each triangle) and `tetrahedra` (mesh-locate). If a scene has constraints,
// sides or tetrahedra and the function does not read them, the scene is declined. Only the function is timed.

import fs from "node:fs";

const ARITY = { compare: 2, orient2d: 3, orient3d: 4, incircle: 4, insphere: 5 };
const DIMENSION = { orient3d: 3, incircle: 2, insphere: 3 };
const PLANES = { xy: [0, 1], yz: [1, 2], zx: [2, 0] };
const LONGEST = 2 ** 30;

/** The exception for a scene or batch that is not for this engine, with the reason. */
export class Declined extends Error {}

/** The exception for input that breaks the protocol. */
class Malformed extends Error {}

/** The low corner of the bounding box of points, then the high corner with its sign changed. */
const extent = (points) => [0, 1, 0, 1].map((axis, i) => points.reduce((least, p) => Math.min(least, i < 2 ? p[axis] : -p[axis]), Infinity));

/** True if a point is in a ring of points, in plain doubles. */
const isIn = (ring, [x, y]) =>
    ring.filter(([ax, ay], i) => {
        const [bx, by] = ring[(i + 1) % ring.length];
        return ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax);
    }).length % 2 === 1;

/**
 * The rings of a polygon of `triangulate`, the outer one first, for libraries that want an outer ring and holes. Declines other
 * nests: a ring that is not in the first one's box, or a hole with most of another hole's points inside.
 */
export function outerFirst(rings, points) {
    const placed = rings.map((ring) => ring.map((v) => points[v]));
    const boxes = placed.map(extent);
    const holds = (one, other) => one === other || boxes[one].every((x, i) => x <= boxes[other][i]);
    const all = [...rings.keys()];
    const outer = all.find((one) => all.every((other) => holds(one, other)));
    const isNested = (one, other) =>
        one !== other && holds(one, other) && 2 * placed[other].filter((p) => isIn(placed[one], p)).length > placed[other].length;
    const holes = all.filter((one) => one !== outer);
    if (outer === undefined || holes.some((one) => holes.some((other) => isNested(one, other))))
        throw new Declined("the rings are not an outer ring with holes");
    return [outer, ...holes].map((one) => rings[one]);
}

/** Answers the tool as `engine` until stdin ends; with --version, prints its version. Ends the program. */
export function serve(engine) {
    const args = process.argv.slice(2);
    if (args.length === 1 && args[0] === "--version") {
        write(Buffer.from(`${engine.version}\n`));
        process.exit(0);
    }
    if (args.length > 0) {
        console.error(`usage: ${process.argv[1]} [--version]; without it, an engine on stdin and stdout`);
        process.exit(2);
    }
    // Output of a library goes to stderr.
    console.log = console.info = console.debug = console.error;
    process.stdout.write = process.stderr.write.bind(process.stderr);
    const server = new Server(engine);
    try {
        for (let question = read(); question !== null; question = read()) {
            const answer = server.answer(question);
            if (question.has("id")) answer.id = question.get("id"); // the number of the question
            write(encoded(answer));
        }
    } catch (problem) {
        if (!(problem instanceof Malformed) && problem.syscall === undefined) throw problem;
        console.error(`engine: ${problem.message}`);
        process.exit(2);
    }
    process.exit(0);
}

/** Repeats `call` while the pipe is not ready. */
function patiently(call) {
    for (;;) {
        try {
            return call();
        } catch (problem) {
            if (problem.code === "EOF") return 0;
            if (problem.code !== "EAGAIN") throw problem;
            Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 1);
        }
    }
}

function write(bytes) {
    for (let done = 0; done < bytes.length; ) done += patiently(() => fs.writeSync(1, bytes, done));
}

/** Up to `count` bytes of stdin; fewer only at its end. Memory grows with the bytes that arrive. */
function readBytes(count) {
    const pieces = [];
    for (let missing = count; missing > 0; ) {
        const piece = Buffer.alloc(Math.min(missing, 1 << 20));
        const got = patiently(() => fs.readSync(0, piece, 0, piece.length, null));
        if (got === 0) break;
        pieces.push(piece.subarray(0, got));
        missing -= got;
    }
    return Buffer.concat(pieces);
}

/** The next message as a map of buffers; null if stdin ends before its first byte. */
function read() {
    const length = readBytes(4);
    if (length.length === 0) return null;
    if (length.length < 4) throw new Malformed("stdin ends within the length of a message");
    const size = length.readUInt32LE(0);
    if (size > LONGEST) throw new Malformed(`a message of ${size} bytes; the longest has 2^30`);
    const body = readBytes(size);
    if (body.length < size) throw new Malformed("stdin ends within a message");
    const entries = new Map();
    for (let at = 0; at < size; ) {
        const keyEnd = at + 1 + body[at];
        if (size < keyEnd + 4) throw new Malformed("a key runs over the end of its message");
        const key = body.toString("latin1", at + 1, keyEnd);
        at = keyEnd + 4 + body.readUInt32LE(keyEnd);
        if (size < at) throw new Malformed("a value runs over the end of its message");
        if (entries.size === 0 && key !== "type") break;
        if (!entries.has(key)) entries.set(key, body.subarray(keyEnd + 4, at));
    }
    if (entries.size === 0) throw new Malformed("a message whose first key is not `type`");
    return entries;
}

/** The bytes of a message. */
function encoded(entries) {
    const pieces = [Buffer.alloc(4)];
    for (const [key, value] of Object.entries(entries)) {
        const bytes = Buffer.isBuffer(value) ? value : Buffer.from(String(value));
        const head = Buffer.alloc(1 + key.length + 4);
        head[0] = key.length;
        head.write(key, 1, "latin1");
        head.writeUInt32LE(bytes.length, 1 + key.length);
        pieces.push(head, bytes);
    }
    const whole = Buffer.concat(pieces);
    whole.writeUInt32LE(whole.length - 4, 0);
    return whole;
}

/** The value of a required key. */
function need(entries, key) {
    if (!entries.has(key)) throw new Malformed(`a message \`${entries.get("type")}\` without \`${key}\``);
    return entries.get(key);
}

/** The byte of a sign. */
function encode(value) {
    return value > 0 ? 1 : value < 0 ? 255 : value === undefined ? 2 : value === value ? 0 : 3;
}

/** Calls `f` for each query and writes a byte for each, for each number of vertices. Only these loops are timed. */
const EACH = {
    2(f, o, ids, signs) {
        for (let q = 0, i = 0; q < signs.length; q += 1, i += 2) signs[q] = encode(f(o[ids[i]], o[ids[i + 1]]));
    },
    3(f, o, ids, signs) {
        for (let q = 0, i = 0; q < signs.length; q += 1, i += 3)
            signs[q] = encode(f(o[ids[i]], o[ids[i + 1]], o[ids[i + 2]]));
    },
    4(f, o, ids, signs) {
        for (let q = 0, i = 0; q < signs.length; q += 1, i += 4)
            signs[q] = encode(f(o[ids[i]], o[ids[i + 1]], o[ids[i + 2]], o[ids[i + 3]]));
    },
    5(f, o, ids, signs) {
        for (let q = 0, i = 0; q < signs.length; q += 1, i += 5)
            signs[q] = encode(f(o[ids[i]], o[ids[i + 1]], o[ids[i + 2]], o[ids[i + 3]], o[ids[i + 4]]));
    },
};

/** The values in rows of so many. */
function rows(values, width) {
    return Array.from({ length: values.length / width }, (_, row) => values.slice(row * width, (row + 1) * width));
}

/** The scene of a task: its arrays by name. */
class Asked {
    constructor(entries) {
        this.entries = entries;
        this.dimension = Number(need(entries, "dimension"));
        this.points = rows(this.values("points"), this.dimension);
    }

    /** True if the scene has such an array, and it is not empty. */
    has(name) {
        return [`ids:${name}`, `numbers:${name}`].some((key) => this.entries.get(key)?.length > 0);
    }

    values(name) {
        const [ids, numbers] = [this.entries.get(`ids:${name}`), this.entries.get(`numbers:${name}`)];
        if (ids !== undefined) return Array.from({ length: ids.length / 4 }, (_, i) => ids.readUInt32LE(4 * i));
        const count = numbers === undefined ? 0 : numbers.length / 8;
        return Array.from({ length: count }, (_, i) => numbers.readDoubleLE(8 * i));
    }

    parts(name) {
        const [values, starts] = [this.values(name), this.values(`${name}.starts`)];
        return starts.slice(1).map((end, i) => values.slice(starts[i], end));
    }

    at(rings) {
        return rings.map((ring) => ring.map((id) => this.points[id]));
    }

    /** The rings of each polygon. Without `regions`, all loops are one polygon of `triangulate`, and one region each else. */
    polygons(isOne) {
        const [loops, labels] = [this.parts("loops"), this.parts("regions")];
        const polygons = [];
        loops.forEach((ring, i) => (polygons[this.has("regions") ? labels[i][0] : isOne ? 0 : i] ??= []).push(ring));
        return Array.from(polygons, (rings) => rings ?? []);
    }

    /** A mesh with its own vertices. */
    mesh(name) {
        const triangles = rows(this.values(name), 3);
        const used = [...new Set(triangles.flat())].sort((a, b) => a - b);
        const place = new Map(used.map((id, at) => [id, at]));
        return { vertices: used.map((id) => this.points[id]), triangles: triangles.map((t) => t.map((id) => place.get(id))) };
    }
}

/** The simplices of a complex, by the indices of their points. */
const complex = (scene, name) => [
    ...scene.values(`${name}.vertices`).map((v) => [v]),
    ...["edges", "triangles", "tetrahedra"].flatMap((kind) => scene.parts(`${name}.${kind}`)),
];
const contacts = (scene) => [{ points: scene.points, a: complex(scene, "a"), b: complex(scene, "b") }];

/** The parameters of a task's calls. */
const GIVEN = {
    contacts2d: contacts,
    contacts3d: contacts,
    crossings: (scene) => [{ segments: scene.at(scene.parts("segments")) }],
    interval: (scene) => {
        const axis = "xyz".indexOf(String(scene.entries.get("word:axis") ?? "x"));
        const along = (ids) => ids.map((id) => scene.points[id][axis]);
        return [{ cells: scene.parts("cells").map(along), probes: along(scene.values("probes")) }];
    },
    "cube-union": (scene) => [{ cubes: rows(scene.values("cubes"), 4) }],
    slice: (scene) => [{ ...scene.mesh("triangles"), planes: scene.at(scene.parts("planes")) }],
    snap2d: (scene) => [
        { segments: scene.at(scene.parts("segments")), side: 2 ** -Number(scene.entries.get("word:pixel") ?? 0) },
    ],
    delaunay2d: (scene) => [
        { points: scene.points, ...(scene.has("constraints") && { constraints: rows(scene.values("constraints"), 2) }) },
    ],
    hull2d: ({ points }) => [{ points }],
    hull3d: ({ points }) => [{ points }],
    triangulate: (scene) => scene.polygons(true).map((rings) => ({ points: scene.points, rings })),
    overlay2d: (scene) => {
        const [first, second] = ["first", "second"].map((name) => scene.at(scene.parts(name)));
        return [{ first, second, rule: String(scene.entries.get("word:rule") ?? "even-odd") }];
    },
    "polygon-locate": (scene) => [
        { regions: scene.polygons(false).map((rings) => scene.at(rings)), probes: rows(scene.values("probes"), 2) },
    ],
    "mesh-locate": (scene) => {
        const [name, width] = scene.has("tetrahedra") ? ["tetrahedra", 4] : ["triangles", 3];
        const given = { vertices: scene.points, [name]: rows(scene.values(name), width), probes: rows(scene.values("probes"), 3) };
        if (scene.has("regions")) given.sides = rows(scene.values("regions"), 2);
        return [given];
    },
    "mesh-rays": (scene) => [
        {
            vertices: scene.points,
            triangles: rows(scene.values("triangles"), 3),
            rays: rows(scene.values("rays"), 6).map((ray) => [ray.slice(0, 3), ray.slice(3)]),
            extent: String(scene.entries.get("word:extent") ?? "ray"),
        },
    ],
    distance: (scene) => [{ points: scene.points, a: scene.parts("from"), b: scene.parts("to") }],
    "mesh-intersect": (scene) => {
        if (scene.has("first_regions") || scene.has("second_regions")) throw new Declined("the meshes have several regions");
        return [{ first: scene.mesh("first"), second: scene.mesh("second") }];
    },
};

function ids(values) {
    const bytes = Buffer.alloc(4 * values.length);
    values.forEach((value, i) => bytes.writeUInt32LE(Number(value) >>> 0, 4 * i));
    return bytes;
}

function numbers(values) {
    const bytes = Buffer.alloc(8 * values.length);
    values.forEach((value, i) => bytes.writeDoubleLE(value, 8 * i));
    return bytes;
}

/** All numbers of nested arrays. */
function flat(values) {
    return Array.from(values).flatMap((value) => (typeof value === "object" ? flat(value) : [value]));
}

/** Where each of the items starts, with the total at the end. */
function starts(items) {
    let total = 0;
    return ids([0, ...items.map((item) => (total += item.length))]);
}

const triangles = ([answer]) => ({ "ids:triangles": ids(flat(answer)) });
const labels = ([answer]) => ({ "ids:labels": ids(flat(answer)) });

/** Lists of indices of different lengths. */
const lists = (name) => ([answer]) => {
    const all = Array.from(answer, flat);
    return { [`ids:${name}`]: ids(all.flat()), [`ids:${name}.starts`]: starts(all) };
};

/** The arrays of a task's answers. */
const MADE = {
    contacts2d: lists("pairs"),
    contacts3d: lists("pairs"),
    crossings: lists("crossings"),
    interval: labels,
    "cube-union": ([answer]) =>
        Object.fromEntries(Object.entries(answer).map(([name, number]) => [`numbers:${name}`, numbers([number])])),
    slice: ([parts]) => {
        const [vertices, triangles] = [[], []];
        for (const part of parts) {
            const first = vertices.length;
            triangles.push(part.triangles.map((triangle) => flat(triangle).map((id) => id + first)));
            vertices.push(...part.vertices);
        }
        return {
            "numbers:parts.vertices": numbers(flat(vertices)),
            "ids:parts.triangles": ids(flat(triangles)),
            "ids:parts.starts": starts(triangles),
        };
    },
    snap2d: ([lines]) => ({ "numbers:chains": numbers(flat(lines)), "ids:chains.starts": starts(lines) }),
    delaunay2d: triangles,
    hull2d: ([answer]) => ({ "ids:hull": ids(flat(answer)) }),
    hull3d: triangles,
    triangulate: (answers) => {
        const all = answers.map(flat);
        return { "ids:triangles": ids(all.flat()), "ids:polygons": ids(all.flatMap((one, at) => Array(one.length / 3).fill(at))) };
    },
    overlay2d: ([answer]) => {
        const arrays = {};
        for (const [name, polygons] of Object.entries(answer)) {
            const rings = polygons.flat();
            arrays[`numbers:${name}`] = numbers(flat(rings));
            arrays[`ids:${name}.starts`] = starts(rings);
            arrays[`ids:${name}.polygons`] = starts(polygons);
        }
        return arrays;
    },
    "polygon-locate": labels,
    "mesh-locate": labels,
    "mesh-rays": lists("hits"),
    distance: ([answer]) => ({ "numbers:distance": numbers([answer]) }),
    "mesh-intersect": ([answer]) => {
        const arrays = {};
        for (const [name, mesh] of Object.entries(answer)) {
            arrays[`numbers:${name}.vertices`] = numbers(flat(mesh.vertices));
            arrays[`ids:${name}.triangles`] = ids(flat(mesh.triangles));
        }
        return arrays;
    },
};

/** The parameters of a call, and a function that declines the scene if the call has not read those that matter. */
function watched(parameters) {
    const unread = new Set(["constraints", "sides", "tetrahedra"].filter((name) => name in parameters));
    const get = (target, name) => (unread.delete(name), target[name]);
    const check = () => {
        for (const name of unread) throw new Declined(`the scene has ${name}, and the function does not take them`);
    };
    return [unread.size === 0 ? parameters : new Proxy(parameters, { get }), check];
}

/** An engine and its scene. */
class Server {
    constructor(engine) {
        this.engine = engine;
        this.names = Object.keys(ARITY).filter((name) => typeof engine[name] === "function");
        this.tasks = Object.keys(engine.tasks ?? {});
        const unknown = this.tasks.find((name) => !Object.hasOwn(GIVEN, name));
        if (unknown !== undefined) throw new Error(`\`${unknown}\` is none of the tasks ${Object.keys(GIVEN).join(", ")}`);
        if (this.names.length + this.tasks.length === 0)
            throw new Error(`the engine has no task, and none of ${Object.keys(ARITY).join(", ")}`);
        this.dimension = 0;
        this.points = [];
        this.view = null;
        this.objects = [];
    }

    /** The answer, without the number of its question. */
    answer(entries) {
        const type = String(entries.get("type"));
        try {
            if (type === "hello") return this.hello(entries);
            if (type === "scene") return this.scene(entries);
            if (type === "batch") return this.batch(entries);
            if (type === "task") return this.task(entries);
            return { type: "error", message: `unknown message \`${type}\`` };
        } catch (problem) {
            if (problem instanceof Malformed) throw problem;
            if (problem instanceof Declined) return { type: "declined", reason: problem.message };
            console.error(problem);
            return { type: "error", message: String(problem) };
        }
    }

    hello(entries) {
        const protocol = String(need(entries, "protocol"));
        if (protocol !== "1") throw new Declined(`this engine speaks protocol 1, not ${protocol}`);
        const { name, version, zero = "exact", precision = "f64" } = this.engine;
        const [predicates, tasks] = [this.names.join(" "), this.tasks.join(" ")];
        return { type: "hello", protocol: 1, name, version, predicates, tasks, zero, precision };
    }

    scene(entries) {
        const dimension = String(need(entries, "dimension"));
        if (dimension !== "2" && dimension !== "3") throw new Malformed(`dimension \`${dimension}\` is neither 2 nor 3`);
        const bytes = need(entries, "points");
        this.dimension = Number(dimension);
        const stride = 8 * this.dimension;
        if (bytes.length % stride !== 0) throw new Malformed(`points of ${bytes.length} bytes are no whole points`);
        this.points = [];
        for (let at = 0; at < bytes.length; at += stride) {
            const point = [bytes.readDoubleLE(at), bytes.readDoubleLE(at + 8)];
            if (this.dimension === 3) point.push(bytes.readDoubleLE(at + 16));
            this.points.push(point);
        }
        this.view = null;
        const start = process.hrtime.bigint();
        this.look("scene");
        return { type: "ready", ns: process.hrtime.bigint() - start };
    }

    /** Prepares the engine for the points of `view`: the scene or one of its planes. */
    look(view) {
        if (this.view === view) return;
        this.view = null;
        const axes = PLANES[view];
        const points = axes === undefined ? this.points : this.points.map((p) => [p[axes[0]], p[axes[1]]]);
        const made = this.engine.prepare?.(points, axes === undefined ? this.dimension : 2);
        this.objects = made ?? points;
        this.view = view;
    }

    batch(entries) {
        if (this.dimension === 0) throw new Malformed("a batch before any scene");
        const name = String(need(entries, "predicate"));
        if (!this.names.includes(name)) throw new Declined(`this engine has no \`${name}\``);
        if ((DIMENSION[name] ?? this.dimension) !== this.dimension)
            throw new Declined(`${name} is about points of dimension ${DIMENSION[name]}`);
        let view = "scene";
        let ask = this.engine[name].bind(this.engine);
        if (name === "compare") {
            const axis = ["x", "y", "z"].slice(0, this.dimension).indexOf(String(need(entries, "axis")));
            if (axis < 0) throw new Malformed(`\`${need(entries, "axis")}\` is no axis of the scene`);
            ask = (a, b) => this.engine.compare(axis, a, b);
        }
        if (name === "orient2d") {
            const plane = String(entries.get("plane") ?? "xy");
            if (!Object.hasOwn(PLANES, plane) || (this.dimension === 2 && plane !== "xy"))
                throw new Malformed(`\`${plane}\` is no plane of the scene`);
            if (this.dimension === 3) view = plane;
        }
        if (String(entries.get("empty")) === "1") ask = () => 0;
        const ids = this.ids(need(entries, "ids"), name);
        this.look(view);
        const signs = Buffer.alloc(ids.length / ARITY[name]);
        const start = process.hrtime.bigint();
        EACH[ARITY[name]](ask, this.objects, ids, signs);
        const ns = process.hrtime.bigint() - start;
        return { type: "signs", ns, signs };
    }

    task(entries) {
        const name = String(need(entries, "task"));
        if (!this.tasks.includes(name)) throw new Declined(`this engine has no \`${name}\``);
        const calls = GIVEN[name](new Asked(entries)).map(watched);
        const answers = [];
        const start = process.hrtime.bigint();
        for (const [parameters] of calls) answers.push(this.engine.tasks[name](parameters));
        const ns = process.hrtime.bigint() - start;
        for (const [, check] of calls) check();
        if (answers.some((answer) => answer === undefined || answer === null)) throw new Declined("the library gives no answer");
        return { type: "answer", ns, bytes: process.resourceUsage().maxRSS * 1024, ...MADE[name](answers) };
    }

    ids(bytes, name) {
        if (bytes.length % (4 * ARITY[name]) !== 0)
            throw new Malformed(`ids of ${bytes.length} bytes are no whole queries of ${name}`);
        const ids = new Uint32Array(bytes.length / 4);
        for (let i = 0; i < ids.length; i += 1) {
            ids[i] = bytes.readUInt32LE(4 * i);
            if (ids[i] >= this.points.length) throw new Malformed(`vertex ${ids[i]} of a scene of ${this.points.length}`);
        }
        return ids;
    }
}
