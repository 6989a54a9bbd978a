#include "runtime/effect/tool/tool_surfaces.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace fulcrum::runtime {
namespace {

// Bodies of one material share its relief.
std::shared_ptr<const Texture> find_texture(const LessonDescription& lesson,
                                            const std::vector<SolidPlan>& solids, std::size_t i,
                                            const std::vector<GodObjectPlan>& plans) {
    const auto material_of = [&](std::size_t k) {
        return lesson.bodies[static_cast<std::size_t>(solids[k].body)].material;
    };
    if (!solids[i].surface.texture.any()) {
        return nullptr;
    }
    for (std::size_t k = 0; k < i; ++k) {
        if (material_of(k) == material_of(i)) {
            return plans[k].texture;
        }
    }
    return std::make_shared<const Texture>(solids[i].surface.texture);
}

Expected<std::shared_ptr<const GodShading>> shade(const ShadingSettings& wanted,
                                                  const TriangleMesh& mesh) {
    if (!wanted.on) {
        return std::shared_ptr<const GodShading>{};
    }
    return GodShading::create(mesh, wanted);
}

}  // namespace

Expected<void> put_surfaces(const LessonDescription& lesson, const ToolBodyList& list,
                            const std::vector<SolidPlan>& solids, const TriangleMesh& tool,
                            std::vector<GodObjectPlan>& plans) {
    const auto of_tool = shade(lesson.hand.tool->shading, tool);
    if (!of_tool) {
        return tl::unexpected(of_tool.error());
    }
    for (std::size_t i = 0; i < plans.size(); ++i) {
        GodObjectPlan& plan = plans[i];
        plan.friction = solids[i].friction;
        plan.texture = find_texture(lesson, solids, i, plans);
        plan.tool_shading = *of_tool;
        // Bodies of one model that are alike in this share their normals.
        const ShadingSettings& wanted = solids[i].surface.shading;
        std::size_t shared = 0;
        while (shared < i &&
               (plans[shared].object != plan.object || solids[shared].surface.shading != wanted)) {
            ++shared;
        }
        if (shared < i) {
            plan.object_shading = plans[shared].object_shading;
            continue;
        }
        auto shading = shade(wanted, list.meshes[list.mesh_of[i]].mesh);
        if (!shading) {
            return tl::unexpected(shading.error());
        }
        plan.object_shading = std::move(*shading);
    }
    return {};
}

void leave_out_surfaces(const LessonDescription& lesson, Plan& plan) {
    std::vector<std::int32_t> told;
    for (SolidPlan& solid : plan.haptic.solids) {
        const BodyDescription& body = lesson.bodies[static_cast<std::size_t>(solid.body)];
        solid.coupling.reset();
        solid.surface = {};
        if (body.material == kNoMaterial || std::ranges::find(told, body.material) != told.end()) {
            continue;
        }
        told.push_back(body.material);
        const auto& material = lesson.materials[static_cast<std::size_t>(body.material)];
        plan.notices.push_back(to_sentence(
            {material.felt.name + ": a tool feels its friction and its texture, and neither its "
                                  "stiffness nor a tap",
             at_line(body.line), "bear that, or leave out the tool where they are to be felt"}));
    }
}

}  // namespace fulcrum::runtime
