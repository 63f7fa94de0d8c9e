// predicament_engine.hpp: predicates in C++ for the tool predicament.
//
// Write a type with your predicates, and a `main` of one line:
//
//     #include "predicament_engine.hpp"
//
//     struct Mine {
//         static constexpr const char* name = "mine";
//         static constexpr predicament::Zero zero = predicament::Zero::exact;
//         static std::string version() { return "1.0"; }
//         static double orient2d(const double* a, const double* b, const double* c) { … }
//     };
//
//     int main(int argc, char** argv) { return predicament::serve<Mine>(argc, argv); }
//
// Predicates, static or not; predicates that the type lacks are declined:
//
//     compare(int axis, a, b)   orient2d(a, b, c)   orient3d(a, b, c, d)
//     incircle(a, b, c, d)      insphere(a, b, c, d, e)
//
// A parameter is a `const double*` (the coordinates) or a `predicament::Vertex` (coordinates and id). `axis` is 0, 1 or 2.
// A result is a number, whose sign counts and which may be a NaN; an enumeration with values below, at and above 0; or a
// `predicament::Answer`. Signs are those of docs/ENGINES.md.
//
// Optional members:
//
//     void prepare(const double* points, std::size_t count, int dimension)
//         called before the first batch of a scene, and again whenever predicates get other points: for orient2d in a
//         plane of a scene in space, `dimension` is 2 and the points are projected. Ids stay the same. The time of a
//         batch excludes this call. It may throw `predicament::Declined`.
//     static constexpr const char* precision = "f32"
//         for predicates that round coordinates to singles.
//     static constexpr auto formulas = std::make_tuple(predicament::formula<3>("nearer", 2, nearer))
//         other predicates: the number of vertices, the name, the dimension of the points and a function, which takes
//         vertices as the predicates above do. The tool knows them by formula (`predicament derive`). Points with
//         weights get the weight as last coordinate, and `prepare` then gets a `dimension` that counts the weight.
//
// Whole tasks, static or not; the tool judges the answers. An engine may have tasks, predicates or both:
//
//     Triangles delaunay2d(const Points2& points)            or with (…, const Edges& constraints)
//     Ids hull2d(const Points2& points)                      the hull's corners, one after the other
//     Triangles hull3d(const Points3& points)
//     Triangles triangulate(const Points2& points, const Rings& rings)     one polygon; rings of indices
//     Results<Polygons> overlay2d(const Polygon& first, const Polygon& second, bool even_odd)
//         the rings of each operand, in any order; `even_odd` is false for the rule of nonzero winding numbers
//     Labels polygon_locate(const Polygons& regions, const Points2& probes)     the region, -1 outside, -2 on a border
//     Labels mesh_locate(const Mesh& mesh, const Points3& probes)     1 inside, 0 outside, -2 on the surface
//     std::vector<Ids> mesh_rays(const Mesh& mesh, const Rays& rays, const std::string& extent)
//         for each ray the triangles that it hits, in order along it; `extent` is "line", "ray" or "segment"
//     double distance(const Points3& points, const Simplices& a, const Simplices& b, int dimension)
//         the distance of two objects, 0 if they have a common point: loops in the plane, where z is 0, or triangles
//     Results<Mesh> mesh_intersect(const Mesh& first, const Mesh& second)
//     Pairs contacts2d(const Points2& points, const Simplices& a, const Simplices& b)     simplices that meet
//     Pairs contacts3d(const Points3& points, const Simplices& a, const Simplices& b)
//     std::vector<Ids> crossings(const Segments& segments)     for each segment those that cross it, in order along it
//     Labels interval(const Cells& cells, const std::vector<double>& probes)     the cell, -1 outside, -2 at an end
//     Measures cube_union(const Cubes& cubes)
//     std::vector<Mesh> slice(const Mesh& mesh, const Planes& planes)     parts, each on one side of each plane
//     Chains snap2d(const Segments& segments, double side)     coordinates that are multiples of `side`
//
// A task throws `predicament::Declined` if a scene is not for the library. Only the call is timed.
//
// This header needs C++17 and POSIX only. Compile with -ffp-contract=off, and without -ffast-math.

#ifndef PREDICAMENT_ENGINE_HPP
#define PREDICAMENT_ENGINE_HPP

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

// `predicament engines doctor` shows what such flags break.
#if defined(__FAST_MATH__) && !defined(PREDICAMENT_DOCTOR)
#error "predicates need IEEE arithmetic: compile without -ffast-math"
#endif

