// The predicates of a CGAL kernel. cgal-inexact builds this file with PREDICAMENT_CGAL_INEXACT.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version_macros.h>

#include "predicament_engine.hpp"

#ifdef PREDICAMENT_CGAL_INEXACT
using Kernel = CGAL::Simple_cartesian<double>;
constexpr const char* kernel_name = "cgal-inexact";
#else
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr const char* kernel_name = "cgal-epick";
#endif

using predicament::Vertex;

class Cgal {
public:
    static constexpr const char* name = kernel_name;
    static constexpr predicament::Zero zero = predicament::Zero::exact;
    static std::string version() { return CGAL_VERSION_STR; }

    void prepare(const double* points, std::size_t count, int dimension) {
        flat_.clear();
        solid_.clear();
        for (std::size_t i = 0; i < count; ++i, points += dimension) {
            if (dimension == 2)
                flat_.emplace_back(points[0], points[1]);
            else
                solid_.emplace_back(points[0], points[1], points[2]);
        }
    }

    CGAL::Comparison_result compare(int axis, Vertex a, Vertex b) const {
        if (solid_.empty()) return axis == 0 ? CGAL::compare_x(flat_[a.id], flat_[b.id]) : CGAL::compare_y(flat_[a.id], flat_[b.id]);
        const auto &p = solid_[a.id], &q = solid_[b.id];
        return axis == 0 ? CGAL::compare_x(p, q) : axis == 1 ? CGAL::compare_y(p, q) : CGAL::compare_z(p, q);
    }

    CGAL::Orientation orient2d(Vertex a, Vertex b, Vertex c) const {
        return CGAL::orientation(flat_[a.id], flat_[b.id], flat_[c.id]);
    }

    // CGAL's orientation in space is positive if d is above the plane: the opposite of ours.
    CGAL::Orientation orient3d(Vertex a, Vertex b, Vertex c, Vertex d) const {
        return -CGAL::orientation(solid_[a.id], solid_[b.id], solid_[c.id], solid_[d.id]);
    }

    CGAL::Oriented_side incircle(Vertex a, Vertex b, Vertex c, Vertex d) const {
        return CGAL::side_of_oriented_circle(flat_[a.id], flat_[b.id], flat_[c.id], flat_[d.id]);
    }

    CGAL::Oriented_side insphere(Vertex a, Vertex b, Vertex c, Vertex d, Vertex e) const {
        return -CGAL::side_of_oriented_sphere(solid_[a.id], solid_[b.id], solid_[c.id], solid_[d.id], solid_[e.id]);
    }

private:
    std::vector<Kernel::Point_2> flat_;
    std::vector<Kernel::Point_3> solid_;
};

int main(int argc, char** argv) { return predicament::serve<Cgal>(argc, argv); }
