"""Predicates in Python for the tool predicament. One file, standard library only.

Write a class with your predicates, and call `serve`:

    import sys
    sys.path.insert(0, "../python")
    import predicament_engine

    class Mine:
        name = "mine"
        version = "1.0"
        zero = "exact"                      # or "never": ties are broken

        def orient2d(self, a, b, c): ...    # a number: its sign counts, and it may be a NaN. None declines the query

    predicament_engine.serve(Mine())

Predicates: `compare(axis, a, b)` (axis 0, 1 or 2), `orient2d(a, b, c)`, `orient3d(a, b, c, d)`, `incircle(a, b, c, d)`,
`insphere(a, b, c, d, e)`. Predicates that the object lacks are declined. Signs are those of
docs/ENGINES.md. Each predicate has one of three forms:

    orient2d(a, b, c)           one query; a, b, c are tuples of coordinates, or what `prepare` made of the points
    orient2d_arrays(a, b, c)    all queries; a, b, c are numpy arrays with the coordinates of one vertex a row
    orient2d_ids(ids)           all queries; one row of vertex ids each, as tuples, or as a numpy array if `arrays = True`

The last two return a sequence of numbers. `compare_arrays` and `compare_ids` also get the axis, as first parameter.

Optional members:

    prepare(points, dimension)  called before the first batch of a scene, and again whenever predicates get other
                                points: orient2d in a plane of a scene in space gets projected points. `points` is
                                a list of tuples, or a numpy array if `arrays = True`. It may return a list with one
                                object for each point, which predicates of the first form get instead of tuples.
    arrays                      True if `prepare` and predicates of the last form want numpy arrays
    precision                   "f32" for predicates that round coordinates to singles
    formulas                    other predicates, as {"name": (arguments, dimension)}. The tool knows them by formula
                                (`predicament derive`). Points with weights get the weight as last coordinate

Whole tasks: an `Engine`, or a member `tasks` with a function for each task. The tool judges the answers:

    engine = predicament_engine.Engine("mine", "1.0")
    engine.task("delaunay2d", lambda points: my_library.triangulate(points))
    predicament_engine.serve(engine)

    delaunay2d(points)                      triangles, as rows of three indices
    hull2d(points)                          the indices of the hull's corners, one after the other
    hull3d(points)                          triangles
    triangulate(points, rings)              the triangles of one polygon; rings of indices, the outer one first or not
    overlay2d(first, second)                {"union": polygons, "intersection": ..., "difference": ...,
                                            "symmetric-difference": ...}, all or some of them. Operands are lists of rings
                                            of points; a polygon of the answer is a list of rings, the outer one first
    polygon-locate(regions, probes)         a label for each probe: the number of its region, -1 outside, -2 on a border;
                                            a region is a list of rings of points
    mesh-locate(vertices, triangles, probes)    a label for each probe: 1 inside, 0 outside, -2 on the surface
    mesh-rays(vertices, triangles, rays, extent)    for each ray the triangles that it hits, in their order along it; a ray is
                                            a pair of points, and `extent` is "line", "ray" or "segment"
    distance(points, a, b)                  the distance of two objects, 0 if they have a common point; `a` and `b` are loops of
                                            indices in the plane, and triangles in space
    mesh-intersect(first, second)           as overlay2d; an operand and an answer are pairs of vertices and triangles
    contacts2d(points, a, b)                pairs of simplices that meet, as rows of the indices of both, or as pairs; `a` and
                                            `b` are lists of simplices, each with its indices. contacts3d is alike
    crossings(segments)                     for each segment the numbers of those that cross it, in their order along it; a
                                            segment is a pair of points
    interval(cells, probes)                 a label for each probe: the number of its cell, -1 outside, -2 at an end. A cell
                                            is a pair of numbers, and a probe is a number
    cube-union(cubes)                       {"volume": ..., "area": ..., "edge_length": ...}, the last one if you like; a cube
                                            has x, y and z of its lower corner and the length of its edges
    slice(vertices, triangles, planes)      the parts of a closed mesh, as pairs of vertices and triangles; a plane is three
                                            points, and a part is on one side of each plane
    snap2d(segments, side)                  for each segment a list of points with coordinates that are multiples of `side`

A function gets the parameters that it names. It may also name `constraints` (delaunay2d: pairs of indices), `rule`
(overlay2d: "even-odd" or "non-zero"), `sides` (mesh-locate: the regions before and behind each triangle), and
`tetrahedra` (mesh-locate). A scene with one of these goes only to functions that name it. With `arrays = True`, points
and indices are numpy arrays. Only the call of the function is timed.

Raise `Declined` with a reason if a scene is not for this engine. The time of a batch includes gathering the coordinates
for the first two forms, and so does the time of the empty predicate.
"""

