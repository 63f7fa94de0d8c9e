// The side strategy of Boost.Geometry for points of the plane.

#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/strategies/cartesian/side_by_triangle.hpp>
#include <boost/version.hpp>

#include "predicament_engine.hpp"

using predicament::Vertex;

class BoostSide {
public:
    static constexpr const char* name = "boost-side";
    static constexpr predicament::Zero zero = predicament::Zero::exact;
    static std::string version() { return BOOST_LIB_VERSION; }

    void prepare(const double* points, std::size_t count, int dimension) {
        points_.clear();
        for (std::size_t i = 0; i < count; ++i, points += dimension) points_.emplace_back(points[0], points[1]);
    }

    int orient2d(Vertex a, Vertex b, Vertex c) const {
        return boost::geometry::strategy::side::side_by_triangle<>::apply(points_[a.id], points_[b.id], points_[c.id]);
    }

private:
    std::vector<boost::geometry::model::d2::point_xy<double>> points_;
};

int main(int argc, char** argv) { return predicament::serve<BoostSide>(argc, argv); }
