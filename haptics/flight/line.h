// A kite's line: equal segments that pull when stretched and never push, with weight, and the wind on them. So it sags, goes
// slack and taut, lies on the ground, and falls when it has snapped.
//
//   segment of rest length r, from a to b:   T = E max(l - r, 0) / r,  l = |b - a|,  t = (b - a) / l
//     damped while taut by E tau / r along t;  E: newtons that would double its length (EA)
//   node:   m x'' = sum of pulls + m g + air + ground
//   air     -rho/2 C d r |u_n| u_n, u_n the node's velocity through the air across the line (cross-flow principle)
//   ground  m (omega^2 depth up - 2 omega v) while below it: it pushes out, and grass holds what moves in it
// A step is backward Euler, linearised once: with S = E/r ((1 - r/l) (1 - t t^T) + t t^T) + E tau / (r h) t t^T  of a taut
// segment and d_i the way of node i in this step,
//   (m/h^2 + S_(i-1) + S_i + air/h + ground) d_i - S_(i-1) d_(i-1) - S_i d_(i+1) = m v_i / h + forces
// a block-tridiagonal system, solved along the line in one sweep (Thomas). The far end is not solved but left open: the sweep
// gives the line's pull there as  F = F_0 + K d,  K <= 0,  which the body that hangs on it takes as a load in its own step;
// its way then closes the system. So line and body move in one implicit step, however stiff and light the line is.
// Linearised, a segment that is about to slacken would push at the end of that step. The ends never feel it: of the last
// segment's force on the body, and of the first one's on the hand, the part that pushes along the segment is taken off.
//
// Thread: that of the step. Cost: 70 ns a segment. No allocation after construction.
// Source: D. Baraff, A. Witkin 1998, Large steps in cloth simulation, sections 3 and 4.2 (implicit step, linearised once);
// K. Choi, H. Ko 2002, Stable but responsive cloth (no negative stiffness: a slack segment has none). Drag: S. Hoerner 1965,
// Fluid-Dynamic Drag, 3-11 (cross-flow principle).
#pragma once

#include "haptics/base/error.h"
#include "haptics/flight/wind.h"
#include "haptics/math/spatial.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fulcrum {

inline constexpr int kMostLineSegments = 64;

/// Of the length that a line was made with: no reel lets out more.
inline constexpr double kLongestLineShare = 4.0;

/// Fixed at load.
struct LineSettings {
    double length_m = 20.0;          ///< unstretched, at first; 0.5 to 500
    int segments = 16;               ///< 1 to kMostLineSegments
    double mass_kg_per_m = 3.72e-4;  ///< of NASA's nylon line; 1e-5 to 0.1
    double stretch_N = 500.0;        ///< E, 10 to 1e6
    double damping_s = 0.01;         ///< tau, 0 to 1
    double diameter_m = 7.0e-4;      ///< 0 to 0.02
    double drag_coefficient = 1.1;   ///< of a cylinder across the stream; 0 to 2
    double strength_N = 150.0;       ///< it snaps at the kite's end above it; 1 to 1e6
};

/// The far end's pull by its way in the step that has begun.
struct LinePull {
    Vector3 force_W{Vector3::Zero()};  ///< newtons on what hangs there, were the end to stay
    Matrix3 slope_W{Matrix3::Zero()};  ///< N/m by the end's way; never positive
    Vector3 from_W{Vector3::Zero()};   ///< where the end was
    Vector3 along_W{Vector3::Zero()};  ///< unit, the way a pull goes; none when slack
    Vector3 load_W{Vector3::Zero()};   ///< weight and air of the half segment that hangs there ...
    Matrix3 load_slope_W{
        Matrix3::Zero()};  ///< ... and its slope; both are there when nothing pulls

    /// A force on the end, and its slope by the end's way.
    struct AtEnd {
        Vector3 force_W;
        Matrix3 slope_W;
    };
    /// Once the end has gone that way; it never pushes.
    [[nodiscard]] AtEnd compute_at(const Vector3& way_W) const noexcept;
};

/// What all nodes are in.
struct LineSurroundings {
    Vector3 gravity_W{0.0, -9.81, 0.0};
    const WindSettings& wind;  ///< its ground is the line's as well
    const GustState& gusts;
};

/// Refuses settings outside the ranges above, NaN.
[[nodiscard]] Expected<void> validate(const LineSettings& settings);

class KiteLine {
  public:
    /// Takes settings that `validate` accepted. It lies at the origin until `lay`.
    explicit KiteLine(const LineSettings& settings);

    /// Straight from hand to end, at rest, whole.
    void lay(const Vector3& hand_W, const Vector3& end_W) noexcept;
    /// Changes the unstretched length, kept within 0.5 m and the length it was made with times four. What was laid stays. A length
    /// that is no number changes nothing.
    void set_length_m(double length_m) noexcept;
    /// From now on nothing hangs at its end.
    void snap() noexcept {
        snapped_ = true;
        end_force_W_.setZero();
    }

    /// First half of a step to where the hand is now; `dt_s` above 0. A hand that is nowhere, or a kilometre from where it was,
    /// is taken to have stayed.
    [[nodiscard]] LinePull begin_step(const Vector3& hand_W, double dt_s,
                                      const LineSurroundings& around) noexcept;
    /// Second half: the end has come there; one that is nowhere has stayed. Of a snapped line the place counts for nothing.
    void end_step(const Vector3& end_W) noexcept;

    /// Newtons on the hand, of the step that has ended.
    [[nodiscard]] const Vector3& hand_force_W() const noexcept { return hand_force_W_; }
    /// Newtons on what hangs at the end; none when snapped.
    [[nodiscard]] const Vector3& end_force_W() const noexcept { return end_force_W_; }
    /// Hand first, then one a segment's end.
    [[nodiscard]] std::span<const Vector3> nodes_W() const noexcept { return nodes_W_; }
    [[nodiscard]] std::span<const Vector3> velocities_W() const noexcept { return velocities_W_; }
    [[nodiscard]] double length_m() const noexcept { return length_m_; }
    [[nodiscard]] bool is_snapped() const noexcept { return snapped_; }
    [[nodiscard]] const LineSettings& settings() const noexcept { return settings_; }

  private:
    // A segment at the step's beginning.
    struct Segment {
        Vector3 pull_W;   // on its first node
        Matrix3 slope_W;  // S
        Vector3 along_W;  // t; none when slack
    };
    [[nodiscard]] Segment compute_segment(std::size_t i, double dt_s) const noexcept;
    void add_surroundings(std::size_t i, double dt_s, double share, const LineSurroundings& around,
                          Vector3& force_W, Matrix3& matrix) const noexcept;
    void sweep(double dt_s, const LineSurroundings& around) noexcept;
    void solve_back(std::size_t last) noexcept;

    LineSettings settings_;
    double length_m_;
    bool snapped_ = false;
    std::vector<Vector3> nodes_W_, velocities_W_;
    std::vector<Segment> segments_;
    // The sweep: of each node between hand and end, D^-1 and D^-1 r.
    std::vector<Matrix3> inverse_;
    std::vector<Vector3> solved_;
    std::vector<Vector3> ways_W_;
    double dt_s_ = 0.0;
    Vector3 hand_load_W_{Vector3::Zero()};  // weight and air of half a segment
    Vector3 hand_force_W_{Vector3::Zero()};
    Vector3 end_force_W_{Vector3::Zero()};
};

}  // namespace fulcrum
