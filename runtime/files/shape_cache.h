// Shapes that took long to make, kept on disk for the next time: distance fields, voxels, pointshells and what a mesh encloses.
//
//   key     all that a shape is made of: its kind, the version of the makers, the mesh's corners and triangles, and
//             a distance field    the frame's corner, voxel and cells, the band, the sheet
//             voxels              the voxel, layers that push, layers that brake
//             a pointshell        how many points
//             contact levels      how near is contact
//             what is enclosed    nothing else: any mass is put to it afterwards
//           The number of threads is not in it: whatever it is, the shape is the same to the bit
//   name    the key (shape_bytes.h) in hex + ".shape", in a folder that is the user's alone
//           (private_folder.h: how it is read and written, whenever a program or a computer stops)
//   read    no longer than `most_file_bytes`; what is in it is judged by shape_bytes.h, and must be what was asked for, as far as
//           that can be told (shape_fit.h). What is refused is told, removed and made again: a cache can cost time, never a lesson
//   write   made into bytes only where they would be kept. On a full disk the shapes that have not been used for longest go, as
//           many bytes as are missing, and it is tried once more; after that nothing more is kept
//   size    above `most_bytes` the shapes that have not been used for longest go; of the cache's own files those that nobody
//           finished for an hour. Whatever else lies in the folder stays
// Programs that run at once share the folder: whoever renames last wins, and both made the same.
//
// Thread: one at a time an object; load. Cost: reading 5 ns a byte. Errors: none; what went wrong is in `told()`.
// Source: where it lies: XDG Base Directory Specification 0.8.
#pragma once

#include "haptics/dynamics/mesh_inertia.h"
#include "haptics/levels/level_bytes.h"
#include "haptics/voxel/shape_bytes.h"
#include "haptics/voxel/voxelise.h"
#include "runtime/files/private_folder.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
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

struct ShapeCacheCounts {
    int n_read = 0;     ///< found
    int n_refused = 0;  ///< of these, not fit to be used
    int n_made = 0;     ///< took their time
    int n_kept = 0;     ///< of these, for the next time
};

class ShapeCache {
  public:
    explicit ShapeCache(ShapeCacheSettings settings)
        : settings_(std::move(settings)), is_off_(settings_.folder.empty()) {}

    /// The bytes kept under that key, if there are any; unchecked but for size and owner.
    [[nodiscard]] std::optional<Bytes> read(const Digest& key);
    /// Keeps what took `took_s` to make, `n_bytes` that `make_bytes` makes, if that is asked for.
    void write(const Digest& key, double took_s, std::uint64_t n_bytes,
               const std::function<Bytes()>& make_bytes);
    /// Removes what is kept under that key, because of `why`.
    void forget(const Digest& key, const Error& why);

    /// One sentence for each thing that could not be kept or was not fit to be used.
    [[nodiscard]] const std::vector<std::string>& told() const noexcept { return told_; }
    [[nodiscard]] const ShapeCacheCounts& counts() const noexcept { return counts_; }

  private:
    // With the folder open, or off and told why; without `is_made` a folder that is not there stays so.
    [[nodiscard]] bool open(bool is_made);
    void tell(const std::string& name, const std::string& what);
    void trim(std::uint64_t to_free);

    ShapeCacheSettings settings_;
    bool is_off_;  // nothing is read or kept any more
    std::optional<PrivateFolder> folder_;
    ShapeCacheCounts counts_;
    std::vector<std::string> told_;
};

/// A shape that is shared is kept as one that is not.
template <class Shape>
[[nodiscard]] const Shape& shape_in(const Shape& shape) {
    return shape;
}
template <class Shape>
[[nodiscard]] const Shape& shape_in(const std::shared_ptr<const Shape>& shape) {
    return *shape;
}

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
    if (built) {
        const auto& shape = shape_in(*built);
        cache.write(key, took.count(), count_bytes(shape), [&] { return encode(shape, key); });
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
                                                             const TriangleMesh& mesh, int n_points,
                                                             const LoadProgress& progress = {});
/// ContactLevels::create, kept.
[[nodiscard]] Expected<std::shared_ptr<const ContactLevels>> recall_contact_levels(
    ShapeCache& cache, const TriangleMesh& mesh, const ContactLevelSettings& settings,
    const LoadProgress& progress = {});
/// measure_solid, kept.
[[nodiscard]] Expected<MeasuredSolid> recall_measured_solid(ShapeCache& cache,
                                                            const TriangleMesh& mesh,
                                                            const LoadProgress& progress = {});

}  // namespace fulcrum::runtime
