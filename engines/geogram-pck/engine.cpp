// The predicates of geogram's PCK that do not break ties.

#include <geogram/basic/common.h>
#include <geogram/basic/environment.h>
#include <geogram/numerics/predicates.h>

#include "predicament_engine.hpp"

struct Pck {
    static constexpr const char* name = "geogram-pck";
    static constexpr predicament::Zero zero = predicament::Zero::exact;
    static std::string version() {
        GEO::initialize(GEO::GEOGRAM_INSTALL_NONE);
        return GEO::Environment::instance()->get_value("version");
    }

    static GEO::Sign orient2d(const double* a, const double* b, const double* c) { return GEO::PCK::orient_2d(a, b, c); }

    // Its orientation in space is positive if d is above the plane: the opposite of ours.
    static int orient3d(const double* a, const double* b, const double* c, const double* d) {
        return -GEO::PCK::orient_3d(a, b, c, d);
    }
};

int main(int argc, char** argv) { return predicament::serve<Pck>(argc, argv); }
