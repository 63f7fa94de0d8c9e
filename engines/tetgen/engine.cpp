// The predicates that tetgen.h declares: TetGen's version of Shewchuk's predicates, with additional static filters.

#include <tetgen.h>

#include <algorithm>

#include "predicament_engine.hpp"

class Tetgen {
public:
    static constexpr const char* name = "tetgen";
    static constexpr predicament::Zero zero = predicament::Zero::exact;
    static std::string version() { return TETGEN_VERSION; }

    // As in TetGen, the static filters use the extent of the points along each axis. The interface requires extents above 0,
    // so there are no static filters if all points are in a plane perpendicular to an axis.
    void prepare(const double* points, std::size_t count, int dimension) {
        if (dimension != 3 || count == 0) return;
        double extent[3];
        for (int axis = 0; axis < 3; ++axis) {
            double low = points[axis], high = points[axis];
            for (std::size_t i = 1; i < count; ++i) {
                low = std::min(low, points[3 * i + axis]);
                high = std::max(high, points[3 * i + axis]);
            }
            extent[axis] = high - low;
        }
        const bool flat = !(extent[0] > 0 && extent[1] > 0 && extent[2] > 0);
        if (flat)
            exactinit(0, 0, 1, 1.0, 1.0, 1.0);
        else
            exactinit(0, 0, 0, extent[0], extent[1], extent[2]);
    }

    // The library's parameters are not const, but it does not write to them.
    static double orient3d(const double* a, const double* b, const double* c, const double* d) {
        return ::orient3d(mutable_(a), mutable_(b), mutable_(c), mutable_(d));
    }

    static double insphere(const double* a, const double* b, const double* c, const double* d, const double* e) {
        return ::insphere(mutable_(a), mutable_(b), mutable_(c), mutable_(d), mutable_(e));
    }

private:
    static double* mutable_(const double* point) { return const_cast<double*>(point); }
};

int main(int argc, char** argv) { return predicament::serve<Tetgen>(argc, argv); }
