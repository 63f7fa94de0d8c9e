
    // REPLACE. The meshes of union, intersection, difference and symmetric difference, or of some of them. This puts
    // one solid beside the other: a union if they are apart.
    static Results<Mesh> mesh_intersect(const Mesh& first, const Mesh& second) {
        const auto before = static_cast<std::uint32_t>(first.vertices.size());
        Mesh both = first;
        both.vertices.insert(both.vertices.end(), second.vertices.begin(), second.vertices.end());
        for (const auto& [a, b, c] : second.triangles) both.triangles.push_back({a + before, b + before, c + before});
        Results<Mesh> results;
        results.union_ = both;
        return results;
    }