import array
import inspect
import itertools
import os
import struct
import sys
import time
import traceback

PREDICATES = {"compare": 2, "orient2d": 3, "orient3d": 4, "incircle": 4, "insphere": 5}
DIMENSIONS = {"orient3d": 3, "incircle": 2, "insphere": 3}
PLANES = {"xy": (0, 1), "yz": (1, 2), "zx": (2, 0)}
LONGEST = 1 << 30


class Declined(Exception):
    """The exception for a scene or batch that is not for this engine, with the reason."""


class Malformed(Exception):
    """The exception for input that breaks the protocol."""


class Engine:
    """An engine of whole tasks, for libraries without predicates of their own."""

    def __init__(self, name, version, arrays=False):
        self.name, self.version, self.arrays = name, version, arrays
        self.tasks = {}

    def task(self, name, function):
        """Answers the task by a function."""
        self.tasks[name] = function
        return self


def serve(engine):
    """Answers the tool as `engine` until stdin ends; with --version, prints its version. Ends the program."""
    if sys.argv[1:] == ["--version"]:
        print(engine.version)
        sys.exit(0)
    if sys.argv[1:]:
        sys.exit(_complain(f"usage: {sys.argv[0]} [--version]; without it, an engine on stdin and stdout"))
    # The engine's own handle for stdout. Output of a library goes to stderr instead.
    out = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    source = sys.stdin.buffer
    server = _Server(engine)
    try:
        while (message := _read(source)) is not None:
            answer = server.answer(message)
            if "id" in message:
                answer["id"] = message["id"]  # the number of the question
            out.write(_encode(answer))
            out.flush()
    except (Malformed, OSError) as problem:
        sys.exit(_complain(f"engine: {problem}"))
    sys.exit(0)


def _complain(text):
    print(text, file=sys.stderr)
    return 2


def _read(source):
    """The next message as a dictionary of bytes; None if stdin ends before its first byte."""
    length = source.read(4)
    if not length:
        return None
    if len(length) < 4:
        raise Malformed("stdin ends within the length of a message")
    (size,) = struct.unpack("<I", length)
    if size > LONGEST:
        raise Malformed(f"a message of {size} bytes; the longest has 2^30")
    pieces = []  # memory grows with the bytes that arrive
    missing = size
    while missing:
        piece = source.read(min(missing, 1 << 20))
        if not piece:
            raise Malformed("stdin ends within a message")
        pieces.append(piece)
        missing -= len(piece)
    return _split(b"".join(pieces))


def _split(body):
    entries = {}
    at = 0
    while at < len(body):
        key_end = at + 1 + body[at]
        if len(body) < key_end + 4:
            raise Malformed("a key runs over the end of its message")
        key = body[at + 1 : key_end].decode("ascii", "replace")
        (size,) = struct.unpack_from("<I", body, key_end)
        at = key_end + 4 + size
        if len(body) < at:
            raise Malformed("a value runs over the end of its message")
        if not entries and key != "type":
            break
        entries.setdefault(key, body[key_end + 4 : at])
    if not entries:
        raise Malformed("a message whose first key is not `type`")
    return entries