namespace predicament {

/// The meaning of the engine's zero: the determinant is zero, or (`never`) ties are broken and zero has no meaning.
enum class Zero { exact, never };

/// An answer of the protocol, for predicates that decline single queries.
enum class Answer : int { negative = -1, zero = 0, positive = 1, declined = 2, nan = 3 };

/// The exception of `prepare` or a predicate for a scene or batch that is not for this engine, with the reason.
struct Declined : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A vertex of the scene: its id, and a pointer to its coordinates.
struct Vertex {
    const double* at;
    std::uint32_t id;
    operator const double*() const { return at; }
};

/// A predicate that the tool knows by formula; `formula` makes it.
template <std::size_t Arity, class F>
struct Formula {
    static constexpr std::size_t arity = Arity;
    const char* name;
    int dimension;
    F sign;
};

/// A predicate about `Arity` vertices that the tool knows by formula, for the member `formulas` of an engine.
template <std::size_t Arity, class F>
constexpr Formula<Arity, F> formula(const char* name, int dimension, F sign) {
    return {name, dimension, sign};
}

// What tasks take and return. Indices are those of the scene's points, or of a mesh's own vertices.
using Point2 = std::array<double, 2>;
using Point3 = std::array<double, 3>;
using Points2 = std::vector<Point2>;
using Points3 = std::vector<Point3>;
using Ids = std::vector<std::uint32_t>;
using Edges = std::vector<std::array<std::uint32_t, 2>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Rings = std::vector<Ids>;
using Polygon = std::vector<Points2>;
using Polygons = std::vector<Polygon>;
using Labels = std::vector<std::int64_t>;
struct Mesh {
    Points3 vertices;
    Triangles triangles;
};
using Simplices = std::vector<Ids>;
using Pairs = std::vector<std::array<Ids, 2>>;
using Segments = std::vector<std::array<Point2, 2>>;
using Cells = std::vector<std::array<double, 2>>;
using Cubes = std::vector<std::array<double, 4>>;  // x, y and z of the lower corner, and the length of the edges
using Planes = std::vector<std::array<Point3, 3>>;
using Rays = std::vector<std::array<Point3, 2>>;
using Chains = std::vector<Points2>;
struct Measures {
    double volume = 0, area = 0;
    std::optional<double> edge_length;
};

/// The results of Boolean operations; operations that the library lacks stay empty. In a polygon of a result, the outer
/// ring is first.
template <class T>
struct Results {
    std::optional<T> union_, intersection, difference, symmetric_difference;
};

namespace detail {

/// The maximum size of a message's body, in bytes.
constexpr std::uint32_t longest = std::uint32_t{1} << 30;

/// Ends the program with exit code 2, for input that breaks the protocol.
[[noreturn]] inline void malformed(const std::string& what) {
    std::fprintf(stderr, "engine: %s\n", what.c_str());
    std::exit(2);
}

/// Returns the engine's own handle for stdout. Output of a library goes to stderr instead.
inline int claim_stdout() {
    const int own = dup(STDOUT_FILENO);
    if (own < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) malformed("stdout can't be duplicated");
    std::fflush(stdout);  // output from before `main`
    return own;
}

/// The little-endian integer at `bytes`.
inline std::uint32_t read_u32(const unsigned char* bytes) {
    return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
           std::uint32_t{bytes[3]} << 24;
}

/// The little-endian double at `bytes`.
inline double read_f64(const unsigned char* bytes) {
    const std::uint64_t bits = std::uint64_t{read_u32(bytes)} | std::uint64_t{read_u32(bytes + 4)} << 32;
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

/// Reads up to `count` bytes of stdin; fewer only at its end.
inline std::size_t read_bytes(unsigned char* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count) {
        const ssize_t more = ::read(STDIN_FILENO, to + done, count - done);
        if (more < 0 && errno == EINTR) continue;
        if (more < 0) malformed("stdin can't be read");
        if (more == 0) break;
        done += static_cast<std::size_t>(more);
    }
    return done;
}

/// A part of a message's body.
struct Bytes {
    const unsigned char* at = nullptr;
    std::size_t size = 0;
    bool given = false;
    std::string text() const { return std::string(reinterpret_cast<const char*>(at), size); }
};

/// A received message: its body, and the positions of its values.
class Message {
public:
    /// Reads the next message. Returns false if stdin ends before its first byte.
    bool read() {
        unsigned char length[4];
        const std::size_t got = read_bytes(length, 4);
        if (got == 0) return false;
        if (got < 4) malformed("stdin ends within the length of a message");
        const std::uint32_t size = read_u32(length);
        if (size > longest) malformed("a message of " + std::to_string(size) + " bytes; the longest has 2^30");
        constexpr std::size_t piece = std::size_t{1} << 20;  // memory grows with the bytes that arrive
        body_.clear();
        while (body_.size() < size) {
            const std::size_t before = body_.size();
            const std::size_t wanted = before + piece < size ? piece : size - before;
            body_.resize(before + wanted);
            if (read_bytes(body_.data() + before, wanted) < wanted) malformed("stdin ends within a message");
        }
        split();
        return true;
    }

    /// The value of `key`. It is not `given` if the message lacks the key.
    Bytes value(const char* key) const {
        for (const auto& entry : entries_)
            if (entry.first == key) return entry.second;
        return {};
    }

    /// The value of a required key.
    Bytes need(const char* key) const {
        const Bytes found = value(key);
        if (!found.given) malformed("a message `" + type() + "` without `" + key + "`");
        return found;
    }

    /// The type of the message.
    std::string type() const { return entries_.front().second.text(); }

private:
    void split() {
        entries_.clear();
        std::size_t at = 0;
        while (at < body_.size()) {
            const std::size_t key = body_[at];
            if (body_.size() - at < 1 + key + 4) malformed("a key runs over the end of its message");
            const std::string name(reinterpret_cast<const char*>(body_.data() + at + 1), key);
            const std::size_t size = read_u32(body_.data() + at + 1 + key);
            at += 1 + key + 4;
            if (body_.size() - at < size) malformed("a value runs over the end of its message");
            entries_.push_back({name, Bytes{body_.data() + at, size, true}});
            at += size;
        }
        if (entries_.empty() || entries_.front().first != "type") malformed("a message whose first key is not `type`");
    }

    std::vector<unsigned char> body_;
    std::vector<std::pair<std::string, Bytes>> entries_;
};

/// A message to send.
class Reply {
public:
    explicit Reply(const std::string& type) { text("type", type); }

    /// Adds a key and its value.
    Reply& text(const std::string& key, const std::string& value) { return bytes(key, value.data(), value.size()); }

    /// Adds a key and its value.
    Reply& bytes(const std::string& key, const void* value, std::size_t size) {
        body_.push_back(static_cast<char>(key.size()));
        body_ += key;
        append_u32(body_, static_cast<std::uint32_t>(size));
        body_.append(static_cast<const char*>(value), size);
        return *this;
    }

    /// Writes the message to `file`.
    void send(int file) const {
        std::string whole;
        append_u32(whole, static_cast<std::uint32_t>(body_.size()));
        whole += body_;
        for (std::size_t done = 0; done < whole.size();) {
            const ssize_t more = ::write(file, whole.data() + done, whole.size() - done);
            if (more < 0 && errno == EINTR) continue;
            if (more < 0) malformed("stdout can't be written");
            done += static_cast<std::size_t>(more);
        }
    }

private:
    static void append_u32(std::string& to, std::uint32_t value) {
        for (int shift = 0; shift < 32; shift += 8) to.push_back(static_cast<char>(value >> shift & 255));
    }

