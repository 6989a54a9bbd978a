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

/// A hull in another frame: a small one point by point, once; a large one as it is asked.
class PlacedHull {
  public:
    PlacedHull(const HullView& hull, const Matrix3& turn, const Vector3& shift) noexcept;
    PlacedHull(const PlacedHull&) = delete;
    PlacedHull& operator=(const PlacedHull&) = delete;
    ~PlacedHull() = default;

    /// The corner farthest along a direction of that frame; `at` as of HullView.
    [[nodiscard]] Vector3 find_support(const Vector3& direction, std::int32_t& at) const noexcept {
        return is_large_ ? place(hull_.find_support(turn_.transpose() * direction, at))
                         : placed_.find_support(direction);
    }
    [[nodiscard]] Vector3 find_support(const Vector3& direction) const noexcept {
        std::int32_t at = 0;
        return find_support(direction, at);
    }
    /// A point's nearest in it, as find_nearest_in_hull.
    [[nodiscard]] HullPair find_nearest(const Vector3& point, const Vector3& start, double enough_m,
                                        std::int32_t at) const noexcept;
    [[nodiscard]] bool is_large() const noexcept { return is_large_; }
    [[nodiscard]] std::size_t size() const noexcept { return hull_.points.size(); }
    [[nodiscard]] Vector3 point(std::size_t i) const noexcept {
        return is_large_ ? place(hull_.points[i]) : points_[i];
    }

  private:
    [[nodiscard]] Vector3 place(const Vector3& point) const noexcept {
        return turn_ * point + shift_;
    }
    const HullView& hull_;
    const Matrix3& turn_;
    const Vector3& shift_;
    bool is_large_;
    std::array<Vector3, kClimbFrom> points_;  // filled as far as there are
    HullView placed_;
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
    void find_way_out(const HullPair& found) noexcept;
    [[nodiscard]] bool do_both_look(const Vector3& normal, double least) const noexcept;
    [[nodiscard]] bool has_such_normal() const noexcept;
    [[nodiscard]] bool are_thin() const noexcept;
    [[nodiscard]] double measure_depth_m(const Vector3& normal) const noexcept;
    void add_corners_of_tool() noexcept;
    void add_corners_of_object() noexcept;
    // Of a hull's corners within the band the one farthest from all points; false where it is too near.
    template <class PointAt>
    bool find_far_corner(std::size_t n_points, double lowest_m, const PointAt& point_at,
                         Vector3& corner) const noexcept;
    template <class PointAt>
    void add_corners_of_tool(const PointAt& point_at) noexcept;
    void add_nearest(const PairPoint& point, bool do_meet) noexcept;

    const PiecesNear& pieces_;
    PlacedHull tool_;
    Vector3 tool_normal_;
    Vector3 normal_{Vector3::UnitY()};
    double depth_m_ = 0.0;
    std::array<PairPoint, kMost> points_{};
    std::array<Vector3, kMost> tried_{};
    std::size_t n_tried_ = 0;
    std::size_t n_ = 0;
};

}  // namespace fulcrum
