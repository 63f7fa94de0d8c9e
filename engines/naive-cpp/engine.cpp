// Determinants in plain doubles: a starting point for predicates of your own.

#include "predicament_engine.hpp"

struct Naive {
    static constexpr const char* name = "naive-cpp";
    static constexpr predicament::Zero zero = predicament::Zero::exact;
    static std::string version() { return "1.0"; }

    static double compare(int axis, const double* a, const double* b) { return a[axis] - b[axis]; }

    static double orient2d(const double* a, const double* b, const double* c) {
        return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
    }

    static double orient3d(const double* a, const double* b, const double* c, const double* d) {
        const double ax = a[0] - d[0], ay = a[1] - d[1], az = a[2] - d[2];
        const double bx = b[0] - d[0], by = b[1] - d[1], bz = b[2] - d[2];
        const double cx = c[0] - d[0], cy = c[1] - d[1], cz = c[2] - d[2];
        return ax * (by * cz - bz * cy) + bx * (cy * az - cz * ay) + cx * (ay * bz - az * by);
    }

    static double incircle(const double* a, const double* b, const double* c, const double* d) {
        const double ax = a[0] - d[0], ay = a[1] - d[1], bx = b[0] - d[0], by = b[1] - d[1];
        const double cx = c[0] - d[0], cy = c[1] - d[1];
        return (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
               (cx * cx + cy * cy) * (ax * by - ay * bx);
    }
};

int main(int argc, char** argv) { return predicament::serve<Naive>(argc, argv); }
