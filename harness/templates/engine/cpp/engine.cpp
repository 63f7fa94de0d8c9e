// The engine {name}. Each predicate is a plain determinant, which is wrong near a tie.
//
// REPLACE the body of each predicate by a call of your library. Delete a predicate that your library lacks. Only the
// sign of a result counts. predicament_engine.hpp lists the other members that an engine may have.

#include "predicament_engine.hpp"

namespace {

struct Point {
    double x, y, z;
};

Point minus(const double* p, const double* q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

/// The difference of two points of the plane, and its squared length as z.
Point lifted(const double* p, const double* q) {
    const double x = p[0] - q[0], y = p[1] - q[1];
    return {x, y, x * x + y * y};
}

double squared(Point p) { return p.x * p.x + p.y * p.y + p.z * p.z; }

double triple(Point p, Point q, Point r) {
    return p.z * (q.x * r.y - r.x * q.y) + q.z * (r.x * p.y - p.x * r.y) + r.z * (p.x * q.y - q.x * p.y);
}

}  // namespace

struct Engine {
    static constexpr const char* name = "{name}";
    // exact: a zero means that the points are degenerate. never: your library breaks ties.
    static constexpr predicament::Zero zero = predicament::Zero::exact;
    static std::string version() { return "1.0"; }  // the version of your library

    // REPLACE. Positive where a's coordinate is greater than b's. axis is 0, 1 or 2.
    static double compare(int axis, const double* a, const double* b) { return a[axis] - b[axis]; }

    // REPLACE. Positive where a, b, c turn counterclockwise.
    static double orient2d(const double* a, const double* b, const double* c) {
        return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
    }

    // REPLACE. Positive where d is below the plane of a, b, c, which turn counterclockwise seen from above.
    static double orient3d(const double* a, const double* b, const double* c, const double* d) {
        return triple(minus(a, d), minus(b, d), minus(c, d));
    }

    // REPLACE. Positive where d is inside the circle of a, b, c, which turn counterclockwise.
    static double incircle(const double* a, const double* b, const double* c, const double* d) {
        return triple(lifted(a, d), lifted(b, d), lifted(c, d));
    }

    // REPLACE. Positive where e is inside the sphere of a, b, c, d, whose orient3d is positive.
    static double insphere(const double* a, const double* b, const double* c, const double* d, const double* e) {
        const Point p = minus(a, e), q = minus(b, e), r = minus(c, e), s = minus(d, e);
        return (squared(s) * triple(p, q, r) - squared(r) * triple(p, q, s)) +
               (squared(q) * triple(p, r, s) - squared(p) * triple(q, r, s));
    }
};

int main(int argc, char** argv) { return predicament::serve<Engine>(argc, argv); }
