// CGAL's Boolean operations of polygons on exact numbers (Epeck). An operand is the symmetric difference of its rings: the
// even-odd rule.

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/version.h>

#include <predicament_engine.hpp>

using namespace predicament;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Set = CGAL::Polygon_set_2<Exact>;

struct Cgal {
    static constexpr const char* name = "cgal-polygons";
    static std::string version() { return CGAL_VERSION_STR; }

    static Set region(const Polygon& rings) {
        Set region;
        for (const Points2& ring : rings) {
            CGAL::Polygon_2<Exact> polygon;
            for (const Point2& p : ring) polygon.push_back({p[0], p[1]});
            if (!polygon.is_simple()) throw Declined("CGAL has Boolean operations on simple rings only");
            if (polygon.is_clockwise_oriented()) polygon.reverse_orientation();
            region.symmetric_difference(polygon);
        }
        return region;
    }

    static Polygons polygons(const Set& set) {
        const auto ring = [](const CGAL::Polygon_2<Exact>& of) {
            Points2 ring;
            for (const auto& p : of.vertices()) ring.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y())});
            return ring;
        };
        std::vector<CGAL::Polygon_with_holes_2<Exact>> all;
        set.polygons_with_holes(std::back_inserter(all));
        Polygons found;
        for (const auto& one : all) {
            found.push_back({ring(one.outer_boundary())});
            for (const auto& hole : one.holes()) found.back().push_back(ring(hole));
        }
        return found;
    }

    static Results<Polygons> overlay2d(const Polygon& first, const Polygon& second, bool even_odd) {
        if (!even_odd) throw Declined("CGAL has no rule of nonzero winding numbers");
        const Set a = region(first), b = region(second);
        Set join = a, intersection = a, difference = a, symmetric = a;
        join.join(b), intersection.intersection(b), difference.difference(b), symmetric.symmetric_difference(b);
        return {polygons(join), polygons(intersection), polygons(difference), polygons(symmetric)};
    }
};

int main(int argc, char** argv) { return serve<Cgal>(argc, argv); }
