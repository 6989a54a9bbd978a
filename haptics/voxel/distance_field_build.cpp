// The load-path half of distance_field.h.
#include "haptics/voxel/brick_sides.h"
#include "haptics/voxel/brick_triangles.h"
#include "haptics/voxel/distance_field.h"
#include "haptics/voxel/winding_number.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace fulcrum {

namespace {

using Cell = VoxelFrame::Cell;

// Share of a distance: far away it costs much and helps little to know more.
constexpr double kSlack = 0.03;
// What a build may take: a minute or two. Of a brick and a triangle each, 1 us; of a winding number's terms, counted as if each
// corner's side had to be asked for, some 2 ns where meshes are whole.
constexpr double kMostPairs = 1.6e7;
constexpr double kMostTerms = 5.0e10;

// The brick that a share of a row-major list stands for.
Cell to_brick(std::size_t index, const std::array<std::int32_t, 3>& n) {
    const auto i = static_cast<std::int32_t>(index);
    return {i % n[0], i / n[0] % n[1], i / n[0] / n[1]};
}

Vector3 to_vector(const Cell& cell) {
    return Vector3i(cell[0], cell[1], cell[2]).cast<double>();
}

// Largest |F| difference over a cell's four edges along each axis bounds the slope's components.
double find_steepest(const std::array<std::int16_t, 736>& values) {
    double steepest = 0.0;
    constexpr std::array<int, 3> kStride{1, kBrickSide, kBrickSide * kBrickSide};
    for (int cell = 0; cell < kBrickCells * kBrickCells * kBrickCells; ++cell) {
        const int corner = cell % 8 + kBrickSide * (cell / 8 % 8) + kStride[2] * (cell / 64);
        double square = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int one = kStride[(axis + 1) % 3];
            const int other = kStride[(axis + 2) % 3];
            int most = 0;
            for (const int at : {corner, corner + one, corner + other, corner + one + other}) {
                const int next = at + kStride[axis];
                const int step =
                    values[static_cast<std::size_t>(next)] - values[static_cast<std::size_t>(at)];
                most = std::max(most, std::abs(step));
            }
            square += static_cast<double>(most) * most;
        }
        steepest = std::max(steepest, square);
    }
    return std::sqrt(steepest);
}

}  // namespace

// Holds what the steps of a build share.
class DistanceFieldBuilder {
  public:
    DistanceFieldBuilder(const TriangleMesh& mesh, const VoxelFrame& frame,
                         const DistanceFieldSettings& settings, const LoadProgress& progress)
        : mesh_(mesh),
          settings_(settings),
          progress_(progress),
          clusters_(mesh),
          sides_(mesh, clusters_, frame.voxel_m) {
        field_.frame_ = frame;
        field_.band_m_ = settings.band_voxels * frame.voxel_m;
        field_.sheet_m_ = settings.sheet_voxels * frame.voxel_m;
        field_.counts_.n_open_edges = static_cast<std::int64_t>(sides_.n_open_edges());
        field_.ball_centre_O_ = 0.5 * (mesh.lower_B() + mesh.upper_B());
        for (const Vector3& vertex : mesh.vertices_B()) {
            field_.ball_radius_m_ = std::max(
                field_.ball_radius_m_, (vertex - field_.ball_centre_O_).norm() + field_.sheet_m_);
        }
        n_ = field_.n_bricks();
    }

    // Refuses what would take too long.
    [[nodiscard]] Expected<void> build() {
        auto near = list_brick_triangles(mesh_, field_.frame_, reach_voxels(), kMostPairs,
                                         part_of_progress(0.0, kShareListed));
        if (!near) {
            return refuse_stopped();
        }
        near_ = std::move(*near);
        const double too_much = std::max(near_.n_pairs / kMostPairs, count_terms() / kMostTerms);
        if (too_much > 1.0) {
            return refuse_work(too_much);
        }
        if (!tell(kShareListed) || !fill_near_bricks()) {
            return refuse_stopped();
        }
        keep_near_bricks();
        return tell(kShareFilled) && fill_table() && fill_depths() && tell(1.0) ? Expected<void>{}
                                                                                : refuse_stopped();
    }
    [[nodiscard]] DistanceField take() { return std::move(field_); }

  private:
    // The share of the whole that each step takes, about.
    static constexpr double kShareListed = 0.1;
    static constexpr double kShareFilled = 0.65;
    static constexpr double kShareTold = 0.9;

