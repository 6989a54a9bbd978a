#include "haptics/voxel/shape_bytes.h"

#include "haptics/voxel/byte_walk.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>
#include <type_traits>
#include <utility>

namespace fulcrum {

namespace {

static_assert(std::endian::native == std::endian::little, "bytes are kept as they lie in memory");

constexpr std::array<unsigned char, 8> kMark{0x89, 'F', 'L', 'C', 'S', '\r', '\n', 0x1A};
constexpr std::size_t kDigestBytes = sizeof(Digest);
constexpr std::size_t kHeadBytes = 8 + 4 + 4 + kDigestBytes + 8;
constexpr std::int32_t kMostFieldCells = 2048;
constexpr std::int32_t kMostGridCells = 512;
constexpr double kLargest_m = TriangleMesh::kLargestCoordinate_m;

tl::unexpected<Error> refuse(const char* why) {
    return fail(why, {}, "it is made again");
}

template <class Walker, class V>
void walk_vector(Walker& walker, V& vector) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        walker.field(vector[axis]);
    }
}

template <class Walker, class F>
void walk_frame(Walker& walker, F& frame) {
    walk_vector(walker, frame.lower_O);
    walker.field(frame.voxel_m);
    for (auto& n : frame.n_cells) {
        walker.field(n);
    }
}

bool is_length(double length_m) noexcept {
    return length_m > 0.0 && length_m <= kLargest_m;
}

bool is_place(const Vector3& p) noexcept {
    return p.allFinite() && p.cwiseAbs().maxCoeff() <= kLargest_m;
}

bool is_frame(const VoxelFrame& frame, std::int32_t least, std::int32_t most) noexcept {
    return is_place(frame.lower_O) && is_length(frame.voxel_m) &&
           std::all_of(frame.n_cells.begin(), frame.n_cells.end(),
                       [=](std::int32_t n) { return n >= least && n <= most; });
}

// What is kept of each kind.
template <class Walker>
void walk_payload(Walker& walker, const VoxelGrid& grid) {
    walk_frame(walker, grid.frame);
    for (std::size_t first = 0; first < grid.cells.size();) {
        const VoxelClass kind = grid.cells[first];
        std::size_t end = first + 1;
        while (end < grid.cells.size() && grid.cells[end] == kind) {
            ++end;
        }
        // The kind in the two lowest bits.
        walker.field(static_cast<std::uint32_t>(end - first) << 2U |
                     static_cast<std::uint32_t>(kind));
        first = end;
    }
}

template <class Walker>
void walk_payload(Walker& walker, const Pointshell& shell) {
    for (const auto* const values :
         {&shell.x_m, &shell.y_m, &shell.z_m, &shell.nx, &shell.ny, &shell.nz}) {
        walker.array(std::span<const float>(*values));
    }
}

template <class Walker>
void walk_payload(Walker& walker, const DistanceField& field);

template <class Shape>
std::size_t count_all(const Shape& shape) {
    ByteCounter counter;
    walk_payload(counter, shape);
    return kHeadBytes + counter.n_bytes() + kDigestBytes;
}

// The head, the payload and the checksum.
template <class Shape>
Bytes seal(ShapeKind kind, const Digest& key, const Shape& shape) {
    Bytes bytes;
    bytes.reserve(count_all(shape));
    ByteWriter writer(bytes);
    writer.field(kMark);
    writer.field(kShapeVersion);
    writer.field(kind);
    writer.field(key);
    writer.field(std::uint64_t{0});
    walk_payload(writer, shape);
    const std::uint64_t length = bytes.size() - kHeadBytes;
    std::memcpy(bytes.data() + kHeadBytes - sizeof length, &length, sizeof length);
    writer.field(compute_sha256(bytes));
    return bytes;
}

// The payload of bytes that are what they should be.
Expected<std::span<const std::byte>> unseal(std::span<const std::byte> bytes, ShapeKind kind,
                                            const Digest& key) {
    if (bytes.size() < kHeadBytes + kDigestBytes) {
        return refuse("the kept shape is cut off");
    }
    ByteReader reader(bytes);
    std::remove_const_t<decltype(kMark)> mark{};
    std::uint32_t version = 0;
    auto found_kind = std::uint32_t{0};
    Digest found_key{};
    std::uint64_t length = 0;
    reader.field(mark);
    reader.field(version);
    reader.field(found_kind);
    reader.field(found_key);
    reader.field(length);
    if (mark != kMark || version != kShapeVersion ||
        found_kind != static_cast<std::uint32_t>(kind)) {
        return refuse("the kept shape is of another kind or version");
    }
    if (length != bytes.size() - kHeadBytes - kDigestBytes) {
        return refuse("the kept shape is cut off or too long");
    }
    if (found_key != key) {
        return refuse("the kept shape is that of another mesh");
    }
    Digest checksum{};
    std::memcpy(checksum.data(), bytes.data() + bytes.size() - kDigestBytes, kDigestBytes);
    if (compute_sha256(bytes.first(bytes.size() - kDigestBytes)) != checksum) {
        return refuse("the kept shape has changed");
    }
    return bytes.subspan(kHeadBytes, static_cast<std::size_t>(length));
}

