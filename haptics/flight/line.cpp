// The step path of line.h.
#include "haptics/flight/line.h"

#include "haptics/dynamics/rigid_body.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kShortest_m = 0.5;
constexpr double kGround_rad_per_s = 60.0;  // how quickly the ground pushes a node out
constexpr double kFarthest_m = 1000.0;      // that a hand goes in a step

// The way to a place, or none where there is no such place.
Vector3 compute_way_W(const Vector3& from_W, const Vector3& to_W) noexcept {
    const Vector3 way_W = to_W - from_W;
    return way_W.cwiseAbs().maxCoeff() < kFarthest_m && is_finite(way_W) ? way_W : Vector3::Zero();
}

// What a segment does that pulls along a unit vector: without what pushes against it.
Vector3 take_off_push(const Vector3& force_W, const Vector3& along_W) noexcept {
    return force_W - std::min(force_W.dot(along_W), 0.0) * along_W;
}

}  // namespace

LinePull::AtEnd LinePull::compute_at(const Vector3& way_W) const noexcept {
    const Vector3 segment_W = force_W + slope_W * way_W;
    AtEnd at{load_W + load_slope_W * way_W + take_off_push(segment_W, along_W),
             slope_W + load_slope_W};
    if (segment_W.dot(along_W) < 0.0) {
        at.slope_W -= along_W * (along_W.transpose() * slope_W);
    }
    return at;
}

void KiteLine::lay(const Vector3& hand_W, const Vector3& end_W) noexcept {
    const double n = static_cast<double>(segments_.size());
    for (std::size_t i = 0; i < nodes_W_.size(); ++i) {
        nodes_W_[i] = hand_W + static_cast<double>(i) / n * (end_W - hand_W);
        velocities_W_[i].setZero();
    }
    hand_force_W_.setZero();
    end_force_W_.setZero();
    snapped_ = false;
}

void KiteLine::set_length_m(double length_m) noexcept {
    if (!std::isnan(length_m)) {
        length_m_ = std::clamp(length_m, kShortest_m, kLongestLineShare * settings_.length_m);
    }
}

KiteLine::Segment KiteLine::compute_segment(std::size_t i, double dt_s) const noexcept {
    const Vector3 way = nodes_W_[i + 1] - nodes_W_[i];
    const double length_m = compute_length(way);
    const double rest_m = length_m_ / static_cast<double>(segments_.size());
    if (!(length_m > rest_m)) {
        return {Vector3::Zero(), Matrix3::Zero(), Vector3::Zero()};
    }
    const Vector3 t = way / length_m;
    const double stiffness_N_per_m = settings_.stretch_N / rest_m;
    const Matrix3 along = t * t.transpose();
    const double sideways_N_per_m = stiffness_N_per_m * (1.0 - rest_m / length_m);
    return {stiffness_N_per_m * (length_m - rest_m) * t,
            sideways_N_per_m * (Matrix3::Identity() - along) +
                stiffness_N_per_m * (1.0 + settings_.damping_s / dt_s) * along,
            t};
}

// Weight, air and ground of `share` of a segment's line around node i.
void KiteLine::add_surroundings(std::size_t i, double dt_s, double share,
                                const LineSurroundings& around, Vector3& force_W,
                                Matrix3& matrix) const noexcept {
    const double piece_m = share * length_m_ / static_cast<double>(segments_.size());
    const double mass_kg = piece_m * settings_.mass_kg_per_m;
    force_W += mass_kg * around.gravity_W;
    // The air, across the line.
    const Vector3 t = compute_direction(
        Vector3(nodes_W_[std::min(i + 1, segments_.size())] - nodes_W_[i > 0 ? i - 1 : 0]));
    const Matrix3 across = Matrix3::Identity() - t * t.transpose();
    const Vector3 wind_W = compute_wind_W(around.wind, around.gusts, nodes_W_[i]);
    const Vector3 flow_W = across * (wind_W - velocities_W_[i]);
    const double drag_Ns_per_m = 0.5 * kAirDensity_kg_per_m3 * settings_.drag_coefficient *
                                 settings_.diameter_m * piece_m * compute_length(flow_W);
    force_W += drag_Ns_per_m * across * wind_W;
    matrix += drag_Ns_per_m / dt_s * across;
    // The ground, and its grass.
    const double depth_m = around.wind.ground_m - nodes_W_[i].y();
    if (depth_m > 0.0) {
        const double stiffness_N_per_m = mass_kg * kGround_rad_per_s * kGround_rad_per_s;
        const double damping_Ns_per_m = 2.0 * mass_kg * kGround_rad_per_s;
        force_W.y() += stiffness_N_per_m * depth_m;
        matrix(1, 1) += stiffness_N_per_m;
        matrix.diagonal() += Vector3::Constant(damping_Ns_per_m / dt_s);
    }
}

