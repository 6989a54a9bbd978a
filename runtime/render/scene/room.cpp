#include "runtime/render/scene/room.h"

#include "runtime/render/scene/outdoors.h"
#include "runtime/render/scene/scene_shaders.h"
#include "runtime/render/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace fulcrum::runtime {

namespace {

constexpr int kFloorCorners = 96;  // corners of the floor's circle
constexpr std::size_t kNearCorners = 3UL * kFloorCorners;
constexpr std::size_t kFarCorners = 6UL * kFloorCorners;
constexpr float kFarFloor = 60.0F;      // radius of the floor, in reaches of the light
constexpr float kRugRadius = 0.62F;     // in reaches
constexpr double kMeadowFrom = 0.66;    // in reaches: outside the rug
constexpr float kNearestPlant = 0.75F;  // to the eye, in reaches
constexpr int kLeastMeadow_px =
    540;  // coarser pictures have no dots for blades of grass, nor the time
constexpr int kWallStrips = 64;
constexpr float kSkyHeight = 0.5F;         // from haze to full sky, in half pictures
constexpr std::size_t kFloatsPerMark = 8;  // position, place, look
constexpr std::size_t kMostMarks = 256;
constexpr float kMarkSize = 1.3F;     // half side of a mark's square, in radii
constexpr double kMarkLift = 0.0015;  // above the floor, in camera distances

/// Sets `count` floats a corner for each attribute in turn.
void describe(std::initializer_list<int> counts) {
    int stride = 0;
    for (const int count : counts) {
        stride += count;
    }
    std::size_t offset = 0;
    GLuint index = 0;
    for (const int count : counts) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, count, GL_FLOAT, GL_FALSE,
                              stride * static_cast<GLsizei>(sizeof(float)),
                              reinterpret_cast<const void*>(offset));
        offset += static_cast<std::size_t>(count) * sizeof(float);
        ++index;
    }
}

void fill(const gl::VertexArray& array, const gl::Buffer& buffer, const std::vector<float>& data,
          GLenum usage) {
    glBindVertexArray(array.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)), data.data(),
                 usage);
}

/// A disc of radius 1, then a ring from 1 to kFarFloor.
std::vector<float> floor_corners() {
    const auto at = [](int i, float radius) {
        const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kFloorCorners;
        return std::array<float, 2>{radius * std::cos(turn), radius * std::sin(turn)};
    };
    std::vector<float> corners;
    const auto add = [&](const std::array<float, 2>& corner) {
        corners.insert(corners.end(), corner.begin(), corner.end());
    };
    for (int i = 0; i < kFloorCorners; ++i) {
        add({0.0F, 0.0F});
        add(at(i, 1.0F));
        add(at(i + 1, 1.0F));
    }
    for (int i = 0; i < kFloorCorners; ++i) {
        for (const auto& corner : {at(i, 1.0F), at(i, kFarFloor), at(i + 1, 1.0F), at(i + 1, 1.0F),
                                   at(i, kFarFloor), at(i + 1, kFarFloor)}) {
            add(corner);
        }
    }
    return corners;
}

/// Strips from the bottom to the top of the picture; light grows cooler above the horizon.
std::vector<float> wall_corners(const Camera& camera) {
    // The horizon's height in the picture, -1 bottom to 1 top.
    const Matrix4f clip = camera.clip_from_world();
    const Vector3 level = Vector3(camera.forward_W().x(), 0.0, camera.forward_W().z());
    float horizon = 1.0F;
    if (level.norm() > 1e-6) {
        const Vector3 far = camera.eye_W() + 1e4 * camera.distance_m() * level.normalized();
        const Vector4f seen =
            clip * Vector4f(static_cast<float>(far.x()), static_cast<float>(far.y()),
                            static_cast<float>(far.z()), 1.0F);
        horizon = seen.w() > 0.0F ? std::clamp(seen.y() / seen.w(), -1.0F, 1.0F) : 1.0F;
    }
    std::vector<float> corners;
    for (int i = 0; i <= kWallStrips; ++i) {
        const float y = -1.0F + 2.0F * static_cast<float>(i) / kWallStrips;
        const float up = std::clamp((y - horizon) / kSkyHeight, 0.0F, 1.0F);
        const float part = up * up * (3.0F - 2.0F * up);
        const auto mixed = [&](float low, float high) { return low + part * (high - low); };
        for (const float x : {-1.0F, 1.0F}) {
            corners.insert(corners.end(), {x, y, mixed(theme::kWallBottom.r, theme::kWallTop.r),
                                           mixed(theme::kWallBottom.g, theme::kWallTop.g),
                                           mixed(theme::kWallBottom.b, theme::kWallTop.b)});
        }
    }
    return corners;
}

