#include "runtime/effect/surface/plan_touch.h"

#include "haptics/coupling/virtual_coupling.h"
#include "haptics/loop/axle_stage.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/point/make_proxy.h"
#include "runtime/effect/surface/plan_walls.h"
#include "runtime/scene/body_shape.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <cmath>
#include <sstream>
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
    proxy.kind = has_friction || !is_round(hand.cursor) ? ProxyKind::friction_cone
                 : is_point                             ? ProxyKind::god_object
                                                        : ProxyKind::virtual_proxy;
    proxy.kind = hand.proxy.value_or(proxy.kind);
    proxy.structure = hand.structure;
    return proxy;
}

/// The hull of the model that the hand touches with.
Expected<HullShape> load_cursor(const HandDescription& hand, const SolidLoader& load_solid) {
    BodyDescription body;
    body.name = body.noun = "cursor";
    body.model = hand.cursor_model;
    body.line = hand.line;
    return load_solid(body)
        .and_then([](const MeshShape& mesh) { return make_body_shape(BodyShape::hull, mesh); })
        .map([](const SolidShape& shape) { return std::get<HullShape>(shape); });
}

/// What is right as a material may still be too much for this hand's scale and rate.
Expected<void> check_in_hand(const SolidPlan& solid, const MaterialDescription& material,
                             const HandDescription& hand) {
    const std::string& name = material.felt.name;
    if (auto good = validate(*solid.coupling); !good) {
        std::ostringstream scale;
        scale << hand.scale;
        return fail(name + " cannot be felt by a hand at scale " + scale.str() + ": " +
                        good.error().message,
                    at_line(hand.line), "give world:hand a scale nearer to 1");
    }
    const TransientSettings& tap = solid.surface.transient;
    if (auto good = validate_ringing(tap, hand.rate_hz); !good) {
        const long rate_hz = std::lround(std::ceil(tap.frequency_Hz / kFastestRinging));
        return fail(name + ": " + good.error().message, at_line(material.line),
                    "let it ring lower, or give world:hand a rate of " + std::to_string(rate_hz));
    }
    return {};
}

/// A ball, a post and a pill are felt by their formula, for their meshes would be felt as facets; other models as what the lesson makes
/// of them. The mesh of a box is the box itself. Tools are made for meshes.
Expected<PlacedShape> find_felt_shape(const BodyDescription& body, const HandDescription& hand,
                                      const MeshShape& mesh) {
    BodyShape kind = body.felt_as;
    if (kind == BodyShape::model) {
        kind = body.boxes.empty() && !hand.tool ? shape_of_model(body.model) : BodyShape::mesh;
        if (kind == BodyShape::ball) {
            return PlacedShape{SphereShape{body.radius_m}};
        }
        if (kind == BodyShape::box || kind == BodyShape::model) {
            return PlacedShape{mesh};
        }
    }
    auto felt = make_felt_shape(kind, mesh).and_then([](const PlacedShape& made) {
        return validate(made.shape).map([&made] { return made; });
    });
    if (felt && hand.tool) {
        felt = make_shape_mesh(felt->shape, felt->shape_B).map([](const MeshShape& made) {
            return PlacedShape{made};
        });
    }
    return felt.map_error([&](const Error& error) {
        return Error{"the " + body.noun + ": " + error.message, at_line(body.line),
                     error.what_to_do};
    });
}

/// How far from the axis a hand may press it.
double compute_reach(const AxleSettings& axle, const CollisionMesh& mesh) {
    double reach_m = 0.0;
    for (const Vector3& vertex_B : mesh.vertices_B()) {
        const Vector3 arm = vertex_B - axle.pivot_B;
        reach_m = std::max(reach_m, arm.cross(axle.axis_W).norm());
    }
    return reach_m;
}

/// The body of the newest solid turns.
Expected<void> add_axle(const BodyDescription& body, HapticPlan& plan) {
    if (body.movable) {
        return fail("the " + body.noun + " is on a hinge and movable", at_line(body.line),
                    "leave out one of them: what turns on a hinge does not fall");
    }
    const auto mesh = make_shape_mesh(plan.solids.back().shape, plan.solids.back().shape_B);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    plan.axles.push_back({plan.solids.size() - 1, *body.hinge, compute_reach(*body.hinge, **mesh)});
    return validate_axles(plan).map_error([&](const Error& error) {
        return Error{"the " + body.noun + ": " + error.message, at_line(body.line),
                     error.what_to_do};
    });
}

}  // namespace

Expected<std::vector<Material>> make_materials(const LessonDescription& lesson,
                                               const WallHolders& holders,
                                               const PictureLoader& load_picture, Plan& plan) {
    std::vector<Material> materials;
    for (const MaterialDescription& described : lesson.materials) {
        Material material = described.felt;
        if (auto* image = std::get_if<ImageTexture>(&material.texture.source);
            image != nullptr && !described.image.empty()) {
            auto picture = load_picture(described, image->tile_u_m);
            if (!picture) {
                return tl::unexpected(picture.error());
            }
            image->map = std::move(picture->heights);
            image->tile_v_m = image->tile_u_m * picture->height_per_width;
        }
        if (auto good = validate(material); !good) {
            return fail(good.error().message, at_line(described.line), good.error().what_to_do);
        }
        if (auto good = fit_material(described, holders, material, plan); !good) {
            return tl::unexpected(good.error());
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
        auto mesh = load_solid(as_felt(body));
        if (!mesh) {
            return tl::unexpected(mesh.error());
        }
        auto felt = find_felt_shape(as_felt(body), lesson.hand, *mesh);
        if (!felt) {
            return tl::unexpected(felt.error());
        }
        SolidPlan solid{static_cast<std::int32_t>(i), std::move(felt->shape),
                        Pose::at(body.position_W)};
        solid.shape_B = felt->shape_B;
        solid.lets_out = true;
        solid.surface.shading = body.shading;
        if (body.material != kNoMaterial) {
            put_material(materials[static_cast<std::size_t>(body.material)], solid);
            scale_coupling(*solid.coupling, lesson.hand.scale);
            solid.surface.audible = audible;
            const auto& material = lesson.materials[static_cast<std::size_t>(body.material)];
            if (auto good = check_in_hand(solid, material, lesson.hand); !good) {
                return good;
            }
        }
        plan.solids.push_back(std::move(solid));
        if (body.hinge) {
            if (auto good = add_axle(body, plan); !good) {
                return good;
            }
        }
    }
    return {};
}

Expected<void> choose_proxy(const LessonDescription& lesson, const SolidLoader& load_solid,
                            HapticPlan& plan) {
    if (plan.solids.empty()) {
        return {};
    }
    plan.proxy = proxy_settings(lesson.hand, plan.solids);
    if (!lesson.hand.cursor_model.empty()) {
        auto hull = load_cursor(lesson.hand, load_solid);
        if (!hull) {
            return fail("the cursor: " + hull.error().message, at_line(lesson.hand.line),
                        hull.error().what_to_do);
        }
        plan.proxy.cursor = std::move(*hull);
    }
    return validate(plan.proxy, plan.solids).map_error([&](const Error& error) {
        return Error{error.message, at_line(lesson.hand.line), error.what_to_do};
    });
}

}  // namespace fulcrum::runtime
