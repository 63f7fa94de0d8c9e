
    // REPLACE. The triangles of one polygon. `rings` are its rings, as indices of points. This cuts ears.
    static Triangles triangulate(const Points2& points, const Rings& rings) {
        if (rings.size() > 1) throw Declined("this example takes polygons without holes");
        Ids ring = rings.at(0);
        double area = 0;
        for (std::size_t at = 1; at < ring.size(); ++at)
            area += turn(points[ring[0]], points[ring[at - 1]], points[ring[at]]);
        if (area < 0) std::reverse(ring.begin(), ring.end());
        Triangles found;
        while (ring.size() > 3) {
            std::size_t ear = 0;
            while (ear < ring.size() && !is_ear(points, ring, ear)) ++ear;
            if (ear == ring.size()) ear = 0;
            found.push_back(corner(ring, ear));
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        found.push_back({ring.at(0), ring.at(1), ring.at(2)});
        return found;
    }

    static std::array<std::uint32_t, 3> corner(const Ids& ring, std::size_t at) {
        return {ring[(at + ring.size() - 1) % ring.size()], ring[at], ring[(at + 1) % ring.size()]};
    }

    static bool is_ear(const Points2& points, const Ids& ring, std::size_t at) {
        const auto [i, j, k] = corner(ring, at);
        const Point2 &a = points[i], &b = points[j], &c = points[k];
        if (turn(a, b, c) <= 0) return false;
        return std::none_of(ring.begin(), ring.end(), [&, a = a, b = b, c = c](std::uint32_t v) {
            const Point2& p = points[v];
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }

    static double turn(const Point2& p, const Point2& q, const Point2& r) {
        return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
    }