/// The higher a thing, the wider and fainter its mark; the ring stays.
void add_mark(std::vector<float>& corners, const FloorMark& mark, float floor_m, double unit_m) {
    const double height = std::clamp(mark.height_m / unit_m, 0.0, 1.0);
    const auto radius = static_cast<float>(mark.radius_m * (1.0 + 0.25 * height));
    const auto disc = static_cast<float>(mark.dashed ? 0.16 : 0.34 * (1.0 - 0.65 * height));
    const auto softness = static_cast<float>(0.55 + 0.4 * height);
    const float ring = height > 0.02 ? 0.42F : 0.0F;
    const auto x = static_cast<float>(mark.centre_W.x());
    const auto z = static_cast<float>(mark.centre_W.z());
    constexpr std::array<std::array<float, 2>, 6> kSquare{
        {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}};
    for (const auto& [u, v] : kSquare) {
        corners.insert(corners.end(),
                       {x + kMarkSize * radius * u, floor_m, z + kMarkSize * radius * v,
                        kMarkSize * u, kMarkSize * v, disc, softness, ring});
    }
}

/// A square on the floor that holds a thing's shadow.
void add_shadow(std::vector<float>& corners, const Bounds& caster, const Light& light) {
    constexpr float kSoftTexels = 6.0F;
    constexpr float kLift = 0.0005F;  // above the floor, in reaches of the light
    const Vector3f centre = caster.centre_W.cast<float>();
    const Vector3f to_lamp = light.to_lamp;
    const float height = centre.y() - light.centre_W.y();
    const Vector3f middle = centre - to_lamp * (height / to_lamp.y());
    const float half =
        static_cast<float>(caster.enclosing_radius_m) * 1.05F + kSoftTexels * light.texel_m;
    const float floor = light.centre_W.y() + kLift * light.reach_m;
    constexpr std::array<std::array<float, 2>, 6> kSquare{
        {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}};
    for (const auto& [u, v] : kSquare) {
        corners.insert(corners.end(), {middle.x() + half * u, floor, middle.z() + half * v});
    }
}

Vector3f as_stored(const Colour& colour) {
    return {colour.r, colour.g, colour.b};
}

}  // namespace

