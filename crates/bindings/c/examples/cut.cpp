// A cube is cut by planes: constructed vertices in space, and queries from four threads.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "predicament.h"

namespace {

void must(predicament_result result, const char *call) {
    if (result != PREDICAMENT_OK) {
        std::fprintf(stderr, "%s: %s\n", call, predicament_result_text(result));
        std::exit(EXIT_FAILURE);
    }
}

// A scene that frees itself.
struct Free {
    void operator()(predicament_scene *scene) const { predicament_scene_free(scene); }
};
using Scene = std::unique_ptr<predicament_scene, Free>;

Scene make(const std::vector<std::array<double, 3>> &points, predicament_backend backend) {
    predicament_scene *scene = nullptr;
    std::size_t bad = 0;
    must(predicament_scene_new(points[0].data(), points.size(), sizeof points[0], 3, backend, &scene, &bad), "scene_new");
    return Scene(scene);
}

} // namespace

int main() {
    // The corners of a cube, and three points of a plane that cuts it.
    std::vector<std::array<double, 3>> points;
    for (int at = 0; at < 8; at++) {
        points.push_back({double(at & 1), double(at >> 1 & 1), double(at >> 2 & 1)});
    }
    points.insert(points.end(), {{0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}});
    const Scene scene = make(points, PREDICAMENT_EXACT);

    // The cut meets three edges at the first corner; three faces meet in the corner itself.
    const std::vector<std::array<std::uint32_t, 5>> cuts{{0, 1, 8, 9, 10}, {0, 2, 8, 9, 10}, {0, 4, 8, 9, 10}};
    const std::array<std::uint32_t, 9> faces{0, 1, 3, 0, 1, 5, 0, 2, 6};
    std::vector<std::uint32_t> vertices(4);
    must(predicament_scene_add_lpi(scene.get(), cuts[0].data(), 3, vertices.data(), nullptr), "add_lpi");
    must(predicament_scene_add_tpi(scene.get(), faces.data(), 1, &vertices[3], nullptr), "add_tpi");
    std::int8_t sign = 0;
    must(predicament_scene_compare(scene.get(), PREDICAMENT_X, vertices[0], 8, &sign), "compare");
    std::printf("the cut meets the first edge in the point that spans it: %d\n", sign);
    must(predicament_scene_orient3d(scene.get(), vertices[0], vertices[1], vertices[2], vertices[3], &sign), "orient3d");
    std::printf("the corner is below the cut: %d\n", sign);

    // Every tetrahedron of corners, by four threads that share both scenes.
    const Scene perturbed = make(points, PREDICAMENT_SOS);
    std::array<std::array<long, 3>, 4> counts{};
    std::vector<std::thread> threads;
    for (std::uint32_t part = 0; part < 4; part++) {
        threads.emplace_back([&, part] {
            for (std::uint32_t id = part; id < 4096; id += 4) {
                const std::uint32_t a = id & 7, b = id >> 3 & 7, c = id >> 6 & 7, d = id >> 9;
                if (a == b || a == c || a == d || b == c || b == d || c == d) {
                    continue;
                }
                std::int8_t exact = 0, moved = 0;
                must(predicament_scene_orient3d(scene.get(), a, b, c, d, &exact), "orient3d");
                must(predicament_scene_orient3d(perturbed.get(), a, b, c, d, &moved), "orient3d");
                counts[part][0] += exact == 0;
                counts[part][1] += moved == 0;
                counts[part][2] += exact != 0 && exact != moved;
            }
        });
    }
    std::array<long, 3> total{};
    for (std::uint32_t part = 0; part < 4; part++) {
        threads[part].join();
        for (std::size_t at = 0; at < 3; at++) {
            total[at] += counts[part][at];
        }
    }
    std::printf("flat tetrahedra: %ld; perturbed: %ld; signs that differ: %ld\n", total[0], total[1], total[2]);
}
