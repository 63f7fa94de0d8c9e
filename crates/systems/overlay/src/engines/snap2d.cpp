
    // REPLACE. For each segment a list of points with coordinates that are multiples of `side`. This rounds ends and
    // crossings, one by one.
    static Chains snap2d(const Segments& segments, double side) {
        Chains chains;
        for (const auto& [a, b] : segments) {
            std::vector<double> parts{0, 1};
            for (const auto& [c, d] : segments) {
                const double from = turn(c, d, a), to = turn(c, d, b);
                if (from * to < 0 && turn(a, b, c) * turn(a, b, d) < 0) parts.push_back(from / (from - to));
            }
            std::sort(parts.begin(), parts.end());
            chains.emplace_back();
            for (const double part : parts) {
                const double x = a[0] + part * (b[0] - a[0]), y = a[1] + part * (b[1] - a[1]);
                chains.back().push_back({std::round(x / side) * side, std::round(y / side) * side});
            }
        }
        return chains;
    }

    static double turn(const Point2& p, const Point2& q, const Point2& r) {
        return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
    }
