#include "runtime/scene/plan_touch.h"

#include "haptics/point/make_proxy.h"

#include <algorithm>
#include <string>

namespace fulcrum::runtime {
namespace {

/// What the lesson chose; or the least that shows what the scene has.
ProxySettings proxy_settings(const HandDescription& hand, const std::vector<SolidPlan>& solids) {
    ProxySettings proxy;
    proxy.cursor = hand.cursor;
    const bool has_friction =
        std::ranges::any_of(solids, [](const SolidPlan& solid) { return solid.friction.any(); });
    const bool is_point = std::holds_alternative<std::monostate>(hand.cursor);
    const bool is_ball = std::holds_alternative<SphereShape>(hand.cursor);
    proxy.kind = has_friction || (!is_point && !is_ball) ? ProxyKind::friction_cone
                 : is_ball                               ? ProxyKind::virtual_proxy
                                                         : ProxyKind::god_object;
    proxy.kind = hand.proxy.value_or(proxy.kind);
    return proxy;
}

}  // namespace

Expected<std::vector<Material>> make_materials(const LessonDescription& lesson,
                                               const PictureLoader& load_picture) {
    std::vector<Material> materials;
    for (const MaterialDescription& described : lesson.materials) {
        Material material = described.felt;
        if (auto* image = std::get_if<ImageTexture>(&material.texture.source);
            image != nullptr && !described.image.empty()) {
            auto map = load_picture(described);
            if (!map) {
                return tl::unexpected(map.error());
            }
            image->map = std::move(*map);
            image->tile_v_m = image->tile_u_m * image->map->n_v / image->map->n_u;
        }
        if (auto good = validate(material); !good) {
            return fail(good.error().message, at_line(described.line), good.error().what_to_do);
        }
        materials.push_back(std::move(material));
    }
    return materials;
}

Expected<void> add_solids(const LessonDescription& lesson, const SolidLoader& load_solid,
                          const std::vector<Material>& materials, bool audible, HapticPlan& plan) {
    for (std::size_t i = 0; i < lesson.bodies.size(); ++i) {
        const BodyDescription& body = lesson.bodies[i];
        if (!body.solid) {
            continue;
        }
        if (plan.solids.size() == static_cast<std::size_t>(kMaxSolids)) {
            return fail("the lesson has more than " + std::to_string(kMaxSolids) + " solid bodies",
                        at_line(body.line), "make fewer bodies solid");
        }
        auto mesh = load_solid(body);
        if (!mesh) {
            return tl::unexpected(mesh.error());
        }
        SolidPlan solid{static_cast<std::int32_t>(i), *mesh, Pose::at(body.position_W)};
        if (body.material != kNoMaterial) {
            put_material(materials[static_cast<std::size_t>(body.material)], solid);
            scale_coupling(*solid.coupling, lesson.hand.scale);
            solid.surface.audible = audible;
        }
        plan.solids.push_back(std::move(solid));
    }
    return {};
}

Expected<void> choose_proxy(const LessonDescription& lesson, HapticPlan& plan) {
    if (plan.solids.empty()) {
        return {};
    }
    plan.proxy = proxy_settings(lesson.hand, plan.solids);
    return validate(plan.proxy, plan.solids).map_error([&](const Error& error) {
        return Error{error.message, at_line(lesson.hand.line), error.what_to_do};
    });
}

}  // namespace fulcrum::runtime
