// CGAL's convex hulls on Epick: exact predicates on doubles.

#include <CGAL/Convex_hull_traits_adapter_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/property_map.h>
#include <CGAL/version.h>

#include <map>
#include <predicament_cgal.hpp>

using namespace predicament;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Cgal {
    static constexpr const char* name = "cgal-hulls";
    static std::string version() { return CGAL_VERSION_STR; }

    static Ids hull2d(const Points2& points) {
        std::vector<K::Point_2> all;
        for (const Point2& p : points) all.emplace_back(p[0], p[1]);
        Ids ids(points.size()), hull;
        for (std::uint32_t i = 0; i < ids.size(); ++i) ids[i] = i;
        const auto map = CGAL::make_property_map(all);
        using Traits = CGAL::Convex_hull_traits_adapter_2<K, CGAL::Pointer_property_map<K::Point_2>::type>;
        CGAL::convex_hull_2(ids.begin(), ids.end(), std::back_inserter(hull), Traits(map));
        return hull;
    }

    static Triangles hull3d(const Points3& points) {
        std::vector<K::Point_3> all;
        for (const Point3& p : points) all.emplace_back(p[0], p[1], p[2]);
        // Into a mesh: the function that fills lists of points and triangles rounds its planes (5.5.1).
        CGAL::Surface_mesh<K::Point_3> hull;
        CGAL::convex_hull_3(all.begin(), all.end(), hull);
        std::map<K::Point_3, std::uint32_t> ids;
        for (std::uint32_t i = 0; i < all.size(); ++i) ids.emplace(all[i], i);
        Triangles found = cgal_triangles(hull);
        for (auto& triangle : found)
            for (std::uint32_t& v : triangle) v = ids.at(hull.point(decltype(hull)::Vertex_index(v)));
        return found;
    }
};

int main(int argc, char** argv) { return serve<Cgal>(argc, argv); }
