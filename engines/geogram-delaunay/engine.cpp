// geogram's Delaunay triangulations of the plane (BDEL2d). Its predicates break ties by Simulation of Simplicity.
// Constraints are declined.

#include <geogram/delaunay/delaunay.h>

#include <predicament_engine.hpp>
#include <predicament_geogram.hpp>

using namespace predicament;

struct Geogram {
    static constexpr const char* name = "geogram-delaunay";
    static std::string version() { return start_geogram(); }

    static Triangles delaunay2d(const Points2& points, const Edges& constraints) {
        if (!constraints.empty()) throw Declined("this engine does not ask geogram about constraints");
        std::vector<double> flat;
        for (const Point2& p : points) flat.insert(flat.end(), p.begin(), p.end());
        GEO::Delaunay_var made = GEO::Delaunay::create(2, "BDEL2d");
        made->set_vertices(static_cast<GEO::index_t>(points.size()), flat.data());
        Triangles found;
        for (GEO::index_t t = 0; t < made->nb_cells(); ++t) {
            const auto corner = [&](GEO::index_t i) { return static_cast<std::uint32_t>(made->cell_vertex(t, i)); };
            found.push_back({corner(0), corner(1), corner(2)});
        }
        return found;
    }
};

int main(int argc, char** argv) { return serve<Geogram>(argc, argv); }
