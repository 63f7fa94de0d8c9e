// geogram's Boolean operations, exact until the points are rounded at the end, for the bench `mesh_race`. The
// simplification of flat parts is switched off. The library is that of the engine `geogram-solids`.

#include <geogram/basic/attributes.h>
#include <geogram/mesh/mesh.h>
#include <geogram/mesh/mesh_surface_intersection.h>

#include <predicament_geogram.hpp>

#include "race.hpp"

static void load(GEO::Mesh& into, const Arrays& from) {
    into.vertices.create_vertices(from.points.size() / 3);
    for (GEO::index_t v : into.vertices)
        for (GEO::index_t axis : {0, 1, 2}) into.vertices.point_ptr(v)[axis] = from.points[3 * v + axis];
    into.facets.create_triangles(from.corners.size() / 3);
    for (GEO::index_t f : into.facets)
        for (GEO::index_t side : {0, 1, 2}) into.facets.set_vertex(f, side, from.corners[3 * f + side]);
    into.facets.connect();
}

static Arrays unite(const Arrays& first, const Arrays& second) {
    GEO::Mesh one, other, made;
    load(one, first), load(other, second);
    GEO::mesh_boolean_operation(made, one, other, "A+B", GEO::MESH_BOOL_OPS_NO_SIMPLIFY);
    Arrays all;
    for (const GEO::index_t v : made.vertices)
        for (GEO::index_t axis : {0, 1, 2}) all.points.push_back(made.vertices.point_ptr(v)[axis]);
    for (const GEO::index_t f : made.facets)
        for (GEO::index_t side : {0, 1, 2}) all.corners.push_back(made.facets.vertex(f, side));
    return all;
}

int main() {
    predicament::start_geogram();
    serve(unite);
}
