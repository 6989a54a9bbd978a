#include "haptics/point/make_proxy.h"

#include "haptics/base/range.h"
#include "haptics/collision/convex_cursor.h"
#include "haptics/coupling/virtual_coupling.h"
#include "haptics/point/friction_cone.h"
#include "haptics/point/god_object.h"
#include "haptics/point/make_obstacle.h"
#include "haptics/point/virtual_proxy.h"

#include <algorithm>
#include <string>

namespace fulcrum {
namespace {

bool is_point(const ProxySettings& settings) {
    return std::holds_alternative<std::monostate>(settings.cursor);
}

Expected<void> check_cursor(const ProxySettings& settings) {
    if (settings.kind == ProxyKind::god_object && !is_point(settings)) {
        return fail("a god-object's cursor is a point", {},
                    "give it none, or take a virtual proxy");
    }
    if (settings.kind == ProxyKind::virtual_proxy && is_point(settings)) {
        return fail("a virtual proxy's cursor has a size", {},
                    "give it a sphere, or take a god-object");
    }
    const std::optional<SolidShape> body = to_solid_shape(settings.cursor);
    return body ? validate(*body) : Expected<void>{};
}

Expected<void> check_solid(const SolidPlan& solid, const CursorShape& cursor) {
    const auto told = [&solid](const Error& error) {
        return Error{"body " + std::to_string(solid.body) + ": " + error.message, error.where,
                     error.what_to_do};
    };
    if (!is_finite(solid.initial_pose_W) || !is_finite(solid.shape_B)) {
        return fail("body " + std::to_string(solid.body) + " has no finite pose", {},
                    "give it one");
    }
    return validate(solid.shape)
        .and_then([&] { return validate_pair(cursor, solid.shape); })
        .and_then([&] { return validate(solid.friction); })
        .and_then([&] { return validate(solid.surface); })
        .and_then([&] { return solid.coupling ? validate(*solid.coupling) : Expected<void>{}; })
        .map_error(told);
}

CursorTurning find_turning(const CursorShape& cursor, const std::vector<SolidPlan>& solids,
                           const ProxySurroundings& surroundings) {
    CursorTurning turning{.period_s = surroundings.period_s};
    if (const std::optional<SolidShape> shape = to_solid_shape(cursor); shape) {
        const ConvexBody body = make_convex_cursor(*shape);
        turning.least_m = find_least_reach_m(body);
        turning.farthest_m = body.core.bounding_radius_m();
    }
    turning.stiffness_N_per_m = 0.0;
    for (const SolidPlan& solid : solids) {
        turning.stiffness_N_per_m =
            std::max(turning.stiffness_N_per_m,
                     solid.coupling.value_or(surroundings.coupling).stiffness_N_per_m);
    }
    return turning;
}

std::unique_ptr<SurfaceObject> make_surface_object(const ProxySettings& settings,
                                                   const std::vector<SolidPlan>& solids,
                                                   const ProxySurroundings& surroundings) {
    const auto n_meshes = std::ranges::count_if(
        solids, [](const SolidPlan& solid) { return find_mesh(solid.shape) != nullptr; });
    const bool any_function = std::ranges::any_of(solids, [](const SolidPlan& solid) {
        return std::holds_alternative<DistanceShape>(solid.shape);
    });
    if (is_point(settings) && n_meshes == std::ssize(solids)) {
        return std::make_unique<GodObject>(solids, settings.structure);
    }
    if (is_point(settings) && n_meshes > 0 && !any_function) {
        return std::make_unique<GodObjectAmong<MixedSolid>>(solids, settings.structure);
    }
    return std::make_unique<VirtualProxy>(make_obstacles(settings.cursor, solids),
                                          find_turning(settings.cursor, solids, surroundings));
}

}  // namespace

Expected<void> validate(const ProxySettings& settings, const std::vector<SolidPlan>& solids) {
    if (solids.size() > static_cast<std::size_t>(kMaxSolids)) {
        return fail("more than " + std::to_string(kMaxSolids) + " bodies can be touched", {},
                    "make some of them untouchable");
    }
    const Range ranges[] = {
        {"rounds of friction", static_cast<double>(settings.friction_rounds), 1.0, 200.0}};
    Expected<void> good =
        check_ranges("the proxy's", ranges).and_then([&] { return check_cursor(settings); });
    for (std::size_t i = 0; good && i < solids.size(); ++i) {
        good = check_solid(solids[i], settings.cursor);
    }
    return good;
}

std::unique_ptr<Proxy> make_proxy(const ProxySettings& settings,
                                  const std::vector<SolidPlan>& solids,
                                  const ProxySurroundings& surroundings) {
    if (solids.empty()) {
        return nullptr;
    }
    auto surface_object = make_surface_object(settings, solids, surroundings);
    if (settings.kind != ProxyKind::friction_cone) {
        return surface_object;
    }
    std::vector<FrictionLaw> laws;
    laws.reserve(solids.size());
    for (const SolidPlan& solid : solids) {
        const CouplingSettings& coupling = solid.coupling.value_or(surroundings.coupling);
        laws.push_back(
            make_friction_law(solid.friction, coupling.stiffness_N_per_m, surroundings.period_s));
    }
    return std::make_unique<FrictionCone>(std::move(surface_object), std::move(laws),
                                          settings.friction_rounds);
}

}  // namespace fulcrum
