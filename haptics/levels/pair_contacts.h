// Where two convex pieces touch: a normal, and up to nine points. See level_pairs.h for the law.
//
// Thread: that of the question. Cost: 0.1 us, and 0.5 us a point more; no allocation.
#pragma once

#include "haptics/levels/contact_levels.h"

#include <array>

namespace fulcrum {

/// Frame O; the tool's by `turn` and `shift`.
struct PiecesNear {
    const LevelNode& object;
    const LevelNode& tool;
    HullView object_hull;
    HullView tool_hull;
    const Matrix3& turn;
    const Vector3& shift;
    double within_m = 0.0;
    double spread_m = 0.0;
    HullCorners corners{};  ///< that were found
};

struct PairPoint {
    Vector3 place_O{Vector3::Zero()};  ///< on the tool
    double depth_m = 0.0;
};

class PairContacts {
  public:
    /// `found`: the shortest way between them, no longer than `within_m`.
    PairContacts(const PiecesNear& pieces, const HullPair& found) noexcept;

    /// None where the contact is a neighbour's.
    [[nodiscard]] std::span<const PairPoint> points() const noexcept {
        return {points_.data(), n_};
    }
    [[nodiscard]] const Vector3& normal_O() const noexcept { return normal_; }

  private:
    static constexpr std::size_t kCorners = 4;  // of either
    static constexpr std::size_t kMost = 1 + 2 * kCorners;
    void find_way_out() noexcept;
    [[nodiscard]] bool do_both_look(const Vector3& normal, double least) const noexcept;
    [[nodiscard]] bool has_such_normal() const noexcept;
    [[nodiscard]] double measure_depth_m(const Vector3& normal) const noexcept;
    void add_corners_of_tool() noexcept;
    void add_corners_of_object() noexcept;
    // Of a hull's corners within the band the one farthest from all points; false where it is too near.
    template <class ToObject>
    bool find_far_corner(const HullView& hull, double lowest_m, double sign,
                         const ToObject& to_object, Vector3& corner) const noexcept;
    void add_nearest(const PairPoint& point, bool do_meet) noexcept;

    const PiecesNear& pieces_;
    Vector3 tool_normal_;
    Vector3 normal_{Vector3::UnitY()};
    double depth_m_ = 0.0;
    std::array<PairPoint, kMost> points_{};
    std::array<Vector3, kMost> tried_{};
    std::size_t n_tried_ = 0;
    std::size_t n_ = 0;
};

}  // namespace fulcrum