Expected<Room> Room::create() {
    const std::string floor = shaders::kGroundFragment;
    const std::string shadow = std::string(shaders::kLighting) + shaders::kFloorShadowFragment;
    auto floor_shadow = gl::Program::build("floor shadow", "#define TAPS 3\n#define SPREAD 3.0\n",
                                           shaders::kFloorShadowVertex, shadow);
    auto near_floor = gl::Program::build("floor", "#define NEAR\n", shaders::kGroundVertex, floor);
    auto far_floor = gl::Program::build("far floor", "", shaders::kGroundVertex, floor);
    auto wall = gl::Program::build("wall", "", shaders::kSkyVertex, shaders::kSkyFragment);
    auto sky = gl::Program::build("sky", "", shaders::kSkyVertex, shaders::kSkyFragment);
    auto grown = gl::Program::build("meadow", "", shaders::kMeadowVertex, shaders::kSkyFragment);
    auto mark = gl::Program::build("mark", "", shaders::kMarkVertex, shaders::kMarkFragment);
    auto dashed = gl::Program::build("dashed mark", "#define DASHES 14.0\n", shaders::kMarkVertex,
                                     shaders::kMarkFragment);
    for (const auto* program :
         {&near_floor, &far_floor, &wall, &sky, &grown, &mark, &dashed, &floor_shadow}) {
        if (!*program) {
            return tl::make_unexpected(program->error());
        }
    }
    Room room;
    room.near_floor_ = std::move(*near_floor);
    room.far_floor_ = std::move(*far_floor);
    room.wall_ = std::move(*wall);
    room.sky_ = std::move(*sky);
    room.meadow_ = std::move(*grown);
    room.mark_ = std::move(*mark);
    room.dashed_mark_ = std::move(*dashed);
    room.floor_shadow_ = std::move(*floor_shadow);
    for (auto* array : {&room.floor_array_, &room.wall_array_, &room.sky_array_,
                        &room.meadow_array_, &room.shadow_array_, &room.mark_array_}) {
        *array = gl::VertexArray::make();
    }
    for (auto* buffer : {&room.floor_corners_, &room.wall_corners_, &room.sky_corners_,
                         &room.meadow_corners_, &room.shadow_corners_, &room.mark_corners_}) {
        *buffer = gl::Buffer::make();
    }
    fill(room.floor_array_, room.floor_corners_, floor_corners(), GL_STATIC_DRAW);
    describe({2});
    fill(room.wall_array_, room.wall_corners_, {}, GL_DYNAMIC_DRAW);
    describe({2, 3});
    fill(room.sky_array_, room.sky_corners_, {}, GL_DYNAMIC_DRAW);
    describe({2, 4});
    Meadow meadow = make_meadow(kMeadowFrom);
    fill(room.meadow_array_, room.meadow_corners_, meadow.corners, GL_STATIC_DRAW);
    describe({3, 3});
    room.plants_ = std::move(meadow.plants);
    fill(room.shadow_array_, room.shadow_corners_, {}, GL_DYNAMIC_DRAW);
    describe({3});
    fill(room.mark_array_, room.mark_corners_, {}, GL_DYNAMIC_DRAW);
    describe({3, 2, 3});
    return room;
}

void Room::draw_floor(const gl::Program& program, const SceneFrame& frame, std::size_t first,
                      std::size_t count) const {
    program.use();
    program.set("u_clip_from_world", frame.clip_from_world);
    program.set("u_centre", frame.light.centre_W);
    program.set("u_reach_m", frame.light.reach_m);
    program.set("u_rug_m", kRugRadius * frame.light.reach_m);
    program.set("u_sun", Vector2f(frame.light.to_light.x(), frame.light.to_light.z()));
    program.set("u_fade_m", kHazeReach * frame.light.reach_m);
    program.set("u_floor", as_stored(theme::kFloor));
    program.set("u_rug", as_stored(theme::kRug));
    program.set("u_rug_ring", as_stored(theme::kRugRing));
    program.set("u_horizon", as_stored(theme::kHaze));
    glBindVertexArray(floor_array_.name());
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(first), static_cast<GLsizei>(count));
}

void Room::draw(const SceneFrame& frame, const Camera& camera, const PictureSize& size,
                int mark) const {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, mark, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    draw_floor(near_floor_, frame, 0, kNearCorners);
    draw_floor(far_floor_, frame, kNearCorners, kFarCorners);
    if (size.height_px >= kLeastMeadow_px) {
        draw_meadow(frame, mark);
    }
    glDisable(GL_STENCIL_TEST);
    draw_wall(camera);
    draw_sky(camera, size);
}

