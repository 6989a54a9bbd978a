// How much of anything a model may have. Each limit is far above what a lesson needs and far below
// what hurts: the worst file that keeps to them all loads in seconds and in about half a gigabyte.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fulcrum::runtime::gltf {

inline constexpr std::size_t kMaxFile_bytes = std::size_t{64} << 20;
/// Nesting of the JSON text; a plain model has about 7, and each level costs parsers some stack.
inline constexpr int kMaxJsonDepth = 64;
/// Values in the JSON text; each costs about 100 bytes once parsed.
inline constexpr std::size_t kMaxJsonValues = 250'000;
/// Entries of one list of the document (nodes, meshes, accessors …).
inline constexpr std::size_t kMaxItems = 10'000;
inline constexpr std::size_t kMaxImages = 64;
inline constexpr int kMaxNodeDepth = 64;
/// Corners after flattening, all primitives together; a mesh used by ten nodes counts ten times.
inline constexpr std::size_t kMaxCorners = 3'000'000;
/// Width and height of a picture, pixels.
inline constexpr std::uint32_t kMaxPictureSide_px = 4096;
/// Buffers, pixels and flattened corners together.
inline constexpr std::size_t kMaxModelMemory_bytes = std::size_t{512} << 20;
/// Distance of a corner from the model's origin; more is a wrong unit or an attack.
inline constexpr double kMaxExtent_m = 10'000.0;

/// Counts what has been promised memory so far.
class MemoryBudget {
  public:
    /// True when `bytes` more still fit; only then are they counted.
    [[nodiscard]] bool charge(std::size_t bytes) noexcept {
        if (bytes > kMaxModelMemory_bytes - used_bytes_) {
            return false;
        }
        used_bytes_ += bytes;
        return true;
    }

  private:
    std::size_t used_bytes_ = 0;  ///< never above kMaxModelMemory_bytes
};

/// What is wrong with, and what a user can do about, a model that is too much or malformed.
inline constexpr const char* kTooMuchMemory = "it needs more than 512 MiB of memory";
inline constexpr const char* kReduce = "reduce its triangles and pictures";
inline constexpr const char* kExportAgain = "export the model again as glTF 2.0 (.glb)";

}  // namespace fulcrum::runtime::gltf