def _message(kind, **entries):
    """A message as a dictionary, its type first."""
    return {"type": kind, **entries}


def _encode(message):
    """The bytes of a message."""
    body = b""
    for key, value in message.items():
        value = value if isinstance(value, bytes) else str(value).encode()
        body += bytes([len(key)]) + key.encode() + struct.pack("<I", len(value)) + value
    return struct.pack("<I", len(body)) + body


def _numbers(code, data):
    """The little-endian numbers of `data`: doubles for code d, unsigned integers of four bytes for code I."""
    numbers = array.array(code)
    numbers.frombytes(data)
    if sys.byteorder == "big":
        numbers.byteswap()
    return numbers


def _sign(value):
    """The byte of an answer."""
    if value is None:
        return 2
    return 1 if value > 0 else 255 if value < 0 else 0 if value == 0 else 3


class _Server:
    """An engine and its scene."""

    def __init__(self, engine):
        self.engine = engine
        self.forms = {}
        formulas = getattr(engine, "formulas", {})
        self.takes = {**PREDICATES, **{name: arity for name, (arity, _) in formulas.items()}}
        self.dimensions = {**DIMENSIONS, **{name: dimension for name, (_, dimension) in formulas.items()}}
        self.formulas = formulas
        for name in self.takes:
            for form in ("", "_arrays", "_ids"):
                if callable(getattr(engine, name + form, None)):
                    self.forms[name] = form
        self.tasks = getattr(engine, "tasks", {})
        if not self.forms and not self.tasks:
            raise TypeError("the engine has no task, and none of the predicates " + ", ".join(self.takes))
        unknown = [name for name in self.tasks if name not in TASKS]
        if unknown:
            raise TypeError(f"`{unknown[0]}` is none of the tasks " + ", ".join(TASKS))
        self.numpy = None
        if getattr(engine, "arrays", False) or "_arrays" in self.forms.values():
            import numpy

            self.numpy = numpy
        self.dimension = 0
        self.points = self.seen = self.objects = self.weights = []
        self.view = None

    def answer(self, message):
        """The answer, without the number of its question."""
        kind = message["type"].decode("ascii", "replace")
        answers = {"hello": self.hello, "scene": self.scene, "batch": self.batch, "task": self.task}
        try:
            if kind not in answers:
                return _message("error", message=f"unknown message `{kind}`")
            return answers[kind](message)
        except Declined as reason:
            return _message("declined", reason=reason)
        except Malformed:
            raise
        except Exception as problem:  # an exception of a predicate becomes an answer and does not end the engine
            traceback.print_exc()
            return _message("error", message=f"{type(problem).__name__}: {problem}")

    def hello(self, message):
        protocol = _need(message, "protocol")
        if protocol != "1":
            raise Declined(f"this engine speaks protocol 1, not {protocol}")
        return _message(
            "hello",
            protocol=1,
            name=self.engine.name,
            version=self.engine.version,
            predicates=" ".join(self.forms),
            tasks=" ".join(self.tasks),
            zero=getattr(self.engine, "zero", "exact"),
            precision=getattr(self.engine, "precision", "f64"),
        )

    def scene(self, message):
        dimension = _need(message, "dimension")
        if dimension not in ("2", "3"):
            raise Malformed(f"dimension `{dimension}` is neither 2 nor 3")
        points = _need(message, "points", text=False)
        self.dimension = int(dimension)
        if len(points) % (8 * self.dimension):
            raise Malformed(f"points of {len(points)} bytes are no whole points")
        numbers = _numbers("d", points)
        if self.numpy:
            self.points = self.numpy.array(numbers, dtype="f8").reshape(-1, self.dimension)
        else:
            self.points = list(zip(*[iter(numbers)] * self.dimension))
        self.weights = _numbers("d", message.get("weights", b""))
        if self.weights and len(self.weights) != len(self.points):
            raise Malformed(f"{len(self.weights)} weights of {len(self.points)} points")
        self.view = None
        start = time.perf_counter_ns()
        self.look(None, "scene")
        return _message("ready", ns=time.perf_counter_ns() - start)

    def look(self, axes, view):
        """Prepares the engine for the points of `view`, projected on `axes`."""
        if self.view == view:
            return
        self.view = None
        if view == "weighted" and self.numpy:
            self.seen = self.numpy.column_stack([self.points, self.numpy.array(self.weights)])
        elif view == "weighted":
            self.seen = [(*point, weight) for point, weight in zip(self.points, self.weights)]
        elif axes is None:
            self.seen = self.points
        elif self.numpy:
            self.seen = self.numpy.ascontiguousarray(self.points[:, list(axes)])
        else:
            self.seen = [(point[axes[0]], point[axes[1]]) for point in self.points]
        made = None
        if hasattr(self.engine, "prepare"):
            made = self.engine.prepare(self.seen, self.dimension if axes is None else 2)
        if made is None:
            made = list(map(tuple, self.seen.tolist())) if self.numpy else self.seen
        self.objects = made
        self.view = view

    def batch(self, message):
        if not self.dimension:
            raise Malformed("a batch before any scene")
        name = _need(message, "predicate")
        if name not in self.forms:
            raise Declined(f"this engine has no `{name}`")
        if self.dimensions.get(name, self.dimension) != self.dimension:
            raise Declined(f"{name} is about points of dimension {self.dimensions[name]}")
        leading, axes, view = (), None, "weighted" if name in self.formulas and self.weights else "scene"
        if name == "compare":
            axis = _need(message, "axis")
            if axis not in ("x", "y", "z")[: self.dimension]:
                raise Malformed(f"`{axis}` is no axis of the scene")
            leading = ("xyz".index(axis),)
        if name == "orient2d":
            plane = message.get("plane", b"xy").decode("ascii", "replace")
            if plane not in PLANES or (self.dimension == 2 and plane != "xy"):
                raise Malformed(f"`{plane}` is no plane of the scene")
            if self.dimension == 3:
                axes, view = PLANES[plane], plane
        ids = self.ids(_need(message, "ids", text=False), name)
        self.look(axes, view)
        form = self.forms[name]
        empty = message.get("empty") == b"1"
        ask = self.empty(form, len(ids)) if empty else getattr(self.engine, name + form)
        answers, ns = getattr(self, "time" + form)(ask, leading, ids)
        if len(answers) != len(ids):
            raise ValueError(f"{name}{form} gave {len(answers)} answers to {len(ids)} queries")
        return _message("signs", ns=ns, signs=self.signs(answers))

    def task(self, message):
        name = _need(message, "task")
        if name not in self.tasks:
            raise Declined(f"this engine has no `{name}`")
        scene = _Scene(message, self.numpy)
        function = self.tasks[name]
        given = TASKS[name][0](scene)
        calls = [_chosen(function, parameters) for parameters in given]
        answers, start = [], time.perf_counter_ns()
        for parameters in calls:
            answers.append(function(**parameters))
        ns = time.perf_counter_ns() - start
        if any(answer is None for answer in answers):
            raise Declined("the library gives no answer")
        return {"type": "answer", "ns": ns, **_memory(), **TASKS[name][1](answers)}

    def ids(self, data, name):
        """The vertex ids, one row per query."""
        takes = self.takes[name]
        if len(data) % (4 * takes):
            raise Malformed(f"ids of {len(data)} bytes are no whole queries of {name}")
        ids = _numbers("I", data)
        if ids and max(ids) >= len(self.points):
            raise Malformed(f"vertex {max(ids)} of a scene of {len(self.points)}")
        if self.numpy and self.forms[name]:
            return self.numpy.array(ids, dtype="u4").reshape(-1, takes)
        return list(zip(*[iter(ids)] * takes))

    def empty(self, form, queries):
        """A predicate of this form that returns zeros at once."""
        if not form:
            return lambda *_: 0
        zeros = self.numpy.zeros(queries) if self.numpy else [0] * queries
        return lambda *_: zeros

    def time(self, ask, leading, ids):
        look_up = self.objects.__getitem__
        columns = [map(look_up, column) for column in zip(*ids)]
        start = time.perf_counter_ns()
        answers = list(map(ask, *map(itertools.repeat, leading), *columns)) if ids else []
        return answers, time.perf_counter_ns() - start

    def time_arrays(self, ask, leading, ids):
        columns = self.numpy.ascontiguousarray(ids.T)
        start = time.perf_counter_ns()
        answers = ask(*leading, *[self.seen[column] for column in columns])
        return answers, time.perf_counter_ns() - start

    def time_ids(self, ask, leading, ids):
        start = time.perf_counter_ns()
        answers = ask(*leading, ids)
        return answers, time.perf_counter_ns() - start

    def signs(self, answers):
        """The byte of each answer."""
        if self.numpy and isinstance(answers, self.numpy.ndarray):
            answers = answers.tolist()
        return bytes(map(_sign, answers))


