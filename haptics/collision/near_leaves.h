// The leaves of a mesh's tree around a ball, kept from one way to the next: what a ball that slides asks about.
//
// They are those that overlap a box. When the ball leaves the box the leaves of another are found; of those that both have nothing is
// loaded anew, so that a step pays for what came near, not for all that is near.
//
// Thread: the one that owns it. Cost: finding O(log n + leaves), then about a hundred nanoseconds a new one; no allocation.
// Memory: 90 kB.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/collision/leaf_triangles.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace fulcrum {

class NearLeaves {
  public:
    static constexpr std::size_t kCapacity = 192;  ///< leaves of up to 8 triangles

    NearLeaves() noexcept;

    /// Keeps the leaves that may hold a triangle overlapping `box_B`; always of the same mesh. When there are too many it is false,
    /// and nothing is covered.
    bool collect(const CollisionMesh& mesh, const Box& box_B) noexcept;
    /// Are all triangles that overlap the box among those kept?
    [[nodiscard]] bool covers(const Box& box_B) const noexcept {
        return covers_ && box_B_.contains(box_B.lower) && box_B_.contains(box_B.upper);
    }
    /// By rising number.
    [[nodiscard]] std::span<const std::int32_t> leaves() const noexcept {
        return {leaves_.data(), n_leaves_};
    }
    /// How many leaves were loaded so far: what it cost.
    [[nodiscard]] std::uint64_t n_loads() const noexcept { return n_loads_; }

    /// Calls visit(triangle) for all that a ball of `distance_m` may come to on its way, and some others; they must be covered.
    template <class Visit>
    void for_each_near_way(const Vector3& from_B, const Vector3& to_B, double distance_m,
                           Visit&& visit) const noexcept;

  private:
    using Places = std::array<std::uint16_t, kCapacity>;

    void load(const CollisionMesh& mesh, std::span<const std::int32_t> leaves) noexcept;
    // Of the leaves kept, those whose spheres a ball of `reach_m` meets: their places; tells how many.
    std::size_t find_close(const Vector3& middle_B, double reach_m, Places& close) const noexcept;

    std::array<LeafTriangles, kCapacity> loaded_;
    std::array<std::int32_t, kCapacity> leaves_{};
    Places places_{};  // of each leaf in loaded_
    std::size_t n_leaves_ = 0;
    Places unused_{};  // the other places there
    std::size_t n_unused_ = 0;
    Box box_B_{};
    bool covers_ = false;
    std::uint64_t n_loads_ = 0;
};

template <class Visit>
void NearLeaves::for_each_near_way(const Vector3& from_B, const Vector3& to_B, double distance_m,
                                   Visit&& visit) const noexcept {
    const Vector3 middle_B = 0.5 * (from_B + to_B);
    const Vector3 half_B = 0.5 * (to_B - from_B);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
    Places close;
    const std::size_t n_close = find_close(middle_B, distance_m + half_B.norm(), close);
    for (std::size_t i = 0; i < n_close; ++i) {
        const LeafTriangles& leaf = loaded_[close[i]];
        unsigned near = leaf.find_near(middle_B, half_B, distance_m);
        for (; near != 0; near &= near - 1U) {
            visit(leaf.leaf() * LeafTriangles::kWidth + std::countr_zero(near));
        }
    }
}

}  // namespace fulcrum
