// CGAL's corefinement with exact points (Epeck), and its points in meshes on Epick: exact predicates on doubles. Corefinement
// excludes operands that intersect themselves or do not bound a volume: such scenes are declined.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <predicament_cgal.hpp>

using namespace predicament;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Faces = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;

struct Cgal {
    static constexpr const char* name = "cgal-solids";
    static std::string version() { return CGAL_VERSION_STR; }

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
