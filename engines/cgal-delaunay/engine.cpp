// CGAL's constrained Delaunay triangulation on Epick: exact predicates on doubles.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/version.h>

#include <predicament_engine.hpp>

using namespace predicament;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Base = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, K>,
                                                  CGAL::Constrained_triangulation_face_base_2<K>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<K, Base>;

struct Cgal {
    static constexpr const char* name = "cgal-delaunay";
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
};

int main(int argc, char** argv) { return serve<Cgal>(argc, argv); }
