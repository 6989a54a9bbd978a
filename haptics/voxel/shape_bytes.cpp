#include "haptics/voxel/shape_bytes.h"

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

class Writer {
  public:
    explicit Writer(Bytes& bytes) noexcept : bytes_(bytes) {}
    template <class T>
    void field(const T& value) {
        array(std::span<const T>(&value, 1));
    }
    template <class T>
    void array(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        const auto raw = std::as_bytes(values);
        bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    }

  private:
    Bytes& bytes_;
};

// After the first field that is not there all others are zero, and `is_whole` says so.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) noexcept : left_(bytes) {}
    template <class T>
    void field(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        is_whole_ = is_whole_ && left_.size() >= sizeof(T);
        value = T{};
        if (is_whole_) {
            std::memcpy(&value, left_.data(), sizeof(T));
            left_ = left_.subspan(sizeof(T));
        }
    }
    /// `n` values, if there are as many.
    template <class T>
    void array(std::vector<T>& values, std::size_t n) {
        static_assert(std::is_trivially_copyable_v<T>);
        is_whole_ = is_whole_ && left_.size() / sizeof(T) >= n;
        values.clear();
        if (is_whole_ && n > 0) {
            values.resize(n);
            std::memcpy(static_cast<void*>(values.data()), left_.data(), n * sizeof(T));
            left_ = left_.subspan(n * sizeof(T));
        }
    }
    [[nodiscard]] bool is_whole() const noexcept { return is_whole_; }
    [[nodiscard]] std::size_t n_left() const noexcept { return left_.size(); }

  private:
    std::span<const std::byte> left_;
    bool is_whole_ = true;
};

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

// The head, the payload that `write` adds, and the checksum.
template <class Write>
Bytes seal(ShapeKind kind, const Digest& key, const Write& write) {
    Bytes bytes;
    Writer writer(bytes);
    writer.field(kMark);
    writer.field(kShapeVersion);
    writer.field(kind);
    writer.field(key);
    writer.field(std::uint64_t{0});
    write(writer);
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
    Reader reader(bytes);
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

}  // namespace

// Reads and writes what only a field's maker may set.
class DistanceFieldBytes {
  public:
    template <class Walker>
    static void walk_head(Walker& walker, DistanceField& field);
    static void write(const DistanceField& field, Writer& writer);
    [[nodiscard]] static bool read(Reader& reader, DistanceField& field);
};

template <class Walker>
void DistanceFieldBytes::walk_head(Walker& walker, DistanceField& field) {
    walk_frame(walker, field.frame_);
    walker.field(field.band_m_);
    walker.field(field.slope_bound_);
    walker.field(field.counts_.n_bricks);
    walker.field(field.counts_.n_open_edges);
    walk_vector(walker, field.ball_centre_O_);
    walker.field(field.ball_radius_m_);
    walker.field(field.sheet_m_);
}

void DistanceFieldBytes::write(const DistanceField& field, Writer& writer) {
    DistanceField head;
    head.frame_ = field.frame_;
    head.band_m_ = field.band_m_;
    head.slope_bound_ = field.slope_bound_;
    head.counts_ = field.counts_;
    head.ball_centre_O_ = field.ball_centre_O_;
    head.ball_radius_m_ = field.ball_radius_m_;
    head.sheet_m_ = field.sheet_m_;
    walk_head(writer, head);
    writer.field(static_cast<std::uint64_t>(field.bricks_.size()));
    writer.array(std::span<const DistanceField::Entry>(field.table_));
    writer.array(std::span<const DistanceField::Brick>(field.bricks_));
    writer.array(std::span<const float>(field.depths_));
}

