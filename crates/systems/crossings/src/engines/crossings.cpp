
    // REPLACE. For each segment the numbers of those that cross it, in their order along it. Each pair is tried.
    static std::vector<Ids> crossings(const Segments& segments) {
        std::vector<Ids> lists;
        for (const auto& [a, b] : segments) {
            std::vector<std::pair<double, std::uint32_t>> along;
            for (std::uint32_t other = 0; other < segments.size(); ++other) {
                const auto& [c, d] = segments[other];
                const double from = turn(c, d, a), to = turn(c, d, b);
                if (from * to < 0 && turn(a, b, c) * turn(a, b, d) < 0) along.push_back({from / (from - to), other});
            }
            std::sort(along.begin(), along.end());
            lists.emplace_back();
            for (const auto& crossing : along) lists.back().push_back(crossing.second);
        }
        return lists;
    }

    static double turn(const Point2& p, const Point2& q, const Point2& r) {
        return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
    }
