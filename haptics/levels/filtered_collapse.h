// Filtered edge collapse: a surface in convex pieces becomes simpler and smoother, edge after edge, and stays one of convex pieces.
//
//   which    the edge of highest resolution r = 1 / length first
//   where    at its quadric's point p_q, the one nearest to all planes that its ends stood for, smoothed: with the umbrella U(x) = mean of x's
//            ring - x, p_f = p_q + (U(p_q) - mean of U over the ring) / 2, which takes out what is finer than the ring and leaves what a
//            quadratic surface has
//   may it   local: the triangles of each piece around stay on the hull round them, none turns over; global: what is around goes into none of
//            these hulls. Where p_f may not be, half after half of the way back to p_q, then the ends themselves; else the edge waits
//            until something beside it has changed
//   then     pieces around the corner that are convex together, and clear of all else, become one
// Both allow `kRelaxed` of the edge's length, which is what is smoothed away at that resolution; what it amounts to is measured afterwards
// (contact_levels.h).
//
// Thread: load. Cost: some 50 us an edge.
// Source: M. Otaduy, M. Lin 2003, Sensation preserving simplification for haptic rendering, SIGGRAPH, section 4 and its pseudocode; our filter is
// the second difference of umbrellas instead of Guskov's divided differences. Quadrics: M. Garland, P. Heckbert 1997, Surface simplification
// using quadric error metrics, SIGGRAPH.
#pragma once

#include "haptics/levels/level_surface.h"

#include <cstdint>
#include <queue>
#include <vector>

namespace fulcrum {

/// Of the time that levels take, by and large: what is told of progress goes up to it.
inline constexpr double kSimplifying = 0.5;

class FilteredCollapse {
  public:
    /// Refers to the surface. `slack_m`: what always counts as on a plane.
    FilteredCollapse(LevelSurface& surface, double slack_m);

    /// Ends edges until there are so few pieces; false where no edge may end any more, or where it was stopped.
    bool go_on_to(std::int32_t n_pieces, LoadPulse& pulse);
    /// 1 / r: the longest edge that ended, metres.
    [[nodiscard]] double longest_m() const noexcept { return longest_m_; }
    [[nodiscard]] double slack_m() const noexcept { return slack_m_ + kRelaxed * longest_m_; }
    [[nodiscard]] std::int64_t n_ended() const noexcept { return n_ended_; }

  private:
    static constexpr double kRelaxed = 0.02;
    struct Waiting {
        double length_m;
        std::int32_t low;
        std::int32_t high;
        std::int32_t version;  // of both ends, when it was put here
        bool operator>(const Waiting& other) const noexcept;
    };
    // x' A x - 2 b' x, a plane's part being its area times n n' and n (n . p).
    struct Quadric {
        Matrix3 a{Matrix3::Zero()};
        Vector3 b{Vector3::Zero()};
    };

    void add_quadrics();
    void wait(std::int32_t one, std::int32_t other);
    [[nodiscard]] std::int32_t version_of(std::int32_t one, std::int32_t other) const noexcept;
    bool end(std::int32_t kept, std::int32_t gone);
    [[nodiscard]] Vector3 find_quadric_point(std::int32_t kept, std::int32_t gone) const;
    [[nodiscard]] Vector3 filter(std::int32_t kept, std::int32_t gone, const Vector3& point);
    [[nodiscard]] Vector3 find_umbrella(std::int32_t corner);
    void collect_star(std::int32_t kept, std::int32_t gone);
    [[nodiscard]] bool may_be_at(std::int32_t kept, std::int32_t gone, const Vector3& place,
                                 double slack_m);
    [[nodiscard]] bool turns_over(std::int32_t kept, std::int32_t gone, const Vector3& place) const;
    [[nodiscard]] bool stays_convex(std::int32_t piece, std::int32_t kept, std::int32_t gone,
                                    const Vector3& place, double slack_m);
    void join_around(std::int32_t corner);
    void join_across(std::int32_t one, std::int32_t other);
    [[nodiscard]] bool may_join(std::int32_t one, std::int32_t other);

    LevelSurface& surface_;
    double slack_m_;
    double n_first_;  // pieces
    double longest_m_ = 0.0;
    std::int64_t n_ended_ = 0;
    std::vector<Quadric> quadrics_;
    std::vector<std::int32_t> versions_;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
    // Around the edge that is looked at.
    std::vector<std::int32_t> star_;    // triangles that stay
    std::vector<std::int32_t> pieces_;  // of these
    std::vector<std::int32_t> ring_;
    std::vector<std::int32_t> outer_;
    PieceShape shape_;
    PieceShape other_shape_;
    std::vector<PiecePlane> moved_planes_;
};

}  // namespace fulcrum
