// The distance field's half of shape_bytes.h.
#include "haptics/voxel/shape_bytes.h"
#include "haptics/voxel/shape_seal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {

using namespace shape_seal;

namespace {

constexpr std::int32_t kMostFieldCells = 2048;

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
    template <class Walker, class Field>
    static void walk_head(Walker& walker, Field& field);
    template <class Walker>
    static void walk(Walker& walker, const DistanceField& field);
    [[nodiscard]] static bool read(ByteReader& reader, DistanceField& field);

  private:
    [[nodiscard]] static double find_steepest(const DistanceField& field) noexcept;
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

// From corner to corner F changes by no more than the way between them; across the membrane over a hole, from one end of the band to
// the other.
double DistanceFieldBytes::find_steepest(const DistanceField& field) noexcept {
    constexpr double kSteepest = 1.01 * std::numbers::sqrt3;  // a little for 16 bits
    const bool has_membranes = field.counts_.n_open_edges > 0 && field.sheet_m_ == 0.0;
    return kSteepest * (has_membranes ? 2.0 * field.band_m_ / field.frame_.voxel_m : 1.0);
}

bool DistanceFieldBytes::is_head(const DistanceField& field) noexcept {
    const auto is_multiple = [](std::int32_t n) { return n % kBrickCells == 0; };
    const auto& n_cells = field.frame_.n_cells;
    return is_frame(field.frame_, kBrickCells, kMostFieldCells) &&
           std::all_of(n_cells.begin(), n_cells.end(), is_multiple) && is_length(field.band_m_) &&
           field.sheet_m_ >= 0.0 && field.sheet_m_ <= field.band_m_ &&
           is_place(field.ball_centre_O_) && is_length(field.ball_radius_m_) &&
           field.counts_.n_bricks >= 0 && field.counts_.n_open_edges >= 0 &&
           field.slope_bound_ >= 1.0 && field.slope_bound_ <= find_steepest(field);
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

auto payload_of_field(const DistanceField& field) {
    return [&field](auto& walker) { DistanceFieldBytes::walk(walker, field); };
}

}  // namespace

std::size_t count_bytes(const DistanceField& field) {
    return count_sealed(payload_of_field(field));
}

Bytes encode(const DistanceField& field, const Digest& key) {
    return seal(ShapeKind::distance_field, key, payload_of_field(field));
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

}  // namespace fulcrum
