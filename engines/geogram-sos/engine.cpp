// The predicates of geogram's PCK that break ties: circles and spheres, by Simulation of Simplicity on the points' addresses.
//
// They return a side, and require a base (three points, or four) that is positive by geogram's own orientation, which in
// space is the opposite of ours. So the query point is the last point whose removal leaves a base that is not flat. The base
// is reversed if necessary, and the orientation turns the side into the determinant's sign. The measured time includes these
// orientation tests. If every base is flat, the answer is zero: the determinant is zero however the lift is perturbed.

#include <geogram/basic/common.h>
#include <geogram/basic/environment.h>
#include <geogram/numerics/predicates.h>

#include <optional>

#include "predicament_engine.hpp"

using predicament::Answer;

class Sos {
public:
    static constexpr const char* name = "geogram-sos";
    static constexpr predicament::Zero zero = predicament::Zero::never;
    static std::string version() {
        GEO::initialize(GEO::GEOGRAM_INSTALL_NONE);
        return GEO::Environment::instance()->get_value("version");
    }

    static Answer incircle(const double* a, const double* b, const double* c, const double* d) {
        const double* points[] = {a, b, c, d};
        return by_a_base(points, [](const double* const* p) -> std::optional<int> {
            const GEO::Sign turn = GEO::PCK::orient_2d(p[0], p[1], p[2]);
            if (turn == GEO::ZERO) return std::nullopt;
            const bool turned = turn == GEO::NEGATIVE;
            return turn * GEO::PCK::in_circle_2d_SOS(p[turned], p[!turned], p[2], p[3]);
        });
    }

    static Answer insphere(const double* a, const double* b, const double* c, const double* d, const double* e) {
        const double* points[] = {a, b, c, d, e};
        return by_a_base(points, [](const double* const* p) -> std::optional<int> {
            const GEO::Sign side = GEO::PCK::orient_3d(p[0], p[1], p[2], p[3]);
            if (side == GEO::ZERO) return std::nullopt;
            const bool turned = side == GEO::NEGATIVE;
            return -side * GEO::PCK::in_sphere_3d_SOS(p[turned], p[!turned], p[2], p[3], p[4]);
        });
    }

private:
    // `ask` returns nothing if the points without the last are flat.
    template <std::size_t N, class Ask>
    static Answer by_a_base(const double* (&points)[N], const Ask& ask) {
        int parity = 1;
        for (std::size_t query = N; query-- > 0;) {
            if (const std::optional<int> sign = ask(points)) return static_cast<Answer>(parity * *sign);
            if (query > 0) {
                std::swap(points[query - 1], points[N - 1]);
                parity = -parity;
            }
        }
        return Answer::zero;
    }
};

int main(int argc, char** argv) { return predicament::serve<Sos>(argc, argv); }
