// What the programs of the bench `mesh_race` in C++ share: files of meshes, and the loop that answers the bench.
//
// A line on stdin names the files of two meshes and of the result. A line on stdout answers with the seconds that the
// union took, from arrays to arrays and without files, or with `refused` and the reason.

#include <chrono>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

struct Arrays {
    std::vector<double> points;
    std::vector<std::uint32_t> corners;

    static Arrays read(const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        std::uint64_t counts[2] = {};
        file.read(reinterpret_cast<char*>(counts), sizeof counts);
        Arrays all{std::vector<double>(3 * counts[0]), std::vector<std::uint32_t>(3 * counts[1])};
        file.read(reinterpret_cast<char*>(all.points.data()), 24 * counts[0]);
        file.read(reinterpret_cast<char*>(all.corners.data()), 12 * counts[1]);
        if (!file) throw std::runtime_error("no mesh in " + path);
        return all;
    }

    void write(const std::string& path) const {
        std::ofstream file(path, std::ios::binary);
        const std::uint64_t counts[2] = {points.size() / 3, corners.size() / 3};
        file.write(reinterpret_cast<const char*>(counts), sizeof counts);
        file.write(reinterpret_cast<const char*>(points.data()), 24 * counts[0]);
        file.write(reinterpret_cast<const char*>(corners.data()), 12 * counts[1]);
    }
};

inline void serve(const std::function<Arrays(const Arrays&, const Arrays&)>& unite) {
    for (std::string first, second, result; std::cin >> first >> second >> result;) {
        const Arrays one = Arrays::read(first), other = Arrays::read(second);
        try {
            const auto start = std::chrono::steady_clock::now();
            const Arrays made = unite(one, other);
            const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
            made.write(result);
            std::cout << seconds.count() << std::endl;
        } catch (const std::exception& why) {
            std::string text = why.what();
            std::cout << "refused " << text.substr(0, text.find('\n')) << std::endl;
        }
    }
}
