// Shapes that took long to make, kept on disk for the next time: distance fields, voxels and pointshells by what they are made of.
//
//   name    the key (shape_bytes.h: mesh, settings, version) in hex + ".shape", in a folder that is the user's alone
//   write   to a file of its own name beside it, synced, then renamed: there is the old one, or the new one, or none, whenever a
//           program or a computer stops; a temporary file that nobody finished goes after an hour
//   read    a plain file of the user's and no longer than `most_file_bytes`; what is in it is judged by shape_bytes.h. What is
//           refused is told, removed and made again: a cache can cost time, never a lesson
//   size    above `most_bytes` the files that have not been used for longest go
// Programs that run at once share the folder: whoever renames last wins, and both made the same.
//
// Thread: one at a time an object; load. Cost: reading 5 ns a byte. Errors: none; what went wrong is in `told()`.
// Source: where it lies: XDG Base Directory Specification 0.8.
#pragma once

#include "haptics/voxel/shape_bytes.h"
#include "haptics/voxel/voxelise.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

struct ShapeCacheSettings {
    std::filesystem::path folder;  ///< made when something is written; empty: nothing is kept
    std::uint64_t most_bytes = 1U << 30U;  ///< of all files together
    std::uint64_t most_file_bytes = 1U << 28U;
    double least_build_s = 0.05;  ///< what is made faster is not kept
};

/// $XDG_CACHE_HOME/fulcrum/shapes, or ~/.cache/fulcrum/shapes. Nothing is made.
[[nodiscard]] Expected<std::filesystem::path> default_shape_cache_folder();

class ShapeCache {
  public:
    explicit ShapeCache(ShapeCacheSettings settings) : settings_(std::move(settings)) {}

    /// The bytes kept under that key, if there are any; unchecked but for size and owner.
    [[nodiscard]] std::optional<Bytes> read(const Digest& key);
    /// Keeps them.
    void write(const Digest& key, std::span<const std::byte> bytes);
    /// Removes what is kept under that key, because of `why`.
    void forget(const Digest& key, const Error& why);

    /// One sentence for each thing that could not be kept or was not fit to be used.
    [[nodiscard]] const std::vector<std::string>& told() const noexcept { return told_; }
    [[nodiscard]] const ShapeCacheSettings& settings() const noexcept { return settings_; }

  private:
    [[nodiscard]] std::filesystem::path path_of(const Digest& key) const;
    void tell(const std::filesystem::path& path, const char* what, int error_number);
    void trim();

    ShapeCacheSettings settings_;
    std::vector<std::string> told_;
};

/// What is kept under `key`, if `decode(bytes, key)` accepts it; else what `build()` makes, which is kept if that took long.
template <class Decode, class Build>
[[nodiscard]] auto recall(ShapeCache& cache, const Digest& key, const Decode& decode,
                          const Build& build) -> decltype(build()) {
    if (const auto bytes = cache.read(key)) {
        auto kept = decode(*bytes, key);
        if (kept) {
            return kept;
        }
        cache.forget(key, kept.error());
    }
    const auto begun = std::chrono::steady_clock::now();
    auto built = build();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    if (built && took.count() >= cache.settings().least_build_s) {
        cache.write(key, encode(*built, key));
    }
    return built;
}

/// DistanceField::build, kept.
[[nodiscard]] Expected<DistanceField> recall_distance_field(ShapeCache& cache,
                                                            const TriangleMesh& mesh,
                                                            const VoxelFrame& frame,
                                                            const DistanceFieldSettings& settings,
                                                            const LoadProgress& progress = {});
/// voxelise, kept.
[[nodiscard]] Expected<VoxelGrid> recall_voxels(ShapeCache& cache, const TriangleMesh& mesh,
                                                const VoxeliseSettings& settings,
                                                const LoadProgress& progress = {});
/// make_surface_pointshell, kept.
[[nodiscard]] Expected<Pointshell> recall_surface_pointshell(ShapeCache& cache,
                                                             const TriangleMesh& mesh,
                                                             int n_points);

}  // namespace fulcrum::runtime
