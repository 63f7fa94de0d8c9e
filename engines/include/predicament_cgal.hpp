// predicament_cgal.hpp: the tool's meshes as CGAL's, for engines of CGAL and of libraries on it.
//
//     CGAL::Surface_mesh<Point_3> made = predicament::cgal_surface<CGAL::Surface_mesh<Point_3>>(mesh);
//     predicament::Mesh answer = predicament::cgal_rounded(made);
//
// This header needs CGAL and C++17.

#ifndef PREDICAMENT_CGAL_HPP
#define PREDICAMENT_CGAL_HPP

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include "predicament_engine.hpp"

namespace predicament {

/// A closed manifold as a `CGAL::Surface_mesh` with points of any kernel. Other meshes are declined.
template <class M>
M cgal_surface(const Mesh& mesh) {
    M made;
    std::vector<typename M::Vertex_index> at;
    for (const Point3& p : mesh.vertices) at.push_back(made.add_vertex({p[0], p[1], p[2]}));
    for (const auto& [a, b, c] : mesh.triangles)
        if (made.add_face(at[a], at[b], at[c]) == M::null_face()) throw Declined("for CGAL the mesh is not a manifold");
    if (!CGAL::is_closed(made)) throw Declined("for CGAL the mesh is not closed");
    return made;
}

/// A closed manifold that bounds a volume and does not intersect itself. Other meshes are declined.
template <class M>
M cgal_solid(const Mesh& mesh) {
    M made = cgal_surface<M>(mesh);
    if (!CGAL::Polygon_mesh_processing::does_bound_a_volume(made)) throw Declined("for CGAL the mesh does not bound a volume");
    if (CGAL::Polygon_mesh_processing::does_self_intersect(made)) throw Declined("for CGAL the mesh intersects itself");
    return made;
}

/// The triangles of a `CGAL::Surface_mesh` as indices of its vertices.
template <class M>
Triangles cgal_triangles(const M& made) {
    Triangles triangles;
    for (const auto face : made.faces()) {
        Triangles::value_type triangle{};
        std::size_t i = 0;
        for (const auto v : made.vertices_around_face(made.halfedge(face))) triangle.at(i++) = static_cast<std::uint32_t>(v);
        triangles.push_back(triangle);
    }
    return triangles;
}

/// A mesh of triangles, with its points rounded to doubles.
template <class M>
Mesh cgal_rounded(M made) {
    made.collect_garbage();
    Mesh mesh;
    for (const auto v : made.vertices()) {
        const auto& p = made.point(v);
        mesh.vertices.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    mesh.triangles = cgal_triangles(made);
    return mesh;
}

}  // namespace predicament

#endif
