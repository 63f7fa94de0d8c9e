// CGAL's whole algorithms. Delaunay triangulations, hulls and points in meshes on Epick: exact predicates on doubles. Boolean
// operations and rays on exact numbers: polygons on Epeck, an operand as the symmetric difference of its rings, which is the even-odd
// rule; solids by corefinement with exact points. Corefinement excludes operands that intersect themselves or do not bound a
// volume: such scenes are declined.

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Convex_hull_traits_adapter_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/property_map.h>
#include <CGAL/version.h>

#include <predicament_cgal.hpp>

using namespace predicament;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Base = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, K>,
                                                  CGAL::Constrained_triangulation_face_base_2<K>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<K, Base>;
using Set = CGAL::Polygon_set_2<Exact>;
using Faces = CGAL::Surface_mesh<Exact::Point_3>;

struct Cgal {
    static constexpr const char* name = "cgal-tasks";
    static std::string version() { return CGAL_VERSION_STR; }

    static Triangles delaunay2d(const Points2& points, const Edges& constraints) {
        Delaunay made;
        std::vector<Delaunay::Vertex_handle> at;
        for (const Point2& p : points) {
            at.push_back(made.insert(K::Point_2(p[0], p[1])));
            at.back()->info() = static_cast<std::uint32_t>(at.size() - 1);
        }
        for (const auto& [a, b] : constraints) {
            if (at[a] == at[b]) throw Declined("CGAL takes only constraints with a length");
            made.insert_constraint(at[a], at[b]);
        }
        Triangles found;
        for (auto face = made.finite_faces_begin(); face != made.finite_faces_end(); ++face)
            found.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
        return found;
    }

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

    static Labels mesh_locate(const Mesh& mesh, const Points3& probes) {
        const auto made = cgal_surface<CGAL::Surface_mesh<K::Point_3>>(mesh);
        const CGAL::Side_of_triangle_mesh<CGAL::Surface_mesh<K::Point_3>, K> side(made);
        Labels labels;
        for (const Point3& p : probes) {
            const CGAL::Bounded_side of = side({p[0], p[1], p[2]});
            labels.push_back(of == CGAL::ON_BOUNDARY ? -2 : of == CGAL::ON_BOUNDED_SIDE ? 1 : 0);
        }
        return labels;
    }

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

    static Results<Mesh> mesh_intersect(const Mesh& first, const Mesh& second) {
        namespace PMP = CGAL::Polygon_mesh_processing;
        const Faces a = cgal_solid<Faces>(first), b = cgal_solid<Faces>(second);
        const auto result = [&](auto operation) -> std::optional<Mesh> {
            Faces one = a, other = b, made;
            return operation(one, other, made) ? std::optional(cgal_rounded(made)) : std::nullopt;
        };
        Results<Mesh> all;
        all.union_ = result([](auto& x, auto& y, auto& out) { return PMP::corefine_and_compute_union(x, y, out); });
        all.intersection = result([](auto& x, auto& y, auto& out) { return PMP::corefine_and_compute_intersection(x, y, out); });
        all.difference = result([](auto& x, auto& y, auto& out) { return PMP::corefine_and_compute_difference(x, y, out); });
        if (!all.union_ && !all.intersection && !all.difference) throw Declined("for CGAL no result is a manifold");
        return all;
    }
};

int main(int argc, char** argv) { return serve<Cgal>(argc, argv); }
