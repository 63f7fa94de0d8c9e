
    // REPLACE. The parts of a closed mesh that is cut by planes. A plane is three points. This gives the mesh as it is
    // if every plane misses it.
    static std::vector<Mesh> slice(const Mesh& mesh, const Planes& planes) {
        for (const auto& [a, b, c] : planes) {
            bool is_below = false, is_above = false;
            for (const auto& triangle : mesh.triangles)
                for (const std::uint32_t v : triangle) {
                    const double side = volume(a, b, c, mesh.vertices[v]);
                    is_below = is_below || side > 0, is_above = is_above || side < 0;
                }
            if (is_below && is_above) throw Declined("this example takes planes that miss the mesh");
        }
        return {mesh};
    }

    static double volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
        const Point3 p = minus(a, d), q = minus(b, d), r = minus(c, d);
        const double xy = p[0] * q[1] - p[1] * q[0], yz = q[0] * r[1] - q[1] * r[0], zx = r[0] * p[1] - r[1] * p[0];
        return p[2] * yz + q[2] * zx + r[2] * xy;
    }

    static Point3 minus(const Point3& p, const Point3& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