bool DistanceFieldBytes::read(Reader& reader, DistanceField& field) {
    walk_head(reader, field);
    std::uint64_t n_bricks = 0;
    reader.field(n_bricks);
    const auto is_multiple = [](std::int32_t n) { return n % kBrickCells == 0; };
    if (!reader.is_whole() || !is_frame(field.frame_, kBrickCells, kMostFieldCells) ||
        !std::all_of(field.frame_.n_cells.begin(), field.frame_.n_cells.end(), is_multiple) ||
        !is_length(field.band_m_) || !(field.sheet_m_ >= 0.0) ||
        !(field.sheet_m_ <= field.band_m_) || !is_place(field.ball_centre_O_) ||
        !is_length(field.ball_radius_m_) || field.counts_.n_bricks < 0 ||
        field.counts_.n_open_edges < 0 || !(field.slope_bound_ > 0.0) ||
        !(field.slope_bound_ <= 1.01 * std::numbers::sqrt3)) {
        return false;
    }
    const auto [nx, ny, nz] = field.n_bricks();
    const auto n_entries =
        static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz) +
        1;
    reader.array(field.table_, n_entries);
    reader.array(field.bricks_, n_bricks);
    reader.array(field.depths_, n_entries - 1);
    if (!reader.is_whole() || reader.n_left() != 0 || n_bricks < 2 ||
        !std::all_of(field.bricks_.begin(), field.bricks_.end(), is_brick) ||
        !std::all_of(field.depths_.begin(), field.depths_.end(),
                     [](float depth) { return std::isfinite(depth); }) ||
        !is_filled(field.bricks_[DistanceField::kFree], DistanceField::kLargestValue) ||
        !is_filled(field.bricks_[DistanceField::kInside], -DistanceField::kLargestValue)) {
        return false;
    }
    return field.table_.back().brick == DistanceField::kFree &&
           std::all_of(
               field.table_.begin(), field.table_.end(), [=](const DistanceField::Entry& entry) {
                   return entry.brick >= 0 && static_cast<std::uint64_t>(entry.brick) < n_bricks &&
                          std::isfinite(entry.centre_voxels);
               });
}

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

Bytes encode(const DistanceField& field, const Digest& key) {
    return seal(ShapeKind::distance_field, key,
                [&](Writer& writer) { DistanceFieldBytes::write(field, writer); });
}

Expected<DistanceField> decode_distance_field(std::span<const std::byte> bytes, const Digest& key) {
    const auto payload = unseal(bytes, ShapeKind::distance_field, key);
    if (!payload) {
        return tl::unexpected(payload.error());
    }
    Reader reader(*payload);
    DistanceField field;
    if (!DistanceFieldBytes::read(reader, field)) {
        return refuse("the kept distance field is none");
    }
    return field;
}

Bytes encode(const VoxelGrid& grid, const Digest& key) {
    return seal(ShapeKind::voxel_grid, key, [&](Writer& writer) {
        walk_frame(writer, grid.frame);
        for (std::size_t first = 0; first < grid.cells.size();) {
            const VoxelClass kind = grid.cells[first];
            std::size_t end = first + 1;
            while (end < grid.cells.size() && grid.cells[end] == kind) {
                ++end;
            }
            // The kind in the two lowest bits.
            writer.field(static_cast<std::uint32_t>(end - first) << 2U |
                         static_cast<std::uint32_t>(kind));
            first = end;
        }
    });
}

Expected<VoxelGrid> decode_voxel_grid(std::span<const std::byte> bytes, const Digest& key) {
    const auto payload = unseal(bytes, ShapeKind::voxel_grid, key);
    if (!payload) {
        return tl::unexpected(payload.error());
    }
    Reader reader(*payload);
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

Bytes encode(const Pointshell& shell, const Digest& key) {
    return seal(ShapeKind::pointshell, key, [&](Writer& writer) {
        for (const auto* const values :
             {&shell.x_m, &shell.y_m, &shell.z_m, &shell.nx, &shell.ny, &shell.nz}) {
            writer.array(std::span<const float>(*values));
        }
    });
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
    Reader reader(*payload);
    Pointshell shell;
    for (auto* const values :
         {&shell.x_m, &shell.y_m, &shell.z_m, &shell.nx, &shell.ny, &shell.nz}) {
        reader.array(*values, n);
        if (!std::all_of(values->begin(), values->end(),
                         [](float x) { return std::isfinite(x); })) {
            return refuse("the kept pointshell is none");
        }
    }
    return shell;
}

}  // namespace fulcrum
