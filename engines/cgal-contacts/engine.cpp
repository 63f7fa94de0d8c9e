// Simplices that meet: by CGAL's boxes, then by its exact predicates on doubles (Epick).

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>
#include <predicament_engine.hpp>

using namespace predicament;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Cgal {
    static constexpr const char* name = "cgal-contacts";
    static std::string version() { return CGAL_VERSION_STR; }

    /// The pairs of simplices that meet. `with` calls a function with a simplex as CGAL's.
    template <std::size_t D, class F>
    static Pairs pairs(const std::vector<std::array<double, D>>& points, const Simplices& a, const Simplices& b, const F& with) {
        using Box = CGAL::Box_intersection_d::Box_with_info_d<double, D, const Ids*>;
        const auto boxes = [&](const Simplices& all) {
            std::vector<Box> boxes;
            for (const Ids& simplex : all) {
                std::array<double, D> low = points[simplex[0]], high = low;
                for (const auto v : simplex)
                    for (std::size_t i = 0; i < D; ++i)
                        low[i] = std::min(low[i], points[v][i]), high[i] = std::max(high[i], points[v][i]);
                boxes.emplace_back(low.data(), high.data(), &simplex);
            }
            return boxes;
        };
        std::vector<Box> first = boxes(a), second = boxes(b);
        Pairs found;
        CGAL::box_intersection_d(first.begin(), first.end(), second.begin(), second.end(), [&](const Box& s, const Box& t) {
            const auto meet = [&](const auto& x) { return with(*t.info(), [&](const auto& y) { return CGAL::do_intersect(x, y); }); };
            if (with(*s.info(), meet)) found.push_back({*s.info(), *t.info()});
        });
        return found;
    }

    static Pairs contacts2d(const Points2& points, const Simplices& a, const Simplices& b) {
        const auto at = [&](const Ids& of, std::size_t i) { return K::Point_2(points[of[i]][0], points[of[i]][1]); };
        const auto with = [&](const Ids& of, const auto& call) {
            if (of.size() < 3) return of.size() == 1 ? call(at(of, 0)) : call(K::Segment_2(at(of, 0), at(of, 1)));
            return call(K::Triangle_2(at(of, 0), at(of, 1), at(of, 2)));
        };
        return pairs<2>(points, a, b, with);
    }

    static Pairs contacts3d(const Points3& points, const Simplices& a, const Simplices& b) {
        const auto at = [&](const Ids& of, std::size_t i) { return K::Point_3(points[of[i]][0], points[of[i]][1], points[of[i]][2]); };
        const auto with = [&](const Ids& of, const auto& call) {
            if (of.size() == 2) return call(K::Segment_3(at(of, 0), at(of, 1)));
            if (of.size() == 3) return call(K::Triangle_3(at(of, 0), at(of, 1), at(of, 2)));
            if (of.size() == 1) throw Declined("this engine does not ask CGAL about isolated points in space");
            return call(K::Tetrahedron_3(at(of, 0), at(of, 1), at(of, 2), at(of, 3)));
        };
        return pairs<3>(points, a, b, with);
    }
};

int main(int argc, char** argv) { return serve<Cgal>(argc, argv); }