void Room::draw_meadow(const SceneFrame& frame, int mark) const {
    const Vector3f eye = (frame.eye_W - frame.light.centre_W) / frame.light.reach_m;
    std::vector<GLint> firsts;
    std::vector<GLsizei> counts;
    for (const Plant& plant : plants_) {
        // Right before the eye one would hide half the picture.
        if ((plant.foot - eye).norm() > kNearestPlant) {
            firsts.push_back(plant.first);
            counts.push_back(plant.count);
        }
    }
    glStencilFunc(GL_EQUAL, mark, 0xFF);
    glDisable(GL_DEPTH_TEST);
    meadow_.use();
    meadow_.set("u_clip_from_world", frame.clip_from_world);
    meadow_.set("u_centre", frame.light.centre_W);
    meadow_.set("u_reach_m", frame.light.reach_m);
    meadow_.set("u_fade_m", kHazeReach * frame.light.reach_m);
    meadow_.set("u_horizon", as_stored(theme::kHaze));
    glBindVertexArray(meadow_array_.name());
    glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(),
                      static_cast<GLsizei>(counts.size()));
    glEnable(GL_DEPTH_TEST);
}

void Room::draw_sky(const Camera& camera, const PictureSize& size) const {
    const std::vector<float> corners = sky_corners(camera, size);
    fill(sky_array_, sky_corners_, corners, GL_DYNAMIC_DRAW);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    sky_.use();
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size() / kFloatsPerSkyCorner));
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
}

void Room::draw_shadows(const SceneFrame& frame, const ShadowPass& shadows,
                        const std::vector<Bounds>& casters, int mark) const {
    std::vector<float> corners;
    for (std::size_t i = 0; i < std::min(casters.size(), kMostMarks); ++i) {
        add_shadow(corners, casters[i], frame.light);
    }
    if (corners.empty()) {
        return;
    }
    fill(shadow_array_, shadow_corners_, corners, GL_DYNAMIC_DRAW);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NOTEQUAL, mark, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    floor_shadow_.use();
    floor_shadow_.set("u_clip_from_world", frame.clip_from_world);
    floor_shadow_.set("u_shadow_from_world", frame.light.shadow_from_world);
    floor_shadow_.set("u_shadow_texel", 1.0F / static_cast<float>(shadows.size()));
    floor_shadow_.set("u_shadow_map", 1);
    floor_shadow_.set("u_in_shadow", as_stored(theme::kShadow));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size() / 3));
    glDepthMask(GL_TRUE);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
}

void Room::draw_wall(const Camera& camera) const {
    fill(wall_array_, wall_corners_, wall_corners(camera), GL_DYNAMIC_DRAW);
    glDepthFunc(GL_LEQUAL);
    wall_.use();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (kWallStrips + 1));
    glDepthFunc(GL_LESS);
}

void Room::draw_space(const Camera& camera, const std::vector<Orbit>& orbits,
                      const PictureSize& size) const {
    const std::vector<float> corners = space_corners(camera, orbits, size);
    fill(wall_array_, wall_corners_, corners, GL_DYNAMIC_DRAW);
    glDepthFunc(GL_LEQUAL);
    wall_.use();
    // All lies at one depth, the furthest: the later is seen, and things stand before it.
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size() / kFloatsPerWallCorner));
    glDepthFunc(GL_LESS);
}

void Room::draw_marks(const SceneFrame& frame, const std::vector<FloorMark>& marks) const {
    const double unit_m = static_cast<double>(frame.light.reach_m);
    const float floor_m = frame.light.centre_W.y() + static_cast<float>(kMarkLift * unit_m);
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    for (const bool dashed : {false, true}) {
        std::vector<float> corners;
        for (std::size_t i = 0; i < std::min(marks.size(), kMostMarks); ++i) {
            if (marks[i].dashed == dashed) {
                add_mark(corners, marks[i], floor_m, unit_m);
            }
        }
        if (corners.empty()) {
            continue;
        }
        fill(mark_array_, mark_corners_, corners, GL_DYNAMIC_DRAW);
        const gl::Program& program = dashed ? dashed_mark_ : mark_;
        program.use();
        program.set("u_clip_from_world", frame.clip_from_world);
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size() / kFloatsPerMark));
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace fulcrum::runtime
