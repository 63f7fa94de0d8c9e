
    // REPLACE. The triangles of the hull's surface, as three indices of points. Every triangle is tried.
    static Triangles hull3d(const Points3& points) {
        if (points.size() > 24) throw Declined("too many points for this example");
        Triangles found;
        for (std::uint32_t a = 0; a < points.size(); ++a)
            for (std::uint32_t b = a + 1; b < points.size(); ++b)
                for (std::uint32_t c = a + 1; c < points.size(); ++c)
                    if (b != c && is_face(points, a, b, c)) found.push_back({a, b, c});
        return found;
    }

    static bool is_face(const Points3& points, std::size_t a, std::size_t b, std::size_t c) {
        for (std::size_t at = 0; at < points.size(); ++at) {
            if (at == a || at == b || at == c) continue;
            if (!(volume(points[a], points[b], points[c], points[at]) > 0)) return false;
        }
        return true;
    }

    static double volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
        const Point3 p = minus(a, d), q = minus(b, d), r = minus(c, d);
        const double xy = p[0] * q[1] - p[1] * q[0], yz = q[0] * r[1] - q[1] * r[0], zx = r[0] * p[1] - r[1] * p[0];
        return p[2] * yz + q[2] * zx + r[2] * xy;
    }

    static Point3 minus(const Point3& p, const Point3& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
