// orient_2dlifted_SOS of geogram's PCK: the orientation of points in space, with ties broken by Simulation of Simplicity on
// the points' addresses. Its first two coordinates are ours, and its heights are our third coordinates.
//
// It requires three points that turn left as seen from above. So the query point is the last point whose removal leaves
// three points that are not collinear from above, and the three are reversed if necessary. The measured time includes this
// test. If all points are in a vertical plane, the answer is zero: the determinant is zero however the heights are perturbed.

#include <geogram/basic/common.h>
#include <geogram/basic/environment.h>
#include <geogram/numerics/predicates.h>

#include "predicament_engine.hpp"

class Lifted {
public:
    static constexpr const char* name = "geogram-lifted";
    static constexpr predicament::Zero zero = predicament::Zero::never;
    static std::string version() {
        GEO::initialize(GEO::GEOGRAM_INSTALL_NONE);
        return GEO::Environment::instance()->get_value("version");
    }

    static int orient3d(const double* first, const double* second, const double* third, const double* fourth) {
        const double* p[] = {first, second, third, fourth};
        int parity = 1;
        for (std::size_t query = 4; query-- > 0;) {
            const GEO::Sign turn = GEO::PCK::orient_2d(p[0], p[1], p[2]);
            if (turn != GEO::ZERO) {
                const double *a = p[turn == GEO::NEGATIVE], *b = p[turn == GEO::POSITIVE];
                return parity * turn * GEO::PCK::orient_2dlifted_SOS(a, b, p[2], p[3], a[2], b[2], p[2][2], p[3][2]);
            }
            if (query > 0) {
                std::swap(p[query - 1], p[3]);
                parity = -parity;
            }
        }
        return 0;
    }
};

int main(int argc, char** argv) { return predicament::serve<Lifted>(argc, argv); }