    std::string body_;
};

/// The protocol's byte for an answer.
template <class T>
inline std::uint8_t encode(T value) {
    static_assert(!std::is_same_v<T, bool>, "a predicate returns a sign, not a bool");
    if constexpr (std::is_same_v<T, Answer>) {
        return static_cast<std::uint8_t>(static_cast<int>(value));
    } else if constexpr (std::is_enum_v<T>) {
        return encode(static_cast<long long>(value));
    } else {
        static_assert(std::is_arithmetic_v<T>, "a predicate returns a number, an enumeration or an Answer");
        return static_cast<std::uint8_t>((value > 0) - (value < 0) + 3 * (value != value));  // no branch to mispredict
    }
}

// The predicates: their names, their numbers of vertices, and a call of the engine's function.
struct Compare {
    static constexpr const char* name = "compare";
    static constexpr std::size_t arity = 2;
    template <class E>
    static auto call(E& e, int axis, Vertex a, Vertex b) -> decltype(e.compare(axis, a, b)) {
        return e.compare(axis, a, b);
    }
};
struct Orient2d {
    static constexpr const char* name = "orient2d";
    static constexpr std::size_t arity = 3;
    template <class E>
    static auto call(E& e, int, Vertex a, Vertex b, Vertex c) -> decltype(e.orient2d(a, b, c)) {
        return e.orient2d(a, b, c);
    }
};
struct Orient3d {
    static constexpr const char* name = "orient3d";
    static constexpr std::size_t arity = 4;
    template <class E>
    static auto call(E& e, int, Vertex a, Vertex b, Vertex c, Vertex d) -> decltype(e.orient3d(a, b, c, d)) {
        return e.orient3d(a, b, c, d);
    }
};
struct Incircle {
    static constexpr const char* name = "incircle";
    static constexpr std::size_t arity = 4;
    template <class E>
    static auto call(E& e, int, Vertex a, Vertex b, Vertex c, Vertex d) -> decltype(e.incircle(a, b, c, d)) {
        return e.incircle(a, b, c, d);
    }
};
struct Insphere {
    static constexpr const char* name = "insphere";
    static constexpr std::size_t arity = 5;
    template <class E>
    static auto call(E& e, int, Vertex a, Vertex b, Vertex c, Vertex d, Vertex f) -> decltype(e.insphere(a, b, c, d, f)) {
        return e.insphere(a, b, c, d, f);
    }
};

template <std::size_t>
using VertexAt = Vertex;

/// Whether the engine `E` has the predicate `P`.
template <class P, class E, class Indices = std::make_index_sequence<P::arity>, class = void>
struct Offers : std::false_type {};
template <class P, class E, std::size_t... I>
struct Offers<P, E, std::index_sequence<I...>,
              std::void_t<decltype(P::call(std::declval<E&>(), 0, std::declval<VertexAt<I>>()...))>> : std::true_type {};

template <class E, class = void>
struct Prepares : std::false_type {};
template <class E>
struct Prepares<E, std::void_t<decltype(std::declval<E&>().prepare(static_cast<const double*>(nullptr), std::size_t{0}, 0))>>
    : std::true_type {};

template <class E>
constexpr auto formulas_of(int) -> std::decay_t<decltype(E::formulas)> {
    return E::formulas;
}
template <class E>
constexpr std::tuple<> formulas_of(long) {
    return {};
}

template <class E>
constexpr auto zero_of(int) -> decltype(Zero(E::zero)) {
    return E::zero;
}
template <class E>
constexpr Zero zero_of(long) {
    return Zero::exact;
}

template <class E>
auto precision_of(int) -> decltype(std::string(E::precision)) {
    return E::precision;
}
template <class E>
std::string precision_of(long) {
    return "f64";
}

/// Makes the compiler compute `vertex` although the result is unused.
inline void use(Vertex vertex) {
#if defined(__GNUC__)
    __asm__ volatile("" : : "r"(vertex.at), "r"(vertex.id));
#else
    static const double* volatile used;
    used = vertex.at;
#endif
}

/// A predicate that returns 0 at once, hidden from the compiler.
template <class... V>
inline int empty(V... vertices) {
    (use(vertices), ...);
    int zero = 0;
#if defined(__GNUC__)
    __asm__ volatile("" : "+r"(zero));
#endif
    return zero;
}

/// The points that predicates receive: `stride` doubles each.
struct Points {
    std::vector<double> coordinates;
    std::size_t stride = 0;
    std::size_t count() const { return stride == 0 ? 0 : coordinates.size() / stride; }
};

/// Calls `f` for each query and writes a byte for each. Only this loop is timed.
template <class F, std::size_t... I>
inline void each(const F& f, const Points& points, const std::vector<std::uint32_t>& ids, std::uint8_t* signs,
                 std::index_sequence<I...>) {
    const double* const first = points.coordinates.data();
    const std::size_t stride = points.stride;
    const std::size_t queries = ids.size() / sizeof...(I);
    const std::uint32_t* id = ids.data();
    for (std::size_t query = 0; query < queries; ++query, id += sizeof...(I))
        signs[query] = encode(f(Vertex{first + stride * id[I], id[I]}...));
}

// The tasks: their names, and a call of the engine's function.
#define PREDICAMENT_TASK(Type, title, Parameters, Arguments) \
    struct Type {                                            \
        static constexpr const char* name = title;           \
        template <class E>                                   \
        static auto call Parameters->decltype(Arguments) {   \
            return Arguments;                                \
        }                                                    \
    }
PREDICAMENT_TASK(Delaunay2d, "delaunay2d", (E & e, const Points2& points), e.delaunay2d(points));
PREDICAMENT_TASK(Constrained, "delaunay2d", (E & e, const Points2& points, const Edges& edges), e.delaunay2d(points, edges));
PREDICAMENT_TASK(Hull2d, "hull2d", (E & e, const Points2& points), e.hull2d(points));
PREDICAMENT_TASK(Hull3d, "hull3d", (E & e, const Points3& points), e.hull3d(points));
PREDICAMENT_TASK(Triangulate, "triangulate", (E & e, const Points2& points, const Rings& rings), e.triangulate(points, rings));
PREDICAMENT_TASK(Overlay2d, "overlay2d", (E & e, const Polygon& first, const Polygon& second, bool even_odd),
                 e.overlay2d(first, second, even_odd));
PREDICAMENT_TASK(PolygonLocate, "polygon-locate", (E & e, const Polygons& regions, const Points2& probes),
                 e.polygon_locate(regions, probes));
PREDICAMENT_TASK(MeshLocate, "mesh-locate", (E & e, const Mesh& mesh, const Points3& probes), e.mesh_locate(mesh, probes));
PREDICAMENT_TASK(MeshRays, "mesh-rays", (E & e, const Mesh& mesh, const Rays& rays, const std::string& extent),
                 e.mesh_rays(mesh, rays, extent));
PREDICAMENT_TASK(Distance, "distance", (E & e, const Points3& points, const Simplices& a, const Simplices& b, int dimension),
                 e.distance(points, a, b, dimension));
PREDICAMENT_TASK(MeshIntersect, "mesh-intersect", (E & e, const Mesh& first, const Mesh& second),
                 e.mesh_intersect(first, second));
PREDICAMENT_TASK(Contacts2d, "contacts2d", (E & e, const Points2& points, const Simplices& a, const Simplices& b),
                 e.contacts2d(points, a, b));
PREDICAMENT_TASK(Contacts3d, "contacts3d", (E & e, const Points3& points, const Simplices& a, const Simplices& b),
                 e.contacts3d(points, a, b));
PREDICAMENT_TASK(Crossings, "crossings", (E & e, const Segments& segments), e.crossings(segments));
PREDICAMENT_TASK(Interval, "interval", (E & e, const Cells& cells, const std::vector<double>& probes), e.interval(cells, probes));
PREDICAMENT_TASK(CubeUnion, "cube-union", (E & e, const Cubes& cubes), e.cube_union(cubes));
PREDICAMENT_TASK(Slice, "slice", (E & e, const Mesh& mesh, const Planes& planes), e.slice(mesh, planes));
PREDICAMENT_TASK(Snap2d, "snap2d", (E & e, const Segments& segments, double side), e.snap2d(segments, side));
#undef PREDICAMENT_TASK

/// Whether the engine `E` has the task `T`, for arguments of these types.
template <class T, class E, class Arguments, class = void>
struct Does : std::false_type {};
template <class T, class E, class... A>
struct Does<T, E, std::tuple<A...>, std::void_t<decltype(T::call(std::declval<E&>(), std::declval<const A&>()...))>>
    : std::true_type {};

/// The arrays of a task's scene.
class Asked {
public:
    explicit Asked(const Message& message) : message_(message) {}

