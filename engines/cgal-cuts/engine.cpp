// CGAL's cuts of solids by planes on exact numbers (Epeck). CGAL cuts solids that bound a volume and do not intersect themselves.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <predicament_cgal.hpp>

using namespace predicament;
namespace PMP = CGAL::Polygon_mesh_processing;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Faces = CGAL::Surface_mesh<Exact::Point_3>;

struct Cgal {
    static constexpr const char* name = "cgal-cuts";
    static std::string version() { return CGAL_VERSION_STR; }

    static std::vector<Mesh> slice(const Mesh& mesh, const Planes& planes) {
        std::vector<Faces> parts{cgal_solid<Faces>(mesh)};
        for (const auto& [a, b, c] : planes) {
            const Exact::Plane_3 plane({a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]});
            std::vector<Faces> sides;
            for (const Faces& part : parts)
                for (const Exact::Plane_3& half : {plane, plane.opposite()}) {
                    Faces side = part;
                    PMP::clip(side, half, CGAL::parameters::clip_volume(true));
                    side.collect_garbage();
                    if (side.number_of_faces() > 0) PMP::triangulate_faces(side), sides.push_back(side);
                }
            parts = sides;
        }
        std::vector<Mesh> found;
        for (const Faces& part : parts) found.push_back(cgal_rounded(part));
        return found;
    }
};

int main(int argc, char** argv) { return serve<Cgal>(argc, argv); }
