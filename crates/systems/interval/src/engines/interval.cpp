
    // REPLACE. For each probe the number of its cell, -1 outside of all, -2 at an end. A cell has two ends.
    static Labels interval(const Cells& cells, const std::vector<double>& probes) {
        Labels labels;
        for (const double probe : probes) {
            labels.push_back(-1);
            for (std::size_t at = 0; at < cells.size(); ++at) {
                const auto [left, right] = cells[at];
                if (probe == left || probe == right) labels.back() = -2;
                if (left < probe && probe < right) labels.back() = static_cast<std::int64_t>(at);
            }
        }
        return labels;
    }
