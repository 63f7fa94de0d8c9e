
    // REPLACE. Pairs of simplices that meet, each with the indices of its points. Of triangles, each pair is tried: an
    // edge of one goes through the other.
    static Pairs contacts3d(const Points3& points, const Simplices& a, const Simplices& b) {
        Pairs pairs;
        for (const Ids& s : a)
            for (const Ids& t : b) {
                if (s.size() != 3 || t.size() != 3) throw Declined("this example takes triangles");
                if (goes_through(points, s, t) || goes_through(points, t, s)) pairs.push_back({s, t});
            }
        return pairs;
    }

    static bool goes_through(const Points3& points, const Ids& s, const Ids& t) {
        for (std::size_t at = 0; at < 3; ++at)
            if (pierces(points[s[at]], points[s[(at + 1) % 3]], points[t[0]], points[t[1]], points[t[2]])) return true;
        return false;
    }

    static bool pierces(const Point3& p, const Point3& q, const Point3& a, const Point3& b, const Point3& c) {
        const double from = volume(a, b, c, p), to = volume(a, b, c, q);
        const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
        const bool is_through = from * to <= 0 && (from != 0 || to != 0);
        return is_through && ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0));
    }

    static double volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
        const Point3 p = minus(a, d), q = minus(b, d), r = minus(c, d);
        const double xy = p[0] * q[1] - p[1] * q[0], yz = q[0] * r[1] - q[1] * r[0], zx = r[0] * p[1] - r[1] * p[0];
        return p[2] * yz + q[2] * zx + r[2] * xy;
    }

    static Point3 minus(const Point3& p, const Point3& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