def _need(message, key, text=True):
    """The value of a required key."""
    if key not in message:
        raise Malformed(f"a message `{message['type'].decode('ascii', 'replace')}` without `{key}`")
    value = message[key]
    return value.decode("ascii", "replace") if text else value


def _chosen(function, parameters):
    """The parameters that the function names; declines the scene if it has more that matter."""
    named = inspect.signature(function).parameters
    if any(one.kind is inspect.Parameter.VAR_KEYWORD for one in named.values()):
        return parameters
    for name in ("constraints", "sides", "tetrahedra"):
        if name in parameters and name not in named:
            raise Declined(f"the scene has {name}, and the function does not take them")
    return {name: value for name, value in parameters.items() if name in named}


def _memory():
    """The most memory that this process has had."""
    try:
        import resource
    except ImportError:
        return {}
    unit = 1 if sys.platform == "darwin" else 1024
    return {"bytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit}


class _Scene:
    """The scene of a task: its arrays by name."""

    def __init__(self, message, numpy):
        self.message, self.numpy = message, numpy
        self.dimension = int(_need(message, "dimension"))
        self.points = self.rows("points", self.dimension)

    def has(self, name):
        """True if the scene has such an array, and it is not empty."""
        return bool(self.message.get(f"ids:{name}") or self.message.get(f"numbers:{name}"))

    def word(self, name, otherwise):
        return self.message.get(f"word:{name}", otherwise.encode()).decode("ascii", "replace")

    def numbers(self, name):
        code, kind = ("I", "ids") if f"ids:{name}" in self.message else ("d", "numbers")
        return _numbers(code, self.message.get(f"{kind}:{name}", b""))

    def rows(self, name, width):
        """Rows of equal width."""
        numbers = self.numbers(name)
        if self.numpy:
            kind = "f8" if numbers.typecode == "d" else "i8"
            return self.numpy.array(numbers, dtype=kind).reshape(-1, width)
        return list(zip(*[iter(numbers)] * width))

    def parts(self, name):
        """Rows of different lengths, as lists."""
        numbers, starts = self.numbers(name).tolist(), self.numbers(f"{name}.starts").tolist()
        return [numbers[start:end] for start, end in zip(starts, starts[1:])]

    def at(self, ring):
        """The points of a ring of indices."""
        return self.points[ring] if self.numpy else [self.points[place] for place in ring]

    def regions(self):
        """The rings of each polygon, as indices."""
        loops = self.parts("loops")
        if not self.has("regions"):
            return [[ring] for ring in loops]
        labels = [label[0] for label in self.parts("regions")]
        return [[ring for ring, of in zip(loops, labels) if of == label] for label in range(max(labels, default=-1) + 1)]

    def polygon(self):
        """The rings of the only polygon, or of each: `loops` without `regions` are one polygon of `triangulate`."""
        return self.regions() if self.has("regions") else [self.parts("loops")]

    def mesh(self, name):
        """The vertices of a mesh, which has its own, and its triangles."""
        return self.own(self.parts(name))

    def own(self, triangles):
        """The points that triangles use, and the triangles with the places of these points."""
        used = sorted({corner for triangle in triangles for corner in triangle})
        place = {corner: at for at, corner in enumerate(used)}
        triangles = [tuple(place[corner] for corner in triangle) for triangle in triangles]
        if self.numpy:
            return self.points[used], self.numpy.array(triangles, dtype="i8").reshape(-1, 3)
        return self.at(used), triangles


def _of_points(scene):
    yield {"points": scene.points, **({"constraints": scene.rows("constraints", 2)} if scene.has("constraints") else {})}


def _of_polygons(scene):
    for rings in scene.polygon():
        yield {"points": scene.points, "rings": rings}


def _of_operands(scene):
    operands = [[scene.at(ring) for ring in scene.parts(name)] for name in ("first", "second")]
    yield {"first": operands[0], "second": operands[1], "rule": scene.word("rule", "even-odd")}


def _of_regions(scene):
    regions = [[scene.at(ring) for ring in rings] for rings in scene.regions()]
    yield {"regions": regions, "probes": scene.rows("probes", 2)}


def _of_probes(scene):
    name = "tetrahedra" if scene.has("tetrahedra") else "triangles"
    parameters = {"vertices": scene.points, name: scene.rows(name, 4 if name == "tetrahedra" else 3)}
    if scene.has("regions"):
        parameters["sides"] = scene.rows("regions", 2)
    yield {**parameters, "probes": scene.rows("probes", 3)}


def _of_rays(scene):
    rays = [(ray[:3], ray[3:]) for ray in scene.rows("rays", 6)]
    triangles = scene.rows("triangles", 3)
    yield {"vertices": scene.points, "triangles": triangles, "rays": rays, "extent": scene.word("extent", "ray")}


def _of_objects(scene):
    yield {"points": scene.points, "a": scene.parts("from"), "b": scene.parts("to")}


def _of_meshes(scene):
    if scene.has("first_regions") or scene.has("second_regions"):
        raise Declined("the meshes have several regions")
    yield {"first": scene.mesh("first"), "second": scene.mesh("second")}


def _of_complexes(scene):
    complexes = {}
    for name in ("a", "b"):
        complexes[name] = [(vertex,) for vertex in scene.numbers(f"{name}.vertices")]
        for kind in ("edges", "triangles", "tetrahedra"):
            complexes[name] += [tuple(simplex) for simplex in scene.parts(f"{name}.{kind}")]
    yield {"points": scene.points, **complexes}


def _of_segments(scene):
    yield {"segments": [scene.at(segment) for segment in scene.parts("segments")]}


def _of_drawing(scene):
    (parameters,) = _of_segments(scene)
    yield {**parameters, "side": 2.0 ** -int(scene.word("pixel", "0"))}


def _of_cells(scene):
    axis = "xyz".index(scene.word("axis", "x"))
    along = [point[axis] for point in scene.points]
    cells = [(along[left], along[right]) for left, right in scene.parts("cells")]
    yield {"cells": cells, "probes": [along[probe] for probe in scene.numbers("probes")]}


def _of_cubes(scene):
    yield {"cubes": scene.rows("cubes", 4)}


def _of_solid(scene):
    vertices, triangles = scene.own(list(zip(*[iter(scene.numbers("triangles"))] * 3)))
    planes = [scene.at(plane) for plane in scene.parts("planes")]
    yield {"vertices": vertices, "triangles": triangles, "planes": planes}


def _flat(values):
    """The numbers of nested lists or of an array."""
    if hasattr(values, "tolist"):
        values = values.tolist()
    if isinstance(values, (list, tuple)):
        return [number for value in values for number in _flat(value)]
    return [values]


def _ids(values):
    return array.array("I", [int(value) & 0xFFFFFFFF for value in _flat(values)]).tobytes()


def _doubles(values):
    return array.array("d", map(float, _flat(values))).tobytes()


def _triangles(answers):
    return {"ids:triangles": _ids(answers)}


def _triangles_of_polygons(answers):
    counts = [len(_flat(triangles)) // 3 for triangles in answers]
    return {"ids:triangles": _ids(answers), "ids:polygons": _ids([[at] * count for at, count in enumerate(counts)])}


def _hull(answers):
    return {"ids:hull": _ids(answers)}


def _labels(answers):
    return {"ids:labels": _ids(answers)}


def _polygons(answers):
    arrays = {}
    for name, polygons in answers[0].items():
        rings = [ring for polygon in polygons for ring in polygon]
        arrays[f"numbers:{name}"] = _doubles(rings)
        arrays[f"ids:{name}.starts"] = _ids([0, *itertools.accumulate(len(ring) for ring in rings)])
        arrays[f"ids:{name}.polygons"] = _ids([0, *itertools.accumulate(len(polygon) for polygon in polygons)])
    return arrays


def _starts(lists):
    return _ids([0, *itertools.accumulate(len(one) for one in lists)])


def _pairs(answers):
    pairs = [_flat(pair) for pair in answers[0]]
    return {"ids:pairs": _ids(pairs), "ids:pairs.starts": _starts(pairs)}


def _crossings(answers):
    lists = [_flat(one) for one in answers[0]]
    return {"ids:crossings": _ids(lists), "ids:crossings.starts": _starts(lists)}


def _hits(answers):
    lists = [_flat(one) for one in answers[0]]
    return {"ids:hits": _ids(lists), "ids:hits.starts": _starts(lists)}


def _distance(answers):
    return {"numbers:distance": _doubles([float(answers[0])])}


def _chains(answers):
    return {"numbers:chains": _doubles(answers[0]), "ids:chains.starts": _starts(answers[0])}


def _measures(answers):
    return {f"numbers:{name}": _doubles([number]) for name, number in answers[0].items()}


def _parts(answers):
    vertices, triangles, starts = [], [], [0]
    for points, faces in answers[0]:
        triangles += [[int(corner) + len(vertices) for corner in face] for face in faces]
        vertices += [_flat(point) for point in points]
        starts.append(len(triangles))
    parts = {"numbers:parts.vertices": _doubles(vertices), "ids:parts.triangles": _ids(triangles)}
    return {**parts, "ids:parts.starts": _ids(starts)}


def _meshes(answers):
    arrays = {}
    for name, (vertices, triangles) in answers[0].items():
        arrays[f"numbers:{name}.vertices"] = _doubles(vertices)
        arrays[f"ids:{name}.triangles"] = _ids(triangles)
    return arrays


# For each task: the parameters of the function's calls, and the arrays of the answers.
TASKS = {
    "delaunay2d": (_of_points, _triangles),
    "hull2d": (_of_points, _hull),
    "hull3d": (_of_points, _triangles),
    "triangulate": (_of_polygons, _triangles_of_polygons),
    "overlay2d": (_of_operands, _polygons),
    "polygon-locate": (_of_regions, _labels),
    "mesh-locate": (_of_probes, _labels),
    "mesh-rays": (_of_rays, _hits),
    "distance": (_of_objects, _distance),
    "mesh-intersect": (_of_meshes, _meshes),
    "contacts2d": (_of_complexes, _pairs),
    "contacts3d": (_of_complexes, _pairs),
    "crossings": (_of_segments, _crossings),
    "interval": (_of_cells, _labels),
    "cube-union": (_of_cubes, _measures),
    "slice": (_of_solid, _parts),
    "snap2d": (_of_drawing, _chains),
}