    /// True if the scene has such an array, and it is not empty.
    bool has(const std::string& name) const { return message_.value(("ids:" + name).c_str()).size != 0; }

    Ids ids(const std::string& name) const {
        const Bytes bytes = message_.value(("ids:" + name).c_str());
        Ids ids(bytes.size / 4);
        for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = read_u32(bytes.at + 4 * i);
        return ids;
    }

    template <std::size_t N>
    std::vector<std::array<double, N>> points(const std::string& name) const {
        const Bytes bytes = message_.value(("numbers:" + name).c_str());
        std::vector<std::array<double, N>> points(bytes.size / (8 * N));
        for (std::size_t i = 0; i < N * points.size(); ++i) points[i / N][i % N] = read_f64(bytes.at + 8 * i);
        return points;
    }

    template <std::size_t N>
    std::vector<std::array<std::uint32_t, N>> tuples(const std::string& name) const {
        const Ids all = ids(name);
        std::vector<std::array<std::uint32_t, N>> tuples(all.size() / N);
        for (std::size_t i = 0; i < N * tuples.size(); ++i) tuples[i / N][i % N] = all[i];
        return tuples;
    }

    Rings rings(const std::string& name) const {
        const Ids all = ids(name), starts = ids(name + ".starts");
        Rings rings;
        for (std::size_t i = 1; i < starts.size(); ++i) rings.emplace_back(all.begin() + starts[i - 1], all.begin() + starts[i]);
        return rings;
    }

    /// The rings of each polygon. Without `regions`, all loops are one polygon of `triangulate`, and one region each else.
    std::vector<Rings> polygons(bool is_one) const {
        const Rings loops = rings("loops"), labels = rings("regions");
        std::vector<Rings> polygons;
        for (std::size_t i = 0; i < loops.size(); ++i) {
            const std::size_t label = has("regions") ? labels.at(i).at(0) : is_one ? 0 : i;
            if (polygons.size() <= label) polygons.resize(label + 1);
            polygons[label].push_back(loops[i]);
        }
        return polygons;
    }

    /// Rings of indices as rings of points.
    Polygon placed(const Rings& rings) const {
        const Points2 points = this->points<2>("points");
        Polygon polygon;
        for (const Ids& ring : rings) {
            polygon.emplace_back();
            for (const std::uint32_t id : ring) polygon.back().push_back(points.at(id));
        }
        return polygon;
    }

    /// A mesh with its own vertices.
    Mesh mesh(const std::string& name) const {
        const Points3 points = this->points<3>("points");
        Mesh mesh{{}, tuples<3>(name)};
        std::map<std::uint32_t, std::uint32_t> own;
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t id : triangle) own[id] = 0;
        for (auto& [id, place] : own) place = static_cast<std::uint32_t>(mesh.vertices.size()), mesh.vertices.push_back(points.at(id));
        for (auto& triangle : mesh.triangles)
            for (std::uint32_t& id : triangle) id = own[id];
        return mesh;
    }

