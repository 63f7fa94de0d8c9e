// CGAL's corefinement with exact predicates and inexact constructions, for the bench `mesh_race`.
//
// `cgal --check FILE` prints why a mesh has no place in the race, or nothing: then it is oriented to bound a volume.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include "race.hpp"

namespace PMP = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

static Surface surface(const Arrays& arrays) {
    Surface made;
    made.reserve(arrays.points.size() / 3, arrays.corners.size() / 2, arrays.corners.size() / 3);
    for (std::size_t i = 0; i < arrays.points.size(); i += 3)
        made.add_vertex({arrays.points[i], arrays.points[i + 1], arrays.points[i + 2]});
    const auto at = [&](std::size_t i) { return Surface::Vertex_index(arrays.corners[i]); };
    for (std::size_t i = 0; i < arrays.corners.size(); i += 3)
        if (made.add_face(at(i), at(i + 1), at(i + 2)) == Surface::null_face()) throw std::runtime_error("no manifold");
    return made;
}

static Arrays arrays(Surface& made) {
    made.collect_garbage();
    Arrays all;
    for (const auto v : made.vertices())
        for (int axis : {0, 1, 2}) all.points.push_back(made.point(v)[axis]);
    for (const auto face : made.faces())
        for (const auto v : made.vertices_around_face(made.halfedge(face))) all.corners.push_back(v);
    return all;
}

static Arrays unite(const Arrays& first, const Arrays& second) {
    Surface one = surface(first), other = surface(second), made;
    if (!PMP::corefine_and_compute_union(one, other, made)) throw std::runtime_error("the result is no manifold");
    return arrays(made);
}

static const char* check(const std::string& path) {
    const Arrays given = Arrays::read(path);
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;
    for (std::size_t i = 0; i < given.points.size(); i += 3)
        points.emplace_back(given.points[i], given.points[i + 1], given.points[i + 2]);
    for (std::size_t i = 0; i < given.corners.size(); i += 3)
        faces.push_back({given.corners[i], given.corners[i + 1], given.corners[i + 2]});
    const std::size_t before = points.size();
    if (!PMP::orient_polygon_soup(points, faces) || points.size() != before) return "no orientable manifold";
    Surface made;
    PMP::polygon_soup_to_polygon_mesh(points, faces, made);
    if (!CGAL::is_closed(made)) return "open";
    if (PMP::does_self_intersect(made)) return "crosses itself";
    PMP::orient_to_bound_a_volume(made);
    if (!PMP::does_bound_a_volume(made)) return "bounds no volume";
    arrays(made).write(path);
    return nullptr;
}

int main(int argc, char** argv) {
    if (argc != 3 || argv[1] != std::string("--check")) return serve(unite), 0;
    const char* why = check(argv[2]);
    if (why) std::cout << why << std::endl;
}
