#include "haptics/collision/segment_structure.h"

#include <array>
#include <utility>

namespace fulcrum {

namespace {

using Mesh = std::shared_ptr<const CollisionMesh>;

class TreeStructure final : public SegmentStructure {
  public:
    explicit TreeStructure(Mesh mesh) : mesh_(std::move(mesh)) {}
    SegmentHit find_nearest_hit(const Vector3& from_B, const Vector3& to_B) noexcept override {
        return fulcrum::find_nearest_hit(*mesh_, from_B, to_B);
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override { return 0; }

  private:
    Mesh mesh_;
};

class GridStructure final : public SegmentStructure {
  public:
    explicit GridStructure(std::shared_ptr<const HCollide> grid) : grid_(std::move(grid)) {}
    SegmentHit find_nearest_hit(const Vector3& from_B, const Vector3& to_B) noexcept override {
        return grid_->find_nearest_hit(from_B, to_B, memory_);
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override {
        return grid_->memory_bytes();
    }

  private:
    std::shared_ptr<const HCollide> grid_;
    HCollide::Memory memory_;
};

class BruteForce final : public SegmentStructure {
  public:
    explicit BruteForce(Mesh mesh) : mesh_(std::move(mesh)) {}
    SegmentHit find_nearest_hit(const Vector3& from_B, const Vector3& to_B) noexcept override {
        return find_nearest_hit_brute_force(*mesh_, from_B, to_B);
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override { return 0; }

  private:
    Mesh mesh_;
};

constexpr std::array<std::string_view, 3> kNames{"bounding_tree", "h_collide", "brute_force"};

}  // namespace

std::string_view name_of(SegmentStructureKind kind) noexcept {
    return kNames[static_cast<std::size_t>(kind)];
}

std::optional<SegmentStructureKind> find_segment_structure(std::string_view name) noexcept {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (kNames[i] == name) {
            return static_cast<SegmentStructureKind>(i);
        }
    }
    return std::nullopt;
}

Expected<std::unique_ptr<SegmentStructure>> make_segment_structure(
    SegmentStructureKind kind, std::shared_ptr<const CollisionMesh> mesh,
    const HCollideSettings& settings) {
    if (!mesh) {
        return fail("there is no mesh to find segments on", {}, "give one");
    }
    switch (kind) {
        case SegmentStructureKind::h_collide: {
            auto grid = HCollide::create(std::move(mesh), settings);
            if (!grid) {
                return tl::unexpected(std::move(grid.error()));
            }
            return std::make_unique<GridStructure>(*std::move(grid));
        }
        case SegmentStructureKind::brute_force:
            return std::make_unique<BruteForce>(std::move(mesh));
        case SegmentStructureKind::bounding_tree:
            break;
    }
    return std::make_unique<TreeStructure>(std::move(mesh));
}

}  // namespace fulcrum