    /// The largest simplices of a complex.
    Simplices complex(const std::string& name) const {
        Simplices all;
        for (const std::uint32_t vertex : ids(name + ".vertices")) all.push_back({vertex});
        for (const char* const kind : {".edges", ".triangles", ".tetrahedra"})
            for (const Ids& simplex : rings(name + kind)) all.push_back(simplex);
        return all;
    }

    /// The points of tuples of indices.
    template <std::size_t N, std::size_t D>
    std::vector<std::array<std::array<double, D>, N>> corners(const std::string& name) const {
        const std::vector<std::array<double, D>> points = this->points<D>("points");
        std::vector<std::array<std::array<double, D>, N>> all;
        for (const auto& tuple : tuples<N>(name)) {
            all.emplace_back();
            for (std::size_t i = 0; i < N; ++i) all.back()[i] = points.at(tuple[i]);
        }
        return all;
    }

    /// The coordinates of all points along the axis of `interval`, in a scene of `D` dimensions.
    template <std::size_t D>
    std::vector<double> along() const {
        const std::string axis = message_.value("word:axis").text();
        std::vector<double> along;
        for (const auto& point : points<D>("points")) along.push_back(point.at(axis == "z" ? 2 : axis == "y" ? 1 : 0));
        return along;
    }

private:
    const Message& message_;
};

/// The answer to a task: arrays, and the time of the library's calls.
class Answered {
public:
    explicit Answered(std::chrono::nanoseconds passed) : reply_("answer") { reply_.text("ns", std::to_string(passed.count())); }

    template <class T>
    void ids(const std::string& name, const T& values) {
        std::string bytes;
        for (const auto value : values)
            for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(static_cast<std::uint64_t>(value) >> shift & 255));
        reply_.bytes("ids:" + name, bytes.data(), bytes.size());
    }

    template <class T>
    void tuples(const std::string& name, const T& values) {
        Ids all;
        for (const auto& tuple : values) all.insert(all.end(), tuple.begin(), tuple.end());
        ids(name, all);
    }

    template <class T>
    void points(const std::string& name, const T& points) {
        std::string bytes;
        for (const auto& point : points)
            for (const double x : point) {
                std::uint64_t bits;
                std::memcpy(&bits, &x, sizeof bits);
                for (int shift = 0; shift < 64; shift += 8) bytes.push_back(static_cast<char>(bits >> shift & 255));
            }
        reply_.bytes("numbers:" + name, bytes.data(), bytes.size());
    }

    void add(const std::string& name, const Polygons& polygons) {
        Points2 all;
        Ids starts{0}, firsts{0};
        for (const Polygon& polygon : polygons) {
            for (const Points2& ring : polygon) {
                all.insert(all.end(), ring.begin(), ring.end());
                starts.push_back(static_cast<std::uint32_t>(all.size()));
            }
            firsts.push_back(static_cast<std::uint32_t>(starts.size() - 1));
        }
        points(name, all), ids(name + ".starts", starts), ids(name + ".polygons", firsts);
    }

    void add(const std::string& name, const Mesh& mesh) {
        points(name + ".vertices", mesh.vertices), tuples(name + ".triangles", mesh.triangles);
    }

    /// The place of each list's first item, and the number of items.
    template <class T>
    void starts(const std::string& name, const T& lists) {
        Ids starts{0};
        for (const auto& list : lists) starts.push_back(starts.back() + static_cast<std::uint32_t>(list.size()));
        ids(name + ".starts", starts);
    }

    void lists(const std::string& name, const std::vector<Ids>& lists) { tuples(name, lists), starts(name, lists); }

    void pairs(const Pairs& pairs) {
        std::vector<Ids> rows;
        for (const auto& [a, b] : pairs) rows.push_back(a), rows.back().insert(rows.back().end(), b.begin(), b.end());
        lists("pairs", rows);
    }

    void parts(const std::vector<Mesh>& parts) {
        Mesh all;
        Ids starts{0};
        for (const Mesh& part : parts) {
            const auto before = static_cast<std::uint32_t>(all.vertices.size());
            all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
            for (const auto& [a, b, c] : part.triangles) all.triangles.push_back({a + before, b + before, c + before});
            starts.push_back(static_cast<std::uint32_t>(all.triangles.size()));
        }
        add("parts", all), ids("parts.starts", starts);
    }

    void chains(const Chains& chains) {
        Points2 all;
        for (const Points2& chain : chains) all.insert(all.end(), chain.begin(), chain.end());
        points("chains", all), starts("chains", chains);
    }

    void number(const char* name, double x) { points(name, std::array<std::array<double, 1>, 1>{{{x}}}); }

    void measures(const Measures& found) {
        number("volume", found.volume), number("area", found.area);
        if (found.edge_length) number("edge_length", *found.edge_length);
    }

    template <class T>
    void results(const Results<T>& all) {
        if (all.union_) add("union", *all.union_);
        if (all.intersection) add("intersection", *all.intersection);
        if (all.difference) add("difference", *all.difference);
        if (all.symmetric_difference) add("symmetric-difference", *all.symmetric_difference);
    }

    Reply reply_;
};

/// The engine `E` and its scene.
template <class E>
class Server {
public:
    explicit Server(int out) : out_(out) {}

    /// Answers messages until stdin ends.
    void run() {
        static_assert(offers<Compare>() || offers<Orient2d>() || offers<Orient3d>() || offers<Incircle>() || offers<Insphere>() ||
                          std::tuple_size_v<decltype(formulas_of<E>(0))> != 0 || has_tasks,
                      "the engine has no predicate or task with the parameters that predicament_engine.hpp expects");
        Message message;
        while (message.read()) {
            Reply reply = answer_or_reason(message);
            const Bytes id = message.value("id");  // the number of the question
            if (id.given) reply.bytes("id", id.at, id.size);
            reply.send(out_);
        }
    }

private:
    enum class View { none, scene, weighted, xy, yz, zx };

    template <class P>
    static constexpr bool offers() {
        return Offers<P, E>::value;
    }

