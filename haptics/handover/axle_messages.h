// What crosses between the haptic loop and the lesson where bodies turn about axles. One value each way, all axles in it.
//
//   lesson loop --AxleOrders--> haptic loop        haptic loop --AxleFrame--> lesson loop and picture
#pragma once

#include "haptics/handover/latest_value.h"
#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstdint>

namespace fulcrum {

inline constexpr int kMaxAxles = kMaxSolids;

/// What a lesson sets of one axle. Angle and spin are set once each time their count grows; the rest holds on.
struct AxleOrder {
    std::uint32_t n_angles = 0;
    double angle_rad = 0.0;
    std::uint32_t n_spins = 0;
    double spin_rad_per_s = 0.0;
    bool is_set = false;  ///< false: pivot and load are as the plan has them
    Vector3 pivot_B{Vector3::Zero()};
    double load_N = 0.0;
};

/// Lesson -> haptic loop, newest value; in the order of the plan's axles.
struct AxleOrders {
    std::array<AxleOrder, kMaxAxles> axles{};
};

/// How one axle stands.
struct AxleReport {
    Pose pose_W{};                     ///< of the body, turned
    Vector3 pivot_W{Vector3::Zero()};  ///< a point of the axis
    double angle_rad = 0.0;
    double spin_rad_per_s = 0.0;
    double inertia_kg_m2 = 0.0;  ///< about the axis through that pivot
    bool touched = false;
    Vector3 at_W{Vector3::Zero()};     ///< where the hand presses, when it is touched
    Vector3 force_W{Vector3::Zero()};  ///< of the hand on the body
    double torque_Nm = 0.0;            ///< of that force about the axis
    double load_torque_Nm = 0.0;       ///< of the hanging weight
    double load_N = 0.0;
    Vector3 load_W{Vector3::Zero()};  ///< where it hangs
};

/// Haptic loop -> lesson and picture, newest value; in the order of the plan's axles.
struct AxleFrame {
    std::int32_t n_axles = 0;
    std::array<AxleReport, kMaxAxles> axles{};
};

struct AxleChannels {
    LatestValue<AxleOrders> orders;  ///< writer: lesson loop; reader: haptic loop
    LatestValue<AxleFrame> frame;    ///< writer: haptic loop; reader: lesson loop
};

}  // namespace fulcrum
