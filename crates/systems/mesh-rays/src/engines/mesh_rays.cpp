
    // REPLACE. For each ray the triangles that it hits, in their order along it. Each triangle is tried.
    static std::vector<Ids> mesh_rays(const Mesh& mesh, const Rays& rays, const std::string& extent) {
        std::vector<Ids> lists;
        for (const auto& [p, q] : rays) {
            std::vector<std::pair<double, std::uint32_t>> hits;
            for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
                const auto& [a, b, c] = mesh.triangles[face];
                const double place = ray_hit(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], p, q);
                // A NaN, for a miss, is neither.
                if ((extent == "line" ? place == place : place >= 0) && (extent != "segment" || place <= 1))
                    hits.push_back({place, face});
            }
            std::sort(hits.begin(), hits.end());
            lists.emplace_back();
            for (const auto& hit : hits) lists.back().push_back(hit.second);
        }
        return lists;
    }

    // The place of the hit on the ray, from 0 at its first point to 1 at its second; NaN if there is none.
    static double ray_hit(const Point3& a, const Point3& b, const Point3& c, const Point3& p, const Point3& q) {
        const Point3 along = minus(q, p), u = minus(b, a), v = minus(c, a), from_a = minus(p, a);
        const Point3 across = cross(along, v), other = cross(from_a, u);
        const double volume = dot(u, across), second = dot(from_a, across) / volume, third = dot(along, other) / volume;
        return second >= 0 && third >= 0 && second + third <= 1 ? dot(v, other) / volume : std::nan("");
    }

    static Point3 minus(const Point3& p, const Point3& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

    static double dot(const Point3& p, const Point3& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

    static Point3 cross(const Point3& p, const Point3& q) {
        return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    }
