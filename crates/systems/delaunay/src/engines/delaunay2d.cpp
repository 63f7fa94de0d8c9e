
    // REPLACE. Triangles of the Delaunay triangulation, as three indices of points. Every triangle is tried. A second
    // parameter `const Edges& constraints` takes constraints, too.
    static Triangles delaunay2d(const Points2& points) {
        if (points.size() > 24) throw Declined("too many points for this example");
        Triangles found;
        for (std::uint32_t a = 0; a < points.size(); ++a)
            for (std::uint32_t b = a + 1; b < points.size(); ++b)
                for (std::uint32_t c = a + 1; c < points.size(); ++c)
                    if (is_empty(points, points[a], points[b], points[c])) found.push_back({a, b, c});
        return found;
    }

    static bool is_empty(const Points2& points, const Point2& p, const Point2& q, const Point2& r) {
        if (turn(p, q, r) <= 0) return false;
        return std::all_of(points.begin(), points.end(), [&](const Point2& s) {
            return s == p || s == q || s == r || in_circle(p, q, r, s) <= 0;
        });
    }

    static double in_circle(const Point2& p, const Point2& q, const Point2& r, const Point2& s) {
        const auto row = [&](const Point2& t) -> Point3 {
            const double x = t[0] - s[0], y = t[1] - s[1];
            return {x, y, x * x + y * y};
        };
        const Point3 a = row(p), b = row(q), c = row(r);
        const double xy = a[0] * b[1] - a[1] * b[0], yz = b[0] * c[1] - b[1] * c[0], zx = c[0] * a[1] - c[1] * a[0];
        return a[2] * yz + b[2] * zx + c[2] * xy;
    }

    static double turn(const Point2& p, const Point2& q, const Point2& r) {
        return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
    }
