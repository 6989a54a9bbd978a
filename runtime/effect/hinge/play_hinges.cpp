#include "runtime/effect/hinge/play_hinges.h"

#include "runtime/lesson/undeclared.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::runtime {

void PlayedHinges::take(const SessionInput& input, LessonFrame& frame) {
    if (input.axles == nullptr) {
        return;
    }
    frame.hinges.clear();
    std::size_t axle = 0;
    for (std::size_t i = 0; i < lesson_.bodies.size(); ++i) {
        if (!lesson_.bodies[i].hinge || axle >= input.axles->axles.size()) {
            continue;
        }
        const AxleReport& report = input.axles->axles[axle++];
        const double force_N = report.force_W.norm();
        frame.hinges.push_back({report.angle_rad, report.spin_rad_per_s, report.torque_Nm,
                                force_N > 0.0 ? std::abs(report.torque_Nm) / force_N : 0.0,
                                report.load_torque_Nm, report.inertia_kg_m2});
        if (input.axles->n_axles > 0 && frame.bodies[i].where == BodyWhere::placed) {
            frame.bodies[i].pose_W = report.pose_W;
        }
    }
}

Expected<void> PlayedHinges::carry_out(const TurnCommand& command) {
    const auto n_bodies = static_cast<std::int32_t>(lesson_.bodies.size());
    if (command.body < 0 || command.body >= n_bodies ||
        !lesson_.bodies[static_cast<std::size_t>(command.body)].hinge) {
        return undeclared();
    }
    const auto body = lesson_.bodies.begin() + command.body;
    const auto axle = static_cast<std::size_t>(
        std::count_if(lesson_.bodies.begin(), body,
                      [](const BodyDescription& b) { return b.hinge.has_value(); }));
    AxleOrder& order = orders_.axles[axle];
    if (!order.is_set) {
        order.pivot_B = body->hinge->pivot_B;
        order.load_N = body->hinge->load_N;
        order.is_set = true;
    }
    if (command.angle_rad) {
        order.angle_rad = *command.angle_rad;
        ++order.n_angles;
    }
    if (command.spin_rad_per_s) {
        order.spin_rad_per_s = *command.spin_rad_per_s;
        ++order.n_spins;
    }
    if (command.pivot_W) {
        order.pivot_B = *command.pivot_W - body->position_W;
    }
    order.load_N = command.load_N.value_or(order.load_N);
    return {};
}

}  // namespace fulcrum::runtime
