
    // REPLACE. Pairs of simplices that meet, each with the indices of its points. Of edges, each pair is tried.
    static Pairs contacts2d(const Points2& points, const Simplices& a, const Simplices& b) {
        Pairs pairs;
        for (const Ids& s : a)
            for (const Ids& t : b) {
                if (s.size() != 2 || t.size() != 2) throw Declined("this example takes edges");
                if (meet(points[s[0]], points[s[1]], points[t[0]], points[t[1]])) pairs.push_back({s, t});
            }
        return pairs;
    }

    static bool meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
        for (const std::size_t axis : {0, 1})
            if (std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
                std::max(c[axis], d[axis]) < std::min(a[axis], b[axis]))
                return false;
        return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
    }

    static double turn(const Point2& p, const Point2& q, const Point2& r) {
        return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
    }