    Reply answer_or_reason(const Message& message) {
        try {
            return answer(message);
        } catch (const Declined& reason) {
            return Reply("declined").text("reason", reason.what());
        } catch (const std::exception& problem) {
            return Reply("error").text("message", problem.what());
        }
    }

    Reply answer(const Message& message) {
        const std::string type = message.type();
        if (type == "hello") return hello(message);
        if (type == "scene") return scene(message);
        if (type == "batch") return batch(message);
        if (type == "task") return task(message);
        return Reply("error").text("message", "unknown message `" + type + "`");
    }

    Reply hello(const Message& message) {
        const std::string protocol = message.need("protocol").text();
        if (protocol != "1") return Reply("declined").text("reason", "this engine speaks protocol 1, not " + protocol);
        std::string predicates;
        list<Compare>(predicates), list<Orient2d>(predicates), list<Orient3d>(predicates), list<Incircle>(predicates),
            list<Insphere>(predicates);
        std::apply([&](const auto&... of) { ((predicates += (predicates.empty() ? "" : " ") + std::string(of.name)), ...); },
                   formulas_of<E>(0));
        const char* const zero = zero_of<E>(0) == Zero::exact ? "exact" : "never";
        return Reply("hello")
            .text("protocol", "1")
            .text("name", E::name)
            .text("version", E::version())
            .text("predicates", predicates)
            .text("tasks", tasks())
            .text("zero", zero)
            .text("precision", precision_of<E>(0));
    }

    template <class P>
    static void list(std::string& to) {
        if (offers<P>()) to += (to.empty() ? "" : " ") + std::string(P::name);
    }

