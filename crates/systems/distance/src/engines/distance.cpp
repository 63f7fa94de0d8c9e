
    // REPLACE. The distance of two objects: of polygons, by loops of points, or of meshes, by triangles. Each vertex is
    // measured to each edge of the other object. In the plane, z is 0.
    static double distance(const Points3& points, const Simplices& a, const Simplices& b, int) {
        return std::min(to_object(points, a, b), to_object(points, b, a));
    }

    static double to_object(const Points3& points, const Simplices& vertices, const Simplices& parts) {
        double least = HUGE_VAL;
        for (const auto& part : parts)
            for (std::size_t at = 0; at < part.size(); ++at)
                for (const auto& others : vertices)
                    for (const auto p : others)
                        least = std::min(least, to_edge(points[p], points[part[at]], points[part[(at + 1) % part.size()]]));
        return least;
    }

    static double to_edge(const Point3& p, const Point3& a, const Point3& b) {
        double above = 0, below = 0, sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
            above += (p[axis] - a[axis]) * (b[axis] - a[axis]);
            below += (b[axis] - a[axis]) * (b[axis] - a[axis]);
        }
        const double place = below > 0 ? std::min(std::max(above / below, 0.0), 1.0) : 0;
        for (int axis = 0; axis < 3; ++axis) sum += std::pow(p[axis] - a[axis] - place * (b[axis] - a[axis]), 2);
        return std::sqrt(sum);
    }
