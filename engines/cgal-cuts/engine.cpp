// More of CGAL's algorithms. Simplices that meet are found by boxes, then by exact predicates on doubles (Epick). Crossings
// and cuts are computed with exact numbers (Epeck): crossings are sorted without rounding, and the vertices of parts are
// rounded at the end. Snap rounding is exact as well. CGAL cuts solids that bound a volume and do not intersect themselves.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Snap_rounding_2.h>
#include <CGAL/Snap_rounding_traits_2.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

#include <predicament_cgal.hpp>
#include <variant>

using namespace predicament;
namespace PMP = CGAL::Polygon_mesh_processing;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Faces = CGAL::Surface_mesh<Exact::Point_3>;

struct Cgal {
    static constexpr const char* name = "cgal-cuts";
    static std::string version() { return CGAL_VERSION_STR; }

    /// The pairs of simplices whose boxes meet and for which `meet` is true.
    template <std::size_t D, class F>
    static Pairs pairs(const std::vector<std::array<double, D>>& points, const Simplices& a, const Simplices& b, const F& meet) {
        using Box = CGAL::Box_intersection_d::Box_with_info_d<double, D, const Ids*>;
        const auto boxes = [&](const Simplices& all) {
            std::vector<Box> boxes;
            for (const Ids& simplex : all) {
                std::array<double, D> low = points[simplex[0]], high = low;
                for (const std::uint32_t v : simplex)
                    for (std::size_t i = 0; i < D; ++i)
                        low[i] = std::min(low[i], points[v][i]), high[i] = std::max(high[i], points[v][i]);
                boxes.emplace_back(low.data(), high.data(), &simplex);
            }
            return boxes;
        };
        std::vector<Box> first = boxes(a), second = boxes(b);
        Pairs found;
        CGAL::box_intersection_d(first.begin(), first.end(), second.begin(), second.end(), [&](const Box& s, const Box& t) {
            if (meet(*s.info(), *t.info())) found.push_back({*s.info(), *t.info()});
        });
        return found;
    }

    static Pairs contacts2d(const Points2& points, const Simplices& a, const Simplices& b) {
        const auto at = [&](const Ids& of, std::size_t i) { return K::Point_2(points[of[i]][0], points[of[i]][1]); };
        const auto with = [&](const Ids& of, const auto& call) {
            if (of.size() == 1) return call(at(of, 0));
            if (of.size() == 2) return call(K::Segment_2(at(of, 0), at(of, 1)));
            return call(K::Triangle_2(at(of, 0), at(of, 1), at(of, 2)));
        };
        return pairs<2>(points, a, b, [&](const Ids& s, const Ids& t) {
            return with(s, [&](const auto& one) { return with(t, [&](const auto& other) { return CGAL::do_intersect(one, other); }); });
        });
    }

    static Pairs contacts3d(const Points3& points, const Simplices& a, const Simplices& b) {
        const auto at = [&](const Ids& of, std::size_t i) {
            const Point3& p = points[of[i]];
            return K::Point_3(p[0], p[1], p[2]);
        };
        const auto with = [&](const Ids& of, const auto& call) {
            if (of.size() == 2) return call(K::Segment_3(at(of, 0), at(of, 1)));
            if (of.size() == 3) return call(K::Triangle_3(at(of, 0), at(of, 1), at(of, 2)));
            if (of.size() == 4) return call(K::Tetrahedron_3(at(of, 0), at(of, 1), at(of, 2), at(of, 3)));
            throw Declined("this engine does not ask CGAL about isolated points in space");
        };
        return pairs<3>(points, a, b, [&](const Ids& s, const Ids& t) {
            return with(s, [&](const auto& one) { return with(t, [&](const auto& other) { return CGAL::do_intersect(one, other); }); });
        });
    }

    static std::vector<Ids> crossings(const Segments& segments) {
        std::vector<Ids> lists;
        const auto exact = [](const auto& of) { return Exact::Segment_2({of[0][0], of[0][1]}, {of[1][0], of[1][1]}); };
        for (std::uint32_t i = 0; i < segments.size(); ++i) {
            const Exact::Segment_2 one = exact(segments[i]);
            std::vector<std::pair<Exact::FT, std::uint32_t>> along;
            for (std::uint32_t j = 0; j < segments.size(); ++j) {
                if (i == j || !CGAL::do_overlap(one.bbox(), exact(segments[j]).bbox())) continue;
                const auto found = CGAL::intersection(one, exact(segments[j]));
                const auto* const p = found ? boost::get<Exact::Point_2>(&*found) : nullptr;
                if (p != nullptr && !is_end(one, *p) && !is_end(exact(segments[j]), *p))
                    along.emplace_back(CGAL::squared_distance(one.source(), *p), j);
            }
            std::sort(along.begin(), along.end());
            lists.emplace_back();
            for (const auto& crossing : along) lists.back().push_back(crossing.second);
        }
        return lists;
    }

    static bool is_end(const Exact::Segment_2& of, const Exact::Point_2& p) { return p == of.source() || p == of.target(); }

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

    static Chains snap2d(const Segments& segments, double side) {
        using Traits = CGAL::Snap_rounding_traits_2<Exact>;
        std::vector<Traits::Segment_2> all;
        // A pixel of CGAL begins at its whole number, ours is around it. The side is a power of two.
        const auto shifted = [&](const Point2& p) {
            return Traits::Point_2(Exact::FT(p[0] / side) + 0.5, Exact::FT(p[1] / side) + 0.5);
        };
        for (const auto& [a, b] : segments) all.emplace_back(shifted(a), shifted(b));
        std::list<std::list<Traits::Point_2>> lines;
        CGAL::snap_rounding_2<Traits>(all.begin(), all.end(), lines, 1.0, false, true, 1);
        Chains chains;
        for (const auto& line : lines) {
            chains.emplace_back();
            for (const auto& p : line) chains.back().push_back({CGAL::to_double(p.x()) * side, CGAL::to_double(p.y()) * side});
        }
        return chains;
    }
};

int main(int argc, char** argv) { return serve<Cgal>(argc, argv); }
