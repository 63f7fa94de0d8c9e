// geogram's Boolean operations on closed surfaces: exact points while it computes, doubles at the end, and the
// simplification of flat parts switched off.

#include <geogram/basic/attributes.h>
#include <geogram/mesh/mesh.h>
#include <geogram/mesh/mesh_surface_intersection.h>

#include <predicament_engine.hpp>
#include <predicament_geogram.hpp>

using namespace predicament;

struct Solids {
    static constexpr const char* name = "geogram-solids";
    static std::string version() { return start_geogram(); }

    static void load(GEO::Mesh& into, const Mesh& mesh) {
        for (const Point3& p : mesh.vertices) into.vertices.create_vertex(p.data());
        for (const auto& [a, b, c] : mesh.triangles) into.facets.create_triangle(a, b, c);
        into.facets.connect();
        for (const GEO::index_t corner : into.facet_corners)
            if (into.facet_corners.adjacent_facet(corner) == GEO::NO_FACET) throw Declined("for geogram the mesh is not closed");
    }

    static Results<Mesh> mesh_intersect(const Mesh& first, const Mesh& second) {
        GEO::Mesh a, b;
        load(a, first), load(b, second);
        const auto result = [&](const char* operation) {
            GEO::Mesh made;
            GEO::mesh_boolean_operation(made, a, b, operation, GEO::MESH_BOOL_OPS_NO_SIMPLIFY);
            Mesh mesh;
            for (const GEO::index_t v : made.vertices) {
                const double* p = made.vertices.point_ptr(v);
                mesh.vertices.push_back({p[0], p[1], p[2]});
            }
            for (const GEO::index_t f : made.facets)
                mesh.triangles.push_back({made.facets.vertex(f, 0), made.facets.vertex(f, 1), made.facets.vertex(f, 2)});
            return mesh;
        };
        return {result("A+B"), result("A*B"), result("A-B"), {}};
    }
};

int main(int argc, char** argv) { return serve<Solids>(argc, argv); }
