// Crossings of segments on exact numbers (Epeck), sorted without rounding, and CGAL's snap rounding, which is exact as well.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Snap_rounding_2.h>
#include <CGAL/Snap_rounding_traits_2.h>
#include <CGAL/version.h>

#include <predicament_engine.hpp>

using namespace predicament;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

struct Cgal {
    static constexpr const char* name = "cgal-crossings";
    static std::string version() { return CGAL_VERSION_STR; }

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
