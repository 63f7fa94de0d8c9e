
    // REPLACE. For each probe 1 inside, 0 outside, -2 on the surface. This counts the triangles above a probe.
    static Labels mesh_locate(const Mesh& mesh, const Points3& probes) {
        Labels labels;
        for (const Point3& probe : probes) {
            std::int64_t above = 0;
            for (const auto& [a, b, c] : mesh.triangles)
                above += is_above(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], probe);
            labels.push_back(above % 2);
        }
        return labels;
    }

    static bool is_above(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
        const double u = turn(b, c, p), v = turn(c, a, p), w = turn(a, b, p);
        const bool is_over = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
        return is_over && (u * a[2] + v * b[2] + w * c[2]) / (u + v + w) > p[2];
    }

    static double turn(const Point3& p, const Point3& q, const Point3& r) {
        return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
    }
