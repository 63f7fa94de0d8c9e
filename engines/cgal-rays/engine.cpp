// CGAL's tree of boxes of triangles on exact numbers (Epeck).

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/version.h>

#include <predicament_engine.hpp>

using namespace predicament;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

struct Cgal {
    static constexpr const char* name = "cgal-rays";
    static std::string version() { return CGAL_VERSION_STR; }

    static std::vector<Ids> mesh_rays(const Mesh& mesh, const Rays& rays, const std::string& extent) {
        using Triangle = Exact::Triangle_3;
        using Primitive = CGAL::AABB_triangle_primitive<Exact, std::vector<Triangle>::const_iterator>;
        const auto at = [](const Point3& p) { return Exact::Point_3(p[0], p[1], p[2]); };
        std::vector<Triangle> triangles;
        for (const auto& [a, b, c] : mesh.triangles) {
            triangles.emplace_back(at(mesh.vertices.at(a)), at(mesh.vertices.at(b)), at(mesh.vertices.at(c)));
            if (triangles.back().is_degenerate()) throw Declined("CGAL's trees take only triangles with an area");
        }
        const CGAL::AABB_tree<CGAL::AABB_traits<Exact, Primitive>> tree(triangles.begin(), triangles.end());
        std::vector<Ids> lists;
        for (const auto& [from, to] : rays) {
            const Exact::Point_3 p = at(from), q = at(to);
            if (extent == "line") lists.push_back(hits(tree, triangles, Exact::Line_3(p, q), p, q));
            else if (extent == "ray") lists.push_back(hits(tree, triangles, Exact::Ray_3(p, q), p, q));
            else lists.push_back(hits(tree, triangles, Exact::Segment_3(p, q), p, q));
        }
        return lists;
    }

    // The triangles that a query meets, by the first common points along it.
    template <class Tree, class Query>
    static Ids hits(const Tree& tree, const std::vector<Exact::Triangle_3>& triangles, const Query& query, const Exact::Point_3& p,
                    const Exact::Point_3& q) {
        std::vector<typename Tree::template Intersection_and_primitive_id<Query>::Type> found;
        tree.all_intersections(query, std::back_inserter(found));
        const auto along = [&](const Exact::Point_3& point) { return (point - p) * (q - p); };
        std::vector<std::pair<Exact::FT, std::uint32_t>> sorted;
        for (const auto& [what, which] : found) {
            const auto face = static_cast<std::uint32_t>(which - triangles.begin());
            if (const auto* const point = boost::get<Exact::Point_3>(&what)) sorted.emplace_back(along(*point), face);
            else if (const auto* const part = boost::get<Exact::Segment_3>(&what))
                sorted.emplace_back(std::min(along(part->source()), along(part->target())), face);
        }
        std::sort(sorted.begin(), sorted.end());
        Ids faces;
        for (const auto& hit : sorted) faces.push_back(hit.second);
        return faces;
    }
};

int main(int argc, char** argv) { return serve<Cgal>(argc, argv); }