// Corners in steps; all bricks have the same number of them.
bool is_brick(const DistanceField::Brick& brick) noexcept {
    return std::all_of(brick.values.begin(), brick.values.end(),
                       [](std::int16_t value) { return value >= -DistanceField::kLargestValue; });
}

// +b or -b throughout.
bool is_filled(const DistanceField::Brick& brick, int value) noexcept {
    return std::all_of(brick.values.begin(), brick.values.begin() + kBrickCorners,
                       [=](std::int16_t v) { return v == value; });
}

// A unit normal in single precision.
bool is_direction(const Vector3& normal) noexcept {
    constexpr double kRounding = 1.0e-6;
    return std::abs(normal.squaredNorm() - 1.0) <= kRounding;
}

}  // namespace

// Reads and writes what only a field's maker may set.
class DistanceFieldBytes {
  public:
    template <class Walker, class Field>
    static void walk_head(Walker& walker, Field& field);
    template <class Walker>
    static void walk(Walker& walker, const DistanceField& field);
    [[nodiscard]] static bool read(ByteReader& reader, DistanceField& field);

  private:
    [[nodiscard]] static bool is_head(const DistanceField& field) noexcept;
    [[nodiscard]] static bool are_bricks(const DistanceField& field) noexcept;
    [[nodiscard]] static bool is_table(const DistanceField& field) noexcept;
};

template <class Walker, class Field>
void DistanceFieldBytes::walk_head(Walker& walker, Field& field) {
    walk_frame(walker, field.frame_);
    walker.field(field.band_m_);
    walker.field(field.slope_bound_);
    walker.field(field.counts_.n_bricks);
    walker.field(field.counts_.n_open_edges);
    walk_vector(walker, field.ball_centre_O_);
    walker.field(field.ball_radius_m_);
    walker.field(field.sheet_m_);
}

template <class Walker>
void DistanceFieldBytes::walk(Walker& walker, const DistanceField& field) {
    walk_head(walker, field);
    walker.field(static_cast<std::uint64_t>(field.bricks_.size()));
    walker.array(std::span<const DistanceField::Entry>(field.table_));
    walker.array(std::span<const DistanceField::Brick>(field.bricks_));
    walker.array(std::span<const float>(field.depths_));
}

bool DistanceFieldBytes::is_head(const DistanceField& field) noexcept {
    constexpr double kSteepest = 1.01 * std::numbers::sqrt3;  // a little for 16 bits
    const auto is_multiple = [](std::int32_t n) { return n % kBrickCells == 0; };
    const auto& n_cells = field.frame_.n_cells;
    return is_frame(field.frame_, kBrickCells, kMostFieldCells) &&
           std::all_of(n_cells.begin(), n_cells.end(), is_multiple) && is_length(field.band_m_) &&
           field.sheet_m_ >= 0.0 && field.sheet_m_ <= field.band_m_ &&
           is_place(field.ball_centre_O_) && is_length(field.ball_radius_m_) &&
           field.counts_.n_bricks >= 0 && field.counts_.n_open_edges >= 0 &&
           field.slope_bound_ >= 1.0 && field.slope_bound_ <= kSteepest;
}

// Two are those of +b and -b, the others near the surface.
bool DistanceFieldBytes::are_bricks(const DistanceField& field) noexcept {
    return field.bricks_.size() == static_cast<std::size_t>(field.counts_.n_bricks) + 2 &&
           std::all_of(field.bricks_.begin(), field.bricks_.end(), is_brick) &&
           is_filled(field.bricks_[DistanceField::kFree], DistanceField::kLargestValue) &&
           is_filled(field.bricks_[DistanceField::kInside], -DistanceField::kLargestValue);
}

// No place of the block is farther from the mesh, which the block holds, than the block is long. Outside the depth is what the entry
// says; inside, where the entry may say less, at least that.
bool DistanceFieldBytes::is_table(const DistanceField& field) noexcept {
    const auto [x, y, z] = field.frame_.n_cells;
    const auto longest_voxels = static_cast<float>(std::hypot(x, y, z));
    constexpr float kAboveRounding = 1.0F + 1.0e-5F;
    const auto is_entry = [&](const DistanceField::Entry& entry) {
        return entry.brick >= 0 && static_cast<std::size_t>(entry.brick) < field.bricks_.size() &&
               std::abs(entry.centre_voxels) <= longest_voxels;
    };
    const auto is_depth = [&](const DistanceField::Entry& entry, float depth) {
        return entry.centre_voxels < 0.0F
                   ? kAboveRounding * depth >= -entry.centre_voxels && depth <= longest_voxels
                   : depth == -entry.centre_voxels;
    };
    return field.table_.back().brick == DistanceField::kFree &&
           std::all_of(field.table_.begin(), field.table_.end(), is_entry) &&
           std::equal(field.depths_.begin(), field.depths_.end(), field.table_.begin(),
                      [&](float depth, const DistanceField::Entry& entry) {
                          return is_depth(entry, depth);
                      });
}

