#include "haptics/collision/near_leaves.h"

#include <limits>

namespace fulcrum {

NearLeaves::NearLeaves() noexcept {
    for (; n_unused_ < kCapacity; ++n_unused_) {
        unused_[n_unused_] = static_cast<std::uint16_t>(n_unused_);
    }
}

bool NearLeaves::collect(const CollisionMesh& mesh, const Box& box_B) noexcept {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
    std::array<std::int32_t, kCapacity> found;
    const auto n_found = mesh.tree().collect_leaves(box_B, found);
    covers_ = n_found.has_value();
    if (covers_) {
        box_B_ = box_B;
        load(mesh, {found.data(), *n_found});
    }
    return covers_;
}

// Both lists rise: a leaf that is in both keeps its place, the others take the places of those that go.
void NearLeaves::load(const CollisionMesh& mesh, std::span<const std::int32_t> leaves) noexcept {
    constexpr std::uint16_t kNone = std::numeric_limits<std::uint16_t>::max();
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
    Places places;
    std::size_t before = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        for (; before < n_leaves_ && leaves_[before] < leaves[i]; ++before) {
            unused_[n_unused_++] = places_[before];
        }
        const bool is_kept = before < n_leaves_ && leaves_[before] == leaves[i];
        places[i] = is_kept ? places_[before++] : kNone;
        if (!is_kept) {
            mesh.prefetch_leaf(leaves[i]);
        }
    }
    for (; before < n_leaves_; ++before) {
        unused_[n_unused_++] = places_[before];
    }
    n_leaves_ = leaves.size();
    for (std::size_t i = 0; i < n_leaves_; ++i) {
        if (places[i] == kNone) {
            places[i] = unused_[--n_unused_];
            loaded_[places[i]].load(mesh, leaves[i]);
            ++n_loads_;
        }
        leaves_[i] = leaves[i];
        places_[i] = places[i];
    }
}

std::size_t NearLeaves::find_close(const Vector3& middle_B, double reach_m,
                                   Places& close) const noexcept {
    std::size_t n_close = 0;
    for (std::size_t i = 0; i < n_leaves_; ++i) {
        const LeafTriangles& leaf = loaded_[places_[i]];
        const double far_m = reach_m + leaf.radius_m();
        close[n_close] = places_[i];
        n_close += (leaf.middle_B() - middle_B).squaredNorm() > far_m * far_m ? 0U : 1U;
    }
    return n_close;
}

}  // namespace fulcrum
