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

Raise `Declined` with a reason if a scene is not for this engine. The time of a batch includes gathering the coordinates
for the first two forms, and so does the time of the empty predicate.
"""

import array
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
        if not self.forms:
            raise TypeError("the engine has none of the predicates " + ", ".join(self.takes))
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
        answers = {"hello": self.hello, "scene": self.scene, "batch": self.batch}
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
            zero=self.engine.zero,
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
