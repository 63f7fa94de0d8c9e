
    // REPLACE. For each probe the number of its region, -1 outside of all, -2 on a border. A region is a list of rings
    // of points. This counts crossings.
    static Labels polygon_locate(const Polygons& regions, const Points2& probes) {
        Labels labels;
        for (const Point2& probe : probes) {
            labels.push_back(-1);
            for (std::size_t at = 0; at < regions.size() && labels.back() < 0; ++at)
                if (is_in(regions[at], probe)) labels.back() = static_cast<std::int64_t>(at);
        }
        return labels;
    }

    static bool is_in(const Polygon& rings, const Point2& p) {
        bool is_odd = false;
        for (const Points2& ring : rings)
            for (std::size_t at = 0; at < ring.size(); ++at) {
                const Point2 &a = ring[at], &b = ring[(at + 1) % ring.size()];
                const bool passes = (a[1] > p[1]) != (b[1] > p[1]);
                if (passes && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) is_odd = !is_odd;
            }
        return is_odd;
    }
