
    // REPLACE. The polygons of union, intersection, difference and symmetric difference, or of some of them. A polygon
    // is a list of rings, the outer one first. This clips one convex polygon by another (Sutherland and Hodgman 1974).
    static Results<Polygons> overlay2d(const Polygon& first, const Polygon& second, bool) {
        const bool is_taken = first.size() == 1 && second.size() == 1 && is_convex(first[0]) && is_convex(second[0]);
        if (!is_taken) throw Declined("this example takes two convex polygons");
        Points2 ring = first[0], clip = second[0];
        if (turn(clip[0], clip[1], clip[2]) < 0) std::reverse(clip.begin(), clip.end());
        for (std::size_t at = 0; at < clip.size(); ++at) ring = clipped(ring, clip[at], clip[(at + 1) % clip.size()]);
        Results<Polygons> results;
        results.intersection = ring.empty() ? Polygons{} : Polygons{{ring}};
        return results;
    }

    /// The part of a ring on the left of the line from a to b.
    static Points2 clipped(const Points2& ring, const Point2& a, const Point2& b) {
        Points2 left;
        for (std::size_t at = 0; at < ring.size(); ++at) {
            const Point2 &p = ring[(at + ring.size() - 1) % ring.size()], &q = ring[at];
            const double from_p = turn(a, b, p), from_q = turn(a, b, q);
            const double part = from_p == from_q ? 0 : from_p / (from_p - from_q);
            if ((from_p < 0) != (from_q < 0))
                left.push_back({p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1])});
            if (from_q >= 0) left.push_back(q);
        }
        return left;
    }

    static bool is_convex(const Points2& ring) {
        std::size_t left = 0;
        for (std::size_t at = 0; at < ring.size(); ++at)
            left += turn(ring[at], ring[(at + 1) % ring.size()], ring[(at + 2) % ring.size()]) > 0;
        return left == 0 || left == ring.size();
    }

    static double turn(const Point2& p, const Point2& q, const Point2& r) {
        return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
    }
