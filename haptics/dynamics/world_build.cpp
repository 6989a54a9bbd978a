// The load-path half of world.h.
#include "haptics/dynamics/world.h"

#include <sstream>

namespace fulcrum {
namespace {

Expected<void> check_range(const std::string& what, double value, double low, double high) {
    if (value >= low && value <= high) {
        return {};
    }
    std::ostringstream message;
    message << "the world plan's " << what << " is " << value << ", outside the range " << low
            << " to " << high;
    return fail(message.str(), {}, "set it within that range");
}

Expected<void> validate_body(const WorldBodyPlan& body, std::size_t index) {
    const std::string of = " of body " + std::to_string(index);
    const Expected<void> checks[] = {
        check_range("mass in kilograms" + of, body.mass_kg, 1e-6, 1e4),
        check_range("felt mass in kilograms" + of, body.felt_mass_kg, 0.0, 1e4),
        check_range("radius in metres" + of, body.radius_m, 0.001, 10.0),
        check_range("drag area in square metres" + of, body.drag_area_m2, 0.0, 10.0),
    };
    for (const Expected<void>& check : checks) {
        if (!check) {
            return check;
        }
    }
    return {};
}

}  // namespace

Expected<void> validate(const WorldPlan& plan) {
    const Expected<void> checks[] = {
        check_range("rate in hertz", plan.rate_hz, 100.0, 1000.0),
        check_range("gravity in metres per second squared", plan.gravity_W.norm(), 0.0, 100.0),
        check_range("ground height in metres", plan.ground_height_m, -1000.0, 1000.0),
        check_range("number of bodies", static_cast<double>(plan.bodies.size()), 0.0, kMaxBodies),
        check_range("catcher's opening radius in metres", plan.catcher.opening_radius_m, 0.001,
                    10.0),
        check_range("catcher's depth in metres", plan.catcher.depth_m, 0.0, 10.0),
        check_range("catcher's distance from the tool in metres", plan.catcher.rim_centre_T.norm(),
                    0.0, 10.0),
    };
    for (const Expected<void>& check : checks) {
        if (!check) {
            return check;
        }
    }
    for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
        if (auto check = validate_body(plan.bodies[i], i); !check) {
            return check;
        }
    }
    return {};
}

World::World(const WorldPlan& plan) : plan_(plan), catcher_(plan.catcher) {
    bodies_.reserve(plan.bodies.size());
    for (const WorldBodyPlan& body : plan.bodies) {
        bodies_.push_back(make_rigid_body(body));
    }
    snapshot_.n_bodies = static_cast<std::int32_t>(plan.bodies.size());
    describe();
}

}  // namespace fulcrum