    [[nodiscard]] bool tell(double share) const { return !progress_ || progress_(share); }
    [[nodiscard]] bool is_sheet() const noexcept { return settings_.sheet_voxels > 0.0; }
    // How far from a triangle F may tell of it.
    [[nodiscard]] double reach_voxels() const noexcept {
        return settings_.band_voxels + settings_.sheet_voxels;
    }
    [[nodiscard]] std::size_t n_all() const {
        return static_cast<std::size_t>(n_[0]) * static_cast<std::size_t>(n_[1]) *
               static_cast<std::size_t>(n_[2]);
    }
    [[nodiscard]] std::size_t index_of(const Cell& brick) const noexcept {
        const std::int32_t at = brick[0] + n_[0] * (brick[1] + n_[1] * brick[2]);
        return static_cast<std::size_t>(at);
    }
    // In voxels of the block.
    [[nodiscard]] static Vector3 centre_of(const Cell& brick) noexcept {
        return kBrickCells * (to_vector(brick) + Vector3::Constant(0.5));
    }
    [[nodiscard]] Vector3 to_object(const Vector3& lattice) const noexcept {
        return field_.frame_.lower_O + field_.frame_.voxel_m * lattice;
    }
    [[nodiscard]] LoadProgress part_of_progress(double from, double to) const {
        if (!progress_) {
            return {};
        }
        return [this, from, to](double share) { return progress_(from + share * (to - from)); };
    }
    [[nodiscard]] static Expected<void> refuse_stopped() {
        return fail("the distance field was stopped before it was made", {}, "make it again");
    }
    [[nodiscard]] Expected<void> refuse_work(double too_much) const;
    [[nodiscard]] double count_terms() const;
    [[nodiscard]] bool fill_near_bricks();
    bool fill_brick(std::size_t listed, DistanceField::Brick& brick,
                    WorkWatch& watch) const noexcept;
    void keep_near_bricks();
    [[nodiscard]] bool fill_table();
    [[nodiscard]] bool fill_depths();
    // Of a place to the triangles, both in voxels; a lower bound, by the share `slack` at most.
    [[nodiscard]] double find_distance(const Vector3& lattice, double slack) const noexcept;
    // |d| of a place on that side; a lower bound likewise, exact without slack.
    [[nodiscard]] double find_size(const Vector3& lattice, bool inside,
                                   double slack) const noexcept;
    void fill_entry(const Cell& brick, double voxels, bool inside) noexcept;
    void fill_entry_alone(const Cell& brick) noexcept;
    void fill_entries(const Cell& first) noexcept;

    const TriangleMesh& mesh_;
    const DistanceFieldSettings& settings_;
    const LoadProgress& progress_;
    TriangleClusters clusters_;
    BrickSides sides_;
    DistanceField field_;
    std::array<std::int32_t, 3> n_{};
    BrickTriangles near_;
    std::vector<char> is_kept_;
};

// About what the sides of all bricks' corners take, at most: terms of winding numbers, counted at some bricks' middles.
double DistanceFieldBuilder::count_terms() const {
    constexpr std::size_t kCounted = 32;
    const std::size_t n = near_.bricks.size();
    if (is_sheet() || n == 0) {
        return 0.0;
    }
    const std::size_t stride = std::max<std::size_t>(n / kCounted, 1);
    double terms = 0.0;
    double n_counted = 0.0;
    for (std::size_t i = 0; i < n; i += stride) {
        const Cell brick = to_brick(static_cast<std::size_t>(near_.bricks[i]), n_);
        terms += sides_.count_terms(to_object(centre_of(brick)), near_.count(i));
        n_counted += 1.0;
    }
    return terms / n_counted * static_cast<double>(n);
}

Expected<void> DistanceFieldBuilder::refuse_work(double too_much) const {
    // Bricks become fewer with at least the square of the voxel.
    std::array<char, 32> enough{};
    std::snprintf(enough.data(), enough.size(), "%.2g",
                  1.05 * std::sqrt(too_much) * field_.frame_.voxel_m);
    return fail(
        "its " + std::to_string(mesh_.triangles().size()) +
            " triangles cross each other, or are open, so much that to find its inside would "
            "take minutes",
        {},
        "make it one closed surface, or the voxels " + std::string(enough.data()) + " m or larger");
}

