// Whether a load adds its wrench and its derivatives to what is there, as every load must (load.h): several act together.
#pragma once

#include "haptics/dynamics/load.h"

#include <algorithm>

namespace fulcrum {

/// How far what the load makes of a full wrench and full derivatives is from their sum with what it makes of none; over the largest
/// entry of either. 0 to rounding; above 1e-3 where it sets or takes away instead.
inline double find_adding_error(const Load& load, const RigidState& state, double time_s = 0.0) {
    const auto entries_of = [](const Wrench& plain, const Wrench& linearised,
                               const WrenchJacobian& jacobian) {
        Matrix<double, 6, 14> all;
        all << (Vector6() << plain.force, plain.torque).finished(),
            (Vector6() << linearised.force, linearised.torque).finished(), jacobian.pose,
            jacobian.velocity;
        return all;
    };
    const auto add_to = [&](Wrench wrench, WrenchJacobian jacobian) {
        Wrench plain = wrench;
        load.add_wrench(state, time_s, plain);
        load.add_linearised_wrench(state, time_s, wrench, jacobian);
        return entries_of(plain, wrench, jacobian);
    };
    const Wrench wrench{{1.0, -2.0, 3.0}, {-4.0, 5.0, -6.0}};
    WrenchJacobian jacobian;
    for (int i = 0; i < 36; ++i) {
        jacobian.pose(i / 6, i % 6) = 10.0 + i;
        jacobian.velocity(i / 6, i % 6) = 50.0 - i;
    }
    const auto before = entries_of(wrench, wrench, jacobian);
    const auto alone = add_to({}, {});
    const double size = std::max(before.cwiseAbs().maxCoeff(), alone.cwiseAbs().maxCoeff());
    return (add_to(wrench, jacobian) - before - alone).cwiseAbs().maxCoeff() / size;
}

}  // namespace fulcrum
