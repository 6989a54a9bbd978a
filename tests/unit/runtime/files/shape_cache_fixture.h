// Shapes to be kept, and how often they were made.
#pragma once

#include "haptics/geometry/shape.h"
#include "runtime/files/shape_cache.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <vector>

namespace fulcrum::runtime {

namespace fs = std::filesystem;

inline ShapeCacheSettings keep_all(const fs::path& folder) {
    return {.folder = folder, .least_build_s = 0.0};
}

inline TriangleMesh ball() {
    return make_sphere(1.0, 3).value();
}

inline Pointshell shell_of(int n) {
    return make_surface_pointshell(ball(), n).value();
}

inline Digest key_of(double number) {
    return compute_shape_key(ShapeKind::pointshell, ball(), std::vector<double>{number});
}

inline void keep(ShapeCache& cache, const Digest& key, const Bytes& bytes) {
    cache.write(key, 1.0, bytes.size(), [&] { return bytes; });
}

// The only shape in the folder.
inline fs::path find_only(const fs::path& folder) {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(folder)) {
        all.push_back(entry.path());
    }
    REQUIRE(all.size() == 1);
    REQUIRE(all.front().extension() == ".shape");
    return all.front();
}

// How often the shell was made.
struct Maker {
    int n_made = 0;
    Expected<Pointshell> make(ShapeCache& cache, const Digest& key) {
        return recall(cache, key, decode_pointshell, [this] {
            ++n_made;
            return Expected<Pointshell>(shell_of(200));
        });
    }
};

}  // namespace fulcrum::runtime
