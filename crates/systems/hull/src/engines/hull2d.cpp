
    // REPLACE. The indices of the hull's corners, one after the other. This is Andrew's monotone chain.
    static Ids hull2d(const Points2& points) {
        Ids order(points.size());
        for (std::uint32_t at = 0; at < order.size(); ++at) order[at] = at;
        std::sort(order.begin(), order.end(), [&](auto a, auto b) { return points[a] < points[b]; });
        if (order.size() < 2) return order;
        Ids hull = chain(points, order);
        std::reverse(order.begin(), order.end());
        const Ids upper = chain(points, order);
        hull.insert(hull.end(), upper.begin(), upper.end());
        return hull;
    }

    /// The corners to the right of all others, without the last one.
    static Ids chain(const Points2& points, const Ids& order) {
        Ids found;
        for (const std::uint32_t at : order) {
            while (found.size() > 1 && turn(points[found[found.size() - 2]], points[found.back()], points[at]) <= 0)
                found.pop_back();
            found.push_back(at);
        }
        found.pop_back();
        return found;
    }

    static double turn(const Point2& p, const Point2& q, const Point2& r) {
        return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
    }