    Reply scene(const Message& message) {
        const std::string dimension = message.need("dimension").text();
        if (dimension != "2" && dimension != "3") malformed("dimension `" + dimension + "` is neither 2 nor 3");
        const Bytes points = message.need("points");
        scene_.stride = dimension == "2" ? 2 : 3;
        if (points.size % (8 * scene_.stride) != 0)
            malformed("points of " + std::to_string(points.size) + " bytes are no whole points");
        scene_.coordinates.resize(points.size / 8);
        for (std::size_t i = 0; i < scene_.coordinates.size(); ++i) scene_.coordinates[i] = read_f64(points.at + 8 * i);
        const Bytes weights = message.value("weights");
        if (weights.size != 0 && weights.size != 8 * scene_.count())
            malformed("weights of " + std::to_string(weights.size) + " bytes for " + std::to_string(scene_.count()) + " points");
        weights_.resize(weights.size / 8);
        for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] = read_f64(weights.at + 8 * i);
        view_ = View::none;
        const auto start = std::chrono::steady_clock::now();
        look(View::scene);
        return Reply("ready").text("ns", nanoseconds_since(start));
    }

    Reply batch(const Message& message) {
        const std::string predicate = message.need("predicate").text();
        const Bytes empty = message.value("empty");
        const bool is_empty = empty.given && empty.text() == "1";
        if (scene_.stride == 0) malformed("a batch before any scene");
        if (predicate == "compare") return ask<Compare>(message, is_empty, View::scene, axis(message));
        if (predicate == "orient2d") return ask<Orient2d>(message, is_empty, plane(message), 0);
        if (predicate == "orient3d") return ask<Orient3d>(message, is_empty, in_dimension(3, predicate), 0);
        if (predicate == "incircle") return ask<Incircle>(message, is_empty, in_dimension(2, predicate), 0);
        if (predicate == "insphere") return ask<Insphere>(message, is_empty, in_dimension(3, predicate), 0);
        Reply reply("declined");
        bool found = false;
        const auto one = [&](const auto& of) {
            if (found || predicate != of.name) return;
            found = true;
            reply = ask_formula(of, message, is_empty);
        };
        std::apply([&](const auto&... of) { (one(of), ...); }, formulas_of<E>(0));
        if (!found) throw Declined("this engine has no `" + predicate + "`");
        return reply;
    }

    template <std::size_t Arity, class F>
    Reply ask_formula(const Formula<Arity, F>& formula, const Message& message, bool is_empty) {
        const View view = in_dimension(static_cast<std::size_t>(formula.dimension), formula.name);
        return ask_each<Arity>(message, is_empty, weights_.empty() ? view : View::weighted, formula.name, formula.sign);
    }

    template <class T, class... A>
    static constexpr bool does = Does<T, E, std::tuple<A...>>::value;
    static constexpr bool has_constraints = does<Constrained, Points2, Edges>;
    static constexpr bool has_tasks =
        does<Delaunay2d, Points2> || has_constraints || does<Hull2d, Points2> || does<Hull3d, Points3> ||
        does<Triangulate, Points2, Rings> || does<Overlay2d, Polygon, Polygon, bool> ||
        does<PolygonLocate, Polygons, Points2> || does<MeshLocate, Mesh, Points3> || does<MeshIntersect, Mesh, Mesh> ||
        does<MeshRays, Mesh, Rays, std::string> || does<Distance, Points3, Simplices, Simplices, int> ||
        does<Contacts2d, Points2, Simplices, Simplices> || does<Contacts3d, Points3, Simplices, Simplices> ||
        does<Crossings, Segments> || does<Interval, Cells, std::vector<double>> || does<CubeUnion, Cubes> ||
        does<Slice, Mesh, Planes> || does<Snap2d, Segments, double>;

    /// The names of the engine's tasks.
    static std::string tasks() {
        std::string names;
        const auto add = [&](const char* name, bool is_there) {
            if (is_there) names += (names.empty() ? "" : " ") + std::string(name);
        };
        add("delaunay2d", does<Delaunay2d, Points2> || has_constraints), add("hull2d", does<Hull2d, Points2>);
        add("hull3d", does<Hull3d, Points3>), add("triangulate", does<Triangulate, Points2, Rings>);
        add("overlay2d", does<Overlay2d, Polygon, Polygon, bool>);
        add("polygon-locate", does<PolygonLocate, Polygons, Points2>), add("mesh-locate", does<MeshLocate, Mesh, Points3>);
        add("mesh-rays", does<MeshRays, Mesh, Rays, std::string>);
        add("distance", does<Distance, Points3, Simplices, Simplices, int>), add("mesh-intersect", does<MeshIntersect, Mesh, Mesh>);
        add("contacts2d", does<Contacts2d, Points2, Simplices, Simplices>);
        add("contacts3d", does<Contacts3d, Points3, Simplices, Simplices>), add("crossings", does<Crossings, Segments>);
        add("interval", does<Interval, Cells, std::vector<double>>), add("cube-union", does<CubeUnion, Cubes>);
        add("slice", does<Slice, Mesh, Planes>), add("snap2d", does<Snap2d, Segments, double>);
        return names;
    }

    Reply task(const Message& message) {
        const std::string name = message.need("task").text();
        const Asked asked(message);
        const auto refuse = [&](const char* array) {
            if (asked.has(array)) throw Declined(std::string("the scene has ") + array + ", and the engine does not take them");
        };
        if (name == "delaunay2d") {
            const auto add = [](Answered& to, const Triangles& triangles) { to.tuples("triangles", triangles); };
            if constexpr (has_constraints)
                return call<Constrained>(add, asked.points<2>("points"), asked.tuples<2>("constraints"));
            refuse("constraints");
            return call<Delaunay2d>(add, asked.points<2>("points"));
        }
        if (name == "hull2d")
            return call<Hull2d>([](Answered& to, const Ids& hull) { to.ids("hull", hull); }, asked.points<2>("points"));
        if (name == "hull3d")
            return call<Hull3d>([](Answered& to, const Triangles& all) { to.tuples("triangles", all); }, asked.points<3>("points"));
        if (name == "triangulate") return triangulate(asked);
        const auto results = [](Answered& to, const auto& all) { to.results(all); };
        if (name == "overlay2d") {
            const bool even_odd = message.value("word:rule").text() != "non-zero";
            return call<Overlay2d>(results, asked.placed(asked.rings("first")), asked.placed(asked.rings("second")), even_odd);
        }
        const auto labels = [](Answered& to, const Labels& labels) { to.ids("labels", labels); };
        if (name == "polygon-locate") {
            Polygons regions;
            for (const Rings& rings : asked.polygons(false)) regions.push_back(asked.placed(rings));
            return call<PolygonLocate>(labels, regions, asked.points<2>("probes"));
        }
        if (name == "mesh-locate") {
            refuse("tetrahedra"), refuse("regions");
            return call<MeshLocate>(labels, asked.mesh("triangles"), asked.points<3>("probes"));
        }
        if (name == "mesh-rays") {
            Rays rays;
            for (const auto& [px, py, pz, qx, qy, qz] : asked.points<6>("rays")) rays.push_back({{{px, py, pz}, {qx, qy, qz}}});
            const auto add = [](Answered& to, const std::vector<Ids>& lists) { to.lists("hits", lists); };
            const std::string extent = message.value("word:extent").text();
            return call<MeshRays>(add, asked.mesh("triangles"), rays, extent);
        }
        if (name == "distance") {
            const bool is_plane = message.need("dimension").text() == "2";
            Points3 points;
            if (is_plane)
                for (const auto& [x, y] : asked.points<2>("points")) points.push_back({x, y, 0});
            else
                points = asked.points<3>("points");
            const auto add = [](Answered& to, double found) { to.number("distance", found); };
            return call<Distance>(add, points, asked.rings("from"), asked.rings("to"), is_plane ? 2 : 3);
        }
        if (name == "mesh-intersect") {
            refuse("first_regions"), refuse("second_regions");
            return call<MeshIntersect>(results, asked.mesh("first"), asked.mesh("second"));
        }
        const auto pairs = [](Answered& to, const Pairs& found) { to.pairs(found); };
        if (name == "contacts2d") return call<Contacts2d>(pairs, asked.points<2>("points"), asked.complex("a"), asked.complex("b"));
        if (name == "contacts3d") return call<Contacts3d>(pairs, asked.points<3>("points"), asked.complex("a"), asked.complex("b"));
        if (name == "crossings") {
            const auto add = [](Answered& to, const std::vector<Ids>& lists) { to.lists("crossings", lists); };
            return call<Crossings>(add, asked.corners<2, 2>("segments"));
        }
        if (name == "interval") {
            const std::vector<double> along = message.need("dimension").text() == "2" ? asked.along<2>() : asked.along<3>();
            Cells cells;
            for (const auto& [left, right] : asked.tuples<2>("cells")) cells.push_back({along.at(left), along.at(right)});
            std::vector<double> probes;
            for (const std::uint32_t probe : asked.ids("probes")) probes.push_back(along.at(probe));
            return call<Interval>(labels, cells, probes);
        }
        if (name == "cube-union")
            return call<CubeUnion>([](Answered& to, const Measures& found) { to.measures(found); }, asked.points<4>("cubes"));
        if (name == "slice") {
            const auto add = [](Answered& to, const std::vector<Mesh>& parts) { to.parts(parts); };
            return call<Slice>(add, asked.mesh("triangles"), asked.corners<3, 3>("planes"));
        }
        if (name == "snap2d") {
            const double side = std::ldexp(1.0, -std::atoi(message.value("word:pixel").text().c_str()));
            return call<Snap2d>([](Answered& to, const Chains& found) { to.chains(found); }, asked.corners<2, 2>("segments"), side);
        }
        throw Declined("this engine has no `" + name + "`");
    }

    /// Calls the engine's function, and adds its result to the answer. Only the function is timed.
    template <class T, class F, class... A>
    Reply call(const F& add, const A&... arguments) {
        if constexpr (!does<T, A...>) {
            throw Declined(std::string("this engine has no `") + T::name + "`");
        } else {
            const auto start = std::chrono::steady_clock::now();
            const auto result = T::call(engine_, arguments...);
            Answered answered(std::chrono::steady_clock::now() - start);
            add(answered, result);
            return answered.reply_;
        }
    }

    /// Triangulates polygon by polygon.
    Reply triangulate(const Asked& asked) {
        if constexpr (!does<Triangulate, Points2, Rings>) {
            throw Declined("this engine has no `triangulate`");
        } else {
            const Points2 points = asked.points<2>("points");
            const std::vector<Rings> polygons = asked.polygons(true);
            std::vector<Triangles> found;
            const auto start = std::chrono::steady_clock::now();
            for (const Rings& rings : polygons) found.push_back(Triangulate::call(engine_, points, rings));
            Answered answered(std::chrono::steady_clock::now() - start);
            Triangles all;
            Ids of;
            for (std::size_t i = 0; i < found.size(); ++i) {
                all.insert(all.end(), found[i].begin(), found[i].end());
                of.insert(of.end(), found[i].size(), static_cast<std::uint32_t>(i));
            }
            answered.tuples("triangles", all), answered.ids("polygons", of);
            return answered.reply_;
        }
    }

    int axis(const Message& message) const {
        const std::string name = message.need("axis").text();
        const int axis = name == "x" ? 0 : name == "y" ? 1 : name == "z" ? 2 : 3;
        if (static_cast<std::size_t>(axis) >= scene_.stride) malformed("`" + name + "` is no axis of the scene");
        return axis;
    }

    View plane(const Message& message) const {
        const Bytes given = message.value("plane");
        const std::string name = given.given ? given.text() : "xy";
        if (scene_.stride == 2 && name == "xy") return View::scene;
        if (scene_.stride == 3 && name == "xy") return View::xy;
        if (scene_.stride == 3 && name == "yz") return View::yz;
        if (scene_.stride == 3 && name == "zx") return View::zx;
        malformed("`" + name + "` is no plane of the scene");
    }

    View in_dimension(std::size_t dimension, const std::string& predicate) const {
        if (scene_.stride != dimension)
            throw Declined(predicate + " is about points of dimension " + std::to_string(dimension));
        return View::scene;
    }

    /// Prepares the engine for the points of `view`.
    void look(View view) {
        if (view == view_) return;
        view_ = View::none;
        if (view == View::weighted) {
            projected_.stride = scene_.stride + 1;
            projected_.coordinates.clear();
            for (std::size_t i = 0; i < scene_.count(); ++i) {
                const double* const point = scene_.coordinates.data() + scene_.stride * i;
                projected_.coordinates.insert(projected_.coordinates.end(), point, point + scene_.stride);
                projected_.coordinates.push_back(weights_[i]);
            }
        } else if (view != View::scene) {
            const std::size_t u = view == View::xy ? 0 : view == View::yz ? 1 : 2;
            const std::size_t v = (u + 1) % 3;
            projected_.stride = 2;
            projected_.coordinates.resize(2 * scene_.count());
            for (std::size_t i = 0; i < scene_.count(); ++i) {
                projected_.coordinates[2 * i] = scene_.coordinates[3 * i + u];
                projected_.coordinates[2 * i + 1] = scene_.coordinates[3 * i + v];
            }
        }
        const Points& points = view == View::scene ? scene_ : projected_;
        if constexpr (Prepares<E>::value)
            engine_.prepare(points.coordinates.data(), points.count(), static_cast<int>(points.stride));
        view_ = view;
    }

    template <class P>
    Reply ask(const Message& message, bool is_empty, View view, int axis) {
        if constexpr (!Offers<P, E>::value) {
            throw Declined(std::string("this engine has no `") + P::name + "`");
        } else {
            const auto call = [&](auto... v) { return P::call(engine_, axis, v...); };
            return ask_each<P::arity>(message, is_empty, view, P::name, call);
        }
    }

    /// Calls `f` for each query of the message.
    template <std::size_t Arity, class F>
    Reply ask_each(const Message& message, bool is_empty, View view, const char* name, const F& f) {
        const Bytes bytes = message.need("ids");
        if (bytes.size % (4 * Arity) != 0)
            malformed("ids of " + std::to_string(bytes.size) + " bytes are no whole queries of " + name);
        std::vector<std::uint32_t> ids(bytes.size / 4);
        for (std::size_t i = 0; i < ids.size(); ++i) {
            ids[i] = read_u32(bytes.at + 4 * i);
            if (ids[i] >= scene_.count())
                malformed("vertex " + std::to_string(ids[i]) + " of a scene of " + std::to_string(scene_.count()));
        }
        std::vector<std::uint8_t> signs(ids.size() / Arity);
        look(view);
        const Points& points = view == View::scene ? scene_ : projected_;
        const auto indices = std::make_index_sequence<Arity>();
        const auto start = std::chrono::steady_clock::now();
        if (is_empty)
            each([](auto... v) { return empty(v...); }, points, ids, signs.data(), indices);
        else
            each(f, points, ids, signs.data(), indices);
        const std::string ns = nanoseconds_since(start);
        return Reply("signs").text("ns", ns).bytes("signs", signs.data(), signs.size());
    }

    static std::string nanoseconds_since(std::chrono::steady_clock::time_point start) {
        const auto passed = std::chrono::steady_clock::now() - start;
        return std::to_string(std::chrono::duration_cast<std::chrono::nanoseconds>(passed).count());
    }

    int out_;
    E engine_{};
    Points scene_;
    Points projected_;  // or with weights
    std::vector<double> weights_;
    View view_ = View::none;
};

}  // namespace detail

/// Answers the tool as the engine `E` until stdin ends; with `--version`, prints its version. Returns the exit code.
template <class E>
int serve(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "--version") == 0) {
        const int out = detail::claim_stdout();
        const std::string line = std::string(E::version()) + "\n";
        return ::write(out, line.data(), line.size()) == static_cast<ssize_t>(line.size()) ? 0 : 2;
    }
    if (argc != 1) {
        std::fprintf(stderr, "usage: %s [--version]; without it, an engine on stdin and stdout\n", argv[0]);
        return 2;
    }
    const int out = detail::claim_stdout();
    detail::Server<E>(out).run();
    return 0;
}

}  // namespace predicament

#endif
