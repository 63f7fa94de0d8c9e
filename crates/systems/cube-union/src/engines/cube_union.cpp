
    // REPLACE. The volume and the area of a union of cubes, and the length of its edges if you like. A cube has x, y
    // and z of its lower corner and the length of its edges. This looks at each cell between the planes of all faces.
    static Measures cube_union(const Cubes& cubes) {
        if (cubes.size() > 12) throw Declined("too many cubes for this example");
        std::array<std::vector<double>, 3> planes;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const auto& cube : cubes)
                for (const double x : {cube[axis], cube[axis] + cube[3]}) planes[axis].push_back(x);
            std::sort(planes[axis].begin(), planes[axis].end());
        }
        Measures found;
        for (std::size_t i = 0; i + 1 < planes[0].size(); ++i)
            for (std::size_t j = 0; j + 1 < planes[1].size(); ++j)
                for (std::size_t k = 0; k + 1 < planes[2].size(); ++k) {
                    const double x = planes[0][i], y = planes[1][j], z = planes[2][k];
                    if (!is_in(cubes, {x, y, z})) continue;
                    const double a = planes[0][i + 1] - x, b = planes[1][j + 1] - y, c = planes[2][k + 1] - z;
                    found.volume += a * b * c;
                    // Each face on the lower side has one on the upper side. A cell without a size has no faces.
                    if (a > 0 && !is_in(cubes, {below(planes[0], x), y, z})) found.area += 2 * b * c;
                    if (b > 0 && !is_in(cubes, {x, below(planes[1], y), z})) found.area += 2 * a * c;
                    if (c > 0 && !is_in(cubes, {x, y, below(planes[2], z)})) found.area += 2 * a * b;
                }
        return found;
    }

    /// The last plane below one of the planes; a place outside of all cubes if it is the first.
    static double below(const std::vector<double>& planes, double x) {
        const auto at = std::lower_bound(planes.begin(), planes.end(), x);
        return at == planes.begin() ? -HUGE_VAL : *(at - 1);
    }

    static bool is_in(const Cubes& cubes, const Point3& p) {
        return std::any_of(cubes.begin(), cubes.end(), [&](const auto& cube) {
            const auto spans = [&](int axis) { return cube[axis] <= p[axis] && p[axis] < cube[axis] + cube[3]; };
            return spans(0) && spans(1) && spans(2);
        });
    }
