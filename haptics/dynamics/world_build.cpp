// The load-path half of world.h.
#include "haptics/base/range.h"
#include "haptics/dynamics/world.h"

#include <string>

namespace fulcrum {
namespace {

Expected<void> validate_body(const WorldBodyPlan& body, std::size_t index) {
    const std::string of = " of body " + std::to_string(index);
    const Range ranges[] = {
        {"mass in kilograms" + of, body.mass_kg, kLeastFalling_kg, 1e4},
        {"felt mass in kilograms" + of, body.felt_mass_kg, 0.0, 1e4},
        {"radius in metres" + of, body.radius_m, 0.001, 10.0},
        {"drag area in square metres" + of, body.drag_area_m2, 0.0, 10.0},
    };
    return check_ranges("the world plan's", ranges);
}

}  // namespace

Expected<void> validate(const WorldPlan& plan) {
    const Range ranges[] = {
        {"rate in hertz", plan.rate_hz, 100.0, 1000.0},
        {"gravity in metres per second squared", plan.gravity_W.norm(), 0.0, 100.0},
        {"ground height in metres", plan.ground_height_m, -1000.0, 1000.0},
        {"number of bodies", static_cast<double>(plan.bodies.size()), 0.0, kMaxBodies},
        {"catcher's opening radius in metres", plan.catcher.opening_radius_m, 0.001, 10.0},
        {"catcher's depth in metres", plan.catcher.depth_m, 0.0, 10.0},
        {"catcher's distance from the tool in metres", plan.catcher.rim_centre_T.norm(), 0.0, 10.0},
    };
    if (auto checked = check_ranges("the world plan's", ranges); !checked) {
        return checked;
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