LinePull KiteLine::begin_step(const Vector3& hand_W, double dt_s,
                              const LineSurroundings& around) noexcept {
    dt_s_ = dt_s;
    ways_W_[0] = compute_way_W(nodes_W_[0], hand_W);
    velocities_W_[0] = ways_W_[0] / dt_s;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        segments_[i] = compute_segment(i, dt_s);
    }
    sweep(dt_s, around);
    // Half a segment hangs on each end.
    Matrix3 hand_matrix = Matrix3::Zero();
    hand_load_W_.setZero();
    add_surroundings(0, dt_s, 0.5, around, hand_load_W_, hand_matrix);
    hand_load_W_ -= hand_matrix * ways_W_[0];
    const std::size_t end = segments_.size();
    LinePull pull;
    pull.from_W = nodes_W_[end];
    if (snapped_) {
        return pull;
    }
    Matrix3 end_matrix = Matrix3::Zero();
    add_surroundings(end, dt_s, 0.5, around, pull.load_W, end_matrix);
    pull.load_slope_W = -end_matrix;
    // The last segment with what the sweep knows of its first node.
    const Segment& last = segments_[end - 1];
    pull.along_W = -last.along_W;
    pull.force_W = -last.pull_W;
    pull.slope_W = -last.slope_W;
    if (end == 1) {
        pull.force_W += last.slope_W * ways_W_[0];
    } else {
        pull.force_W += last.slope_W * solved_[end - 1];
        pull.slope_W += last.slope_W * inverse_[end - 1] * last.slope_W;
    }
    return pull;
}

// From the hand outwards: D_i = A_i - S D_(i-1)^-1 S, and what is left over of the right-hand side.
void KiteLine::sweep(double dt_s, const LineSurroundings& around) noexcept {
    const double n = static_cast<double>(segments_.size());
    const double mass_kg = settings_.mass_kg_per_m * length_m_ / n;
    const std::size_t end = segments_.size();
    const std::size_t last = snapped_ ? end : end - 1;
    for (std::size_t i = 1; i <= last; ++i) {
        const double share = i == end ? 0.5 : 1.0;
        const Segment& before = segments_[i - 1];
        Matrix3 matrix = before.slope_W;
        matrix.diagonal() += Vector3::Constant(share * mass_kg / (dt_s * dt_s));
        Vector3 right = share * mass_kg / dt_s * velocities_W_[i] - before.pull_W;
        if (i < end) {
            matrix += segments_[i].slope_W;
            right += segments_[i].pull_W;
        }
        add_surroundings(i, dt_s, share, around, right, matrix);
        if (i == 1) {
            right += before.slope_W * ways_W_[0];
        } else {
            matrix -= before.slope_W * inverse_[i - 1] * before.slope_W;
            right += before.slope_W * solved_[i - 1];
        }
        inverse_[i] = matrix.inverse();
        solved_[i] = inverse_[i] * right;
    }
}

// Back to the hand: d_i = D_i^-1 (r_i + S_i d_(i+1)).
void KiteLine::solve_back(std::size_t last) noexcept {
    for (std::size_t i = last; i > 0; --i) {
        ways_W_[i] = solved_[i];
        if (i < segments_.size()) {
            ways_W_[i] += inverse_[i] * (segments_[i].slope_W * ways_W_[i + 1]);
        }
    }
}

void KiteLine::end_step(const Vector3& end_W) noexcept {
    const std::size_t end = segments_.size();
    if (snapped_) {
        solve_back(end);
        end_force_W_.setZero();
    } else {
        ways_W_[end] = compute_way_W(nodes_W_[end], end_W);
        solve_back(end - 1);
    }
    // What both ends feel, by the step's own forces.
    const Segment& first = segments_[0];
    hand_force_W_ =
        hand_load_W_ +
        take_off_push(first.pull_W + first.slope_W * (ways_W_[1] - ways_W_[0]), first.along_W);
    if (!snapped_) {
        const Segment& last = segments_[end - 1];
        end_force_W_ = take_off_push(
            -last.pull_W - last.slope_W * (ways_W_[end] - ways_W_[end - 1]), -last.along_W);
    }
    for (std::size_t i = 0; i < nodes_W_.size(); ++i) {
        nodes_W_[i] += ways_W_[i];
        velocities_W_[i] = ways_W_[i] / dt_s_;
    }
}

}  // namespace fulcrum