bool DistanceFieldBytes::read(ByteReader& reader, DistanceField& field) {
    walk_head(reader, field);
    std::uint64_t n_bricks = 0;
    reader.field(n_bricks);
    if (!reader.is_whole() || !is_head(field)) {
        return false;
    }
    const auto [nx, ny, nz] = field.n_bricks();
    const auto n_entries =
        static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz) +
        1;
    reader.array(field.table_, n_entries);
    reader.array(field.bricks_, n_bricks);
    reader.array(field.depths_, n_entries - 1);
    return reader.is_whole() && reader.n_left() == 0 && are_bricks(field) && is_table(field);
}

namespace {

template <class Walker>
void walk_payload(Walker& walker, const DistanceField& field) {
    DistanceFieldBytes::walk(walker, field);
}

}  // namespace

Digest compute_shape_key(ShapeKind kind, const TriangleMesh& mesh,
                         std::span<const double> settings) {
    Sha256 hash;
    const std::array<std::uint64_t, 5> head{kShapeVersion, static_cast<std::uint64_t>(kind),
                                            mesh.vertices_B().size(), mesh.triangles().size(),
                                            settings.size()};
    hash.add(std::as_bytes(std::span(head)));
    for (const Vector3& vertex : mesh.vertices_B()) {
        hash.add(std::as_bytes(std::span(vertex.data(), 3)));
    }
    hash.add(std::as_bytes(std::span(mesh.triangles())));
    hash.add(std::as_bytes(settings));
    return hash.finish();
}

std::size_t count_bytes(const DistanceField& field) {
    return count_all(field);
}

std::size_t count_bytes(const VoxelGrid& grid) {
    return count_all(grid);
}

std::size_t count_bytes(const Pointshell& shell) {
    return count_all(shell);
}

Bytes encode(const DistanceField& field, const Digest& key) {
    return seal(ShapeKind::distance_field, key, field);
}

Bytes encode(const VoxelGrid& grid, const Digest& key) {
    return seal(ShapeKind::voxel_grid, key, grid);
}

Bytes encode(const Pointshell& shell, const Digest& key) {
    return seal(ShapeKind::pointshell, key, shell);
}

Expected<DistanceField> decode_distance_field(std::span<const std::byte> bytes, const Digest& key) {
    const auto payload = unseal(bytes, ShapeKind::distance_field, key);
    if (!payload) {
        return tl::unexpected(payload.error());
    }
    ByteReader reader(*payload);
    DistanceField field;
    if (!DistanceFieldBytes::read(reader, field)) {
        return refuse("the kept distance field is none");
    }
    return field;
}

Expected<VoxelGrid> decode_voxel_grid(std::span<const std::byte> bytes, const Digest& key) {
    const auto payload = unseal(bytes, ShapeKind::voxel_grid, key);
    if (!payload) {
        return tl::unexpected(payload.error());
    }
    ByteReader reader(*payload);
    VoxelGrid grid;
    walk_frame(reader, grid.frame);
    if (!reader.is_whole() || !is_frame(grid.frame, 1, kMostGridCells)) {
        return refuse("the kept voxels are none");
    }
    const auto [nx, ny, nz] = grid.frame.n_cells;
    const std::size_t n_cells =
        static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz);
    grid.cells.assign(n_cells, VoxelClass::free);
    std::size_t first = 0;
    while (reader.n_left() > 0) {
        std::uint32_t run = 0;
        reader.field(run);
        const std::size_t n = run >> 2U;
        if (!reader.is_whole() || n == 0 || n > n_cells - first) {
            return refuse("the kept voxels are none");
        }
        std::fill_n(grid.cells.begin() + static_cast<std::ptrdiff_t>(first), n,
                    static_cast<VoxelClass>(run & 3U));
        first += n;
    }
    if (first != n_cells) {
        return refuse("the kept voxels are none");
    }
    return grid;
}

Expected<Pointshell> decode_pointshell(std::span<const std::byte> bytes, const Digest& key) {
    const auto payload = unseal(bytes, ShapeKind::pointshell, key);
    if (!payload) {
        return tl::unexpected(payload.error());
    }
    constexpr std::size_t kPointBytes = 6 * sizeof(float);
    const std::size_t n = payload->size() / kPointBytes;
    if (n == 0 || payload->size() % kPointBytes != 0 ||
        n > static_cast<std::size_t>(kMostShellPoints)) {
        return refuse("the kept pointshell is none");
    }
    ByteReader reader(*payload);
    Pointshell shell;
    for (auto* const values :
         {&shell.x_m, &shell.y_m, &shell.z_m, &shell.nx, &shell.ny, &shell.nz}) {
        reader.array(*values, n);
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (!is_place(shell.position_T(i)) || !is_direction(shell.normal_T(i))) {
            return refuse("the kept pointshell is none");
        }
    }
    return shell;
}

}  // namespace fulcrum