bool DistanceFieldBuilder::fill_brick(std::size_t listed, DistanceField::Brick& brick,
                                      WorkWatch& watch) const noexcept {
    const Vector3 corner =
        kBrickCells * to_vector(to_brick(static_cast<std::size_t>(near_.bricks[listed]), n_));
    const auto band = static_cast<float>(settings_.band_voxels);
    const auto reach = static_cast<float>(reach_voxels());
    BrickDistances distances;
    distances.fill(reach * reach);
    for (std::size_t i = near_.first[listed]; i < near_.first[listed + 1]; ++i) {
        const TriangleAt t = find_lattice_triangle(mesh_, field_.frame_,
                                                   static_cast<std::size_t>(near_.triangles[i]));
        lower_squares(prepare_for_band({t.a - corner, t.b - corner, t.c - corner}), reach,
                      distances);
    }
    if (std::all_of(distances.begin(), distances.end(),
                    [&](float square) { return square >= reach * reach; })) {
        return false;
    }
    for (float& distance : distances) {
        distance = std::sqrt(distance);
    }
    if (is_sheet()) {
        for (float& distance : distances) {
            distance -= static_cast<float>(settings_.sheet_voxels);
        }
    } else {
        sides_.put_signs(to_object(corner), distances, &watch);
    }
    for (std::size_t i = 0; i < kBrickCorners; ++i) {
        brick.values[i] =
            static_cast<std::int16_t>(std::lround(static_cast<float>(DistanceField::kLargestValue) *
                                                  std::clamp(distances[i] / band, -1.0F, 1.0F)));
    }
    return true;
}

bool DistanceFieldBuilder::fill_near_bricks() {
    constexpr std::size_t kConstant = 2;  // the bricks of +b and -b
    field_.bricks_.resize(near_.bricks.size() + kConstant);
    field_.bricks_[DistanceField::kFree].values.fill(DistanceField::kLargestValue);
    field_.bricks_[DistanceField::kInside].values.fill(-DistanceField::kLargestValue);
    is_kept_.assign(near_.bricks.size(), 0);
    std::vector<float> steepest(near_.bricks.size(), 0.0F);
    const bool is_done = parallel_for(
        near_.bricks.size(), static_cast<std::size_t>(settings_.n_threads),
        [&](std::size_t i, WorkWatch& watch) noexcept {
            DistanceField::Brick& brick = field_.bricks_[i + kConstant];
            is_kept_[i] = fill_brick(i, brick, watch) ? 1 : 0;
            steepest[i] = is_kept_[i] != 0 ? static_cast<float>(find_steepest(brick.values)) : 0.0F;
        },
        part_of_progress(kShareListed, kShareFilled));
    const double most = *std::max_element(steepest.begin(), steepest.end());
    constexpr double kAboveRounding = 1.0 + 1.0e-6;
    field_.slope_bound_ =
        std::max(1.0, kAboveRounding * most * field_.step_m() / field_.frame_.voxel_m);
    return is_done;
}

void DistanceFieldBuilder::keep_near_bricks() {
    field_.table_.assign(n_all() + 1, {});
    std::size_t n_kept = 2;
    for (std::size_t i = 0; i < near_.bricks.size(); ++i) {
        if (is_kept_[i] != 0) {
            field_.bricks_[n_kept] = field_.bricks_[i + 2];
            field_.table_[static_cast<std::size_t>(near_.bricks[i])].brick =
                static_cast<std::int32_t>(n_kept++);
        }
    }
    field_.bricks_.resize(n_kept);
    field_.bricks_.shrink_to_fit();
    field_.counts_.n_bricks = static_cast<std::int64_t>(n_kept - 2);
}

double DistanceFieldBuilder::find_distance(const Vector3& lattice, double slack) const noexcept {
    constexpr double kBelowRounding = 1.0 - 1.0e-6;
    constexpr double kAnyDistance = std::numeric_limits<double>::infinity();
    return kBelowRounding / field_.frame_.voxel_m *
           clusters_.find_distance(to_object(lattice), kAnyDistance, slack);
}

double DistanceFieldBuilder::find_size(const Vector3& lattice, bool inside,
                                       double slack) const noexcept {
    if (!is_sheet()) {
        return find_distance(lattice, slack);
    }
    const double size = find_distance(lattice, inside ? 0.0 : slack) - settings_.sheet_voxels;
    return std::max(inside ? -size : size, 0.0);
}

void DistanceFieldBuilder::fill_entry(const Cell& brick, double voxels, bool inside) noexcept {
    DistanceField::Entry& entry = field_.table_[index_of(brick)];
    if (entry.brick == DistanceField::kFree && inside) {
        entry.brick = DistanceField::kInside;
    }
    entry.centre_voxels = static_cast<float>(inside ? -voxels : voxels);
}

