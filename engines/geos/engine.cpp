// GEOSOrientationIndex, the orientation of the C interface of GEOS.

#include <geos_c.h>

#include "predicament_engine.hpp"

class Geos {
public:
    static constexpr const char* name = "geos";
    static constexpr predicament::Zero zero = predicament::Zero::exact;
    static std::string version() { return GEOSversion(); }

    Geos() : handle_(GEOS_init_r()) {}
    ~Geos() { GEOS_finish_r(handle_); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    predicament::Answer orient2d(const double* a, const double* b, const double* c) const {
        const int index = GEOSOrientationIndex_r(handle_, a[0], a[1], b[0], b[1], c[0], c[1]);
        // The value 2 reports an exception.
        return index == 2 ? predicament::Answer::declined : static_cast<predicament::Answer>(index);
    }

private:
    GEOSContextHandle_t handle_;
};

int main(int argc, char** argv) { return predicament::serve<Geos>(argc, argv); }
