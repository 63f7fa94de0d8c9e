// CGAL's distances of segments and of triangles on exact numbers (Epeck), each pair of parts, and its side of a mesh.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <predicament_cgal.hpp>

using namespace predicament;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Faces = CGAL::Surface_mesh<Exact::Point_3>;

struct Cgal {
    static constexpr const char* name = "cgal-distances";
    static std::string version() { return CGAL_VERSION_STR; }

    static double distance(const Points3& points, const Simplices& a, const Simplices& b, int dimension) {
        if (dimension == 2) throw Declined("this engine measures meshes");
        if (a.size() * b.size() > 1000000) throw Declined("CGAL has no tree for this: more than a million pairs of triangles");
        const auto triangle = [&](const Ids& part) {
            const auto at = [&](int i) { return Exact::Point_3(points[part[i]][0], points[part[i]][1], points[part[i]][2]); };
            return Exact::Triangle_3(at(0), at(1), at(2));
        };
        std::vector<Exact::Triangle_3> of_a, of_b;
        for (const Ids& part : a) of_a.push_back(triangle(part));
        for (const Ids& part : b) of_b.push_back(triangle(part));
        Exact::FT least = -1;
        for (const auto& s : of_a)
            for (const auto& t : of_b) {
                const Exact::FT squared = CGAL::do_intersect(s, t) ? Exact::FT(0) : CGAL::squared_distance(s, t);
                if (least < 0 || squared < least) least = squared;
                if (least == 0) return 0;
            }
        if (has_inside(points, a, of_b) || has_inside(points, b, of_a)) return 0;
        return std::sqrt(CGAL::to_double(least.exact()));
    }

    /// True if the first corner of one of the triangles is inside the mesh. An open mesh has no inside.
    static bool has_inside(const Points3& points, const Simplices& parts, const std::vector<Exact::Triangle_3>& others) {
        Mesh mesh{points, {}};
        for (const Ids& part : parts) mesh.triangles.push_back({part[0], part[1], part[2]});
        try {
            const Faces faces = cgal_surface<Faces>(mesh);
            const CGAL::Side_of_triangle_mesh<Faces, Exact> side(faces);
            return std::any_of(others.begin(), others.end(), [&](const auto& t) { return side(t[0]) == CGAL::ON_BOUNDED_SIDE; });
        } catch (const Declined&) {
            return false;
        }
    }
};

int main(int argc, char** argv) { return serve<Cgal>(argc, argv); }
