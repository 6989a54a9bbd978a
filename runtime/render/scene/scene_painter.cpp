#include "runtime/render/scene/scene_painter.h"

#include "runtime/render/force_colour.h"
#include "runtime/render/overlay/measure.h"
#include "runtime/render/scene/looks.h"
#include "runtime/render/scene/shapes.h"
#include "runtime/render/theme.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::runtime {

namespace {

constexpr float kBallRadius_m = 0.05F;
constexpr double kIconOfMaterial_m = 0.045;
constexpr std::array<float, 4> kBallColour{0.55F, 0.55F, 0.58F, 1.0F};
constexpr float kOffered_px = 4.0F;  // at 720
constexpr float kShine_px = 14.0F;   // at 720; within it the rim
constexpr float kShineAlpha = 0.45F;
constexpr float kLitRim_px = 7.0F;    // at 720
constexpr float kArrowRim_px = 4.0F;  // at 720
constexpr float kGhostAlpha = 0.75F;
constexpr float kHiddenAlpha = 0.9F;
// What the stencil says about a pixel.
constexpr int kShadowMark = 1;
constexpr int kLightMark = 2;
constexpr int kArrowMark = 3;
constexpr int kHandMark = 4;
constexpr int kFloorMark = 5;
constexpr double kIconAngle_deg = 24.0;

std::array<float, 4> linear_of(const Colour& c) {
    return {to_linear(c.r), to_linear(c.g), to_linear(c.b), 1.0F};
}

SceneFrame frame_for(const Camera& camera, double floor_m, int map_size, int width, int height) {
    SceneFrame frame;
    frame.clip_from_world = camera.clip_from_world();
    frame.eye_W = camera.eye_W().cast<float>();
    frame.light = light_for(camera, floor_m, map_size);
    frame.width_px = width;
    frame.height_px = height;
    return frame;
}

// Its backs are never seen.
Expected<void> close(Expected<gl::Mesh>& mesh) {
    if (!mesh) {
        return tl::make_unexpected(mesh.error());
    }
    for (gl::MeshPart& part : mesh->levels.front()) {
        part.closed = true;
    }
    return {};
}

void start_picture(const gl::FrameTarget& target) {
    target.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glClearStencil(0);
    // The wall covers every pixel, so that colours need no clearing.
    glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

}  // namespace

Expected<ScenePainter> ScenePainter::create(int shadow_map_size) {
    auto shadows = ShadowPass::create(shadow_map_size);
    if (!shadows) {
        return tl::make_unexpected(shadows.error());
    }
    auto objects = ObjectPass::create();
    if (!objects) {
        return tl::make_unexpected(objects.error());
    }
    auto room = Room::create();
    if (!room) {
        return tl::make_unexpected(room.error());
    }
    auto ball = gl::upload(make_ball(kBallRadius_m, kBallColour));
    auto arm = gl::upload(make_arrow_shaft(linear_of(theme::kLeverArm)));
    for (auto* mesh : {&ball, &arm}) {
        if (auto closed = close(*mesh); !closed) {
            return tl::make_unexpected(closed.error());
        }
    }
    ScenePainter painter;
    for (std::size_t look = 0; look < kForceLooks; ++look) {
        const auto colour = linear_of(colour_of(static_cast<ForceLook>(look)));
        auto shaft = gl::upload(make_arrow_shaft(colour));
        auto head = gl::upload(make_arrow_head(colour));
        for (auto* mesh : {&shaft, &head}) {
            if (auto closed = close(*mesh); !closed) {
                return tl::make_unexpected(closed.error());
            }
        }
        painter.arrows_[look] = {std::move(*shaft), std::move(*head)};
    }
    painter.shadows_ = std::move(*shadows);
    painter.objects_ = std::move(*objects);
    painter.room_ = std::move(*room);
    painter.ball_ = std::move(*ball);
    painter.arm_ = std::move(*arm);
    return painter;
}

Expected<void> ScenePainter::add_model(const LoadedModel& model) {
    auto mesh = gl::upload(model);
    if (!mesh) {
        return tl::make_unexpected(mesh.error());
    }
    meshes_.insert_or_assign(model.name, std::move(*mesh));
    return {};
}

bool ScenePainter::has_model(const std::string& name) const {
    return meshes_.contains(name);
}

const gl::Mesh& ScenePainter::find(const std::string& model) const {
    const auto found = meshes_.find(model);
    return found == meshes_.end() ? ball_ : found->second;
}

void ScenePainter::draw_shadows(const SceneContent& content, const Light& light) const {
    shadows_.begin(light);
    for (const SceneItem& item : content.items) {
        if (item.casts_shadow) {
            shadows_.draw(*item.mesh, item.placement);
        }
    }
    shadows_.end();
}

Box ScenePainter::hand_seen(const View& view, const Camera& camera) const {
    return runtime::hand_seen(
        view, camera, [this](const std::string& name) -> const gl::Mesh& { return find(name); });
}

std::vector<SceneLabel> ScenePainter::draw_scene(const View& view, const Camera& camera,
                                                 const gl::FrameTarget& target, int width_px,
                                                 int height_px) const {
    SceneContent content = content_of(
        view, camera, [this](const std::string& name) -> const gl::Mesh& { return find(name); });
    const SceneFrame frame =
        frame_for(camera, view.ground_height_m, shadows_.size(), width_px, height_px);
    draw_shadows(content, frame.light);

    start_picture(target);
    objects_.begin(frame, shadows_);
    std::vector<Bounds> casters;
    for (const SceneItem& item : content.items) {
        if (item.near) {
            item.look > 0
                ? objects_.draw_of_material(*item.mesh, item.placement, item.level, item.look)
                : objects_.draw_lit(*item.mesh, item.placement, item.level);
            if (item.casts_shadow) {
                casters.push_back(item.bounds);
            }
        } else {
            objects_.draw_far(*item.mesh, item.placement, item.level, item.sunk_m);
        }
    }
    const float scale = Measure(width_px, height_px).scale;
    if (view.in_space) {
        room_.draw_space(camera, content.orbits, {width_px, height_px, scale});
    } else {
        room_.draw(frame, camera, {width_px, height_px, scale}, kFloorMark);
        room_.draw_shadows(frame, shadows_, casters, kShadowMark);
        room_.draw_marks(frame, content.marks);
    }
    draw_lights(content, scale);
    draw_hidden_hands(content);
    if (content.ghost) {
        objects_.draw_ghost(*content.ghost->mesh, content.ghost->placement, content.ghost->level,
                            with_alpha(theme::kGhost, kGhostAlpha * content.ghost_strength));
    }
    for (const SceneContent::Ghost& ghost : content.more_ghosts) {
        objects_.draw_ghost(*ghost.item.mesh, ghost.item.placement, ghost.item.level,
                            with_alpha(theme::kGhost, kGhostAlpha * ghost.strength));
    }
    draw_arms(content.arms, scale);
    for (const Arrow& arrow : content.arrows) {
        draw_arrow(arrow, camera, scale);
    }
    if (content.arrow) {
        draw_arrow(*content.arrow, camera, scale);
    }
    return std::move(content.labels);
}

// What a hand holds does not hide it: an apple is seen in the bucket, not the bucket through it.
void ScenePainter::draw_hidden_hands(const SceneContent& content) const {
    for (const SceneItem& item : content.items) {
        if (item.is_hand || item.is_held) {
            objects_.mark_seen(*item.mesh, item.placement, item.level, kHandMark);
        }
    }
    for (const SceneItem& item : content.items) {
        if (item.is_hand) {
            objects_.draw_hidden(*item.mesh, item.placement, item.level,
                                 with_alpha(theme::kHiddenHand, kHiddenAlpha), kHandMark);
        }
    }
}

// A thin light line around what may be chosen; a broad golden shine around what is lit.
void ScenePainter::draw_lights(const SceneContent& content, float scale) const {
    const auto outline = [&](const SceneItem& item, const Colour& colour, float width_px) {
        objects_.draw_outline(*item.mesh, item.placement, item.level, colour, width_px * scale,
                              kLightMark);
    };
    for (const SceneItem& item : content.items) {
        if (item.light != BodyLight::off) {
            objects_.draw_stencil(*item.mesh, item.placement, item.level, kLightMark);
        }
    }
    for (const SceneItem& item : content.items) {
        if (item.light == BodyLight::offered) {
            outline(item, theme::kOffered, kOffered_px);
        } else if (item.light == BodyLight::lit) {
            outline(item, with_alpha(theme::kLit, kShineAlpha), kShine_px);
            outline(item, theme::kLit, kLitRim_px);
        }
    }
}

// Lever arms lie over all else, as the arrows at their ends do.
void ScenePainter::draw_arms(const std::vector<Placement>& arms, float scale) const {
    if (arms.empty()) {
        return;
    }
    glDisable(GL_DEPTH_TEST);
    for (const Placement& arm : arms) {
        objects_.draw_far(arm_, arm, 0, 0.0);
        objects_.draw_stencil(arm_, arm, 0, kArrowMark);
        objects_.draw_outline(arm_, arm, 0, theme::kForceOutline, kArrowRim_px * scale, kArrowMark);
    }
    glEnable(GL_DEPTH_TEST);
}

void ScenePainter::draw_arrow(const Arrow& arrow, const Camera& camera, float scale) const {
    // The force is never hidden: it is drawn over all else, with a light rim around. Both parts are
    // convex, so that the further one first and no back sides make depths needless.
    const ArrowModel& model = arrows_[static_cast<std::size_t>(arrow.look)];
    std::array<std::pair<const gl::Mesh*, const Placement*>, 2> parts{
        {{&model.shaft, &arrow.shaft}, {&model.head, &arrow.head}}};
    if ((arrow.tip_W - arrow.tail_W).dot(arrow.tip_W - camera.eye_W()) > 0.0) {
        std::swap(parts[0], parts[1]);
    }
    glDisable(GL_DEPTH_TEST);
    for (const auto& [mesh, placement] : parts) {
        objects_.draw_far(*mesh, *placement, 0, 0.0);
        objects_.draw_stencil(*mesh, *placement, 0, kArrowMark);
    }
    for (const auto& [mesh, placement] : parts) {
        objects_.draw_outline(*mesh, *placement, 0, theme::kForceOutline, kArrowRim_px * scale,
                              kArrowMark);
    }
    glEnable(GL_DEPTH_TEST);
}

void ScenePainter::draw_wall(const Camera& camera, const gl::FrameTarget& target) const {
    start_picture(target);
    room_.draw_wall(camera);
}

void ScenePainter::draw_icon(const std::string& model, const std::string& look, const Box& box,
                             int width_px, int height_px) const {
    const int width = static_cast<int>(box.width);
    const int height = static_cast<int>(box.height);
    if (width < 1 || height < 1) {
        return;
    }
    // From a little above, so far away that the model's ball fits.
    const gl::Mesh& mesh = find(model);
    const int material = look_number(look);
    // A ball and a box are of size 1, and a material's pattern is as fine as on a thing in the hand.
    const double scale = material > 0 ? kIconOfMaterial_m : 1.0;
    const Placement placement = place(Pose{}, Vector3::Constant(scale)).value_or(Placement{});
    const Vector3 middle = 0.5 * scale * (mesh.lowest + mesh.highest).cast<double>();
    const double radius_m = 0.5 * scale * static_cast<double>((mesh.highest - mesh.lowest).norm());
    const double away = 0.88 * radius_m / std::sin(0.5 * kIconAngle_deg * std::numbers::pi / 180.0);
    CameraDescription view;
    view.target_W = middle;
    view.eye_W = middle + away * Vector3(0.25, 0.40, 1.0).normalized();
    view.vertical_angle_deg = kIconAngle_deg;
    const Camera camera(view, width, height, 0.5);
    const SceneFrame frame = frame_for(camera, 0.0, shadows_.size(), width, height);

    GLint picture = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &picture);
    shadows_.begin(frame.light);
    shadows_.draw(mesh, placement);
    shadows_.end();
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(picture));
    glViewport(static_cast<GLint>(box.x), height_px - static_cast<GLint>(box.y) - height, width,
               height);
    glEnable(GL_DEPTH_TEST);
    objects_.begin(frame, shadows_);
    material > 0 ? objects_.draw_of_material(mesh, placement, 1, material)
                 : objects_.draw_lit(mesh, placement, 1);
    glViewport(0, 0, width_px, height_px);
}

}  // namespace fulcrum::runtime