void DistanceFieldBuilder::fill_entry_alone(const Cell& brick) noexcept {
    const DistanceField::Entry& entry = field_.table_[index_of(brick)];
    const Vector3 centre = centre_of(brick);
    const auto& corners = field_.bricks_[static_cast<std::size_t>(entry.brick)].values;
    constexpr int kMiddle = kBrickCells / 2;
    const bool inside = entry.brick != DistanceField::kFree
                            ? corners[brick_corner_at(kMiddle, kMiddle, kMiddle)] < 0
                            : !is_sheet() && is_wound_round(clusters_, to_object(centre));
    fill_entry(brick, find_size(centre, inside, kSlack), inside);
}

// Two by two by two bricks. Far from the surface of a closed mesh one distance and one side are enough for all.
void DistanceFieldBuilder::fill_entries(const Cell& first) noexcept {
    const Cell end{std::min(first[0] + 2, n_[0]), std::min(first[1] + 2, n_[1]),
                   std::min(first[2] + 2, n_[2])};
    constexpr double kFar = 60.0;  // voxels; the bricks' centres are a tenth of it away
    const Vector3 middle = kBrickCells * (to_vector(first) + Vector3::Ones());
    const double voxels =
        is_sheet() || field_.counts_.n_open_edges == 0 ? find_size(middle, false, kSlack) : 0.0;
    const bool are_alike = voxels >= kFar;
    const bool inside = are_alike && !is_sheet() && is_wound_round(clusters_, to_object(middle));
    for (std::int32_t z = first[2]; z < end[2]; ++z) {
        for (std::int32_t y = first[1]; y < end[1]; ++y) {
            for (std::int32_t x = first[0]; x < end[0]; ++x) {
                const Cell brick{x, y, z};
                if (are_alike) {
                    fill_entry(brick, voxels - (centre_of(brick) - middle).norm(), inside);
                } else {
                    fill_entry_alone(brick);
                }
            }
        }
    }
}

bool DistanceFieldBuilder::fill_table() {
    const std::array<std::int32_t, 3> n_pairs{(n_[0] + 1) / 2, (n_[1] + 1) / 2, (n_[2] + 1) / 2};
    return parallel_for(
        static_cast<std::size_t>(n_pairs[0]) * static_cast<std::size_t>(n_pairs[1]) *
            static_cast<std::size_t>(n_pairs[2]),
        static_cast<std::size_t>(settings_.n_threads),
        [&](std::size_t i) noexcept {
            const Cell pair = to_brick(i, n_pairs);
            fill_entries({2 * pair[0], 2 * pair[1], 2 * pair[2]});
        },
        part_of_progress(kShareFilled, kShareTold));
}

// Exact inside, where the depth's slope is a force's direction.
bool DistanceFieldBuilder::fill_depths() {
    field_.depths_.resize(n_all());
    return parallel_for(
        n_all(), static_cast<std::size_t>(settings_.n_threads),
        [&](std::size_t i) noexcept {
            const float centre_voxels = field_.table_[i].centre_voxels;
            field_.depths_[i] =
                centre_voxels < 0.0F
                    ? static_cast<float>(find_size(centre_of(to_brick(i, n_)), true, 0.0))
                    : -centre_voxels;
        },
        part_of_progress(kShareTold, 1.0));
}

Expected<DistanceField> DistanceField::build(const TriangleMesh& mesh, const VoxelFrame& frame,
                                             const DistanceFieldSettings& settings,
                                             const LoadProgress& progress) {
    if (auto valid = validate(settings); !valid) {
        return tl::unexpected(valid.error());
    }
    if (auto fits = validate(frame, mesh, settings.band_voxels + settings.sheet_voxels); !fits) {
        return tl::unexpected(fits.error());
    }
    DistanceFieldBuilder builder(mesh, frame, settings, progress);
    return builder.build().map([&] { return builder.take(); });
}

std::optional<Error> DistanceField::tell_holes() const {
    if (counts_.n_open_edges == 0 || sheet_m_ > 0.0) {
        return {};
    }
    return Error{"the mesh has " + std::to_string(counts_.n_open_edges) +
                     " open edges: its holes are felt as if skins closed them, and a tool that "
                     "looks only at what is near may pass through these",
                 {},
                 "close the holes, or build the field as a sheet (sheet_voxels)"};
}

}  // namespace fulcrum
