#include "runtime/render/scene/object_pass.h"

#include "runtime/render/scene/looks.h"
#include "runtime/render/scene/scene_shaders.h"
#include "runtime/render/theme.h"

#include <array>
#include <string>

namespace fulcrum::runtime {

namespace {

constexpr float kShadowOffsetTexels = 1.5F;  // along the normal, against a surface shading itself

void set_model(const gl::Program& program, const Placement& placement) {
    glFrontFace(placement.mirrored ? GL_CW : GL_CCW);
    program.set("u_world_from_model", placement.world_from_model);
    program.set("u_normal_from_model", placement.normal_from_model);
}

Vector4f as_vector(const Colour& colour) {
    return {colour.r, colour.g, colour.b, colour.a};
}

void draw_parts(const gl::Mesh& mesh, std::size_t level) {
    for (const gl::MeshPart& part : mesh.levels[level]) {
        gl::draw(part);
    }
}

}  // namespace

Expected<ObjectPass> ObjectPass::create() {
    ObjectPass pass;
    const std::string lit_fragment =
        std::string(shaders::kLooksFragment) + shaders::kLighting + shaders::kObjectFragment;
    auto lit = gl::Program::build("object", "#define TAPS 2\n#define SPREAD 1.6\n",
                                  shaders::kObjectVertex, lit_fragment);
    auto of_material = gl::Program::build("object of a material",
                                          "#define TAPS 2\n#define SPREAD 1.6\n#define LOOKS\n",
                                          shaders::kObjectVertex, lit_fragment);
    auto unshaded = gl::Program::build("far object", "#define NO_SHADOWS\n", shaders::kObjectVertex,
                                       lit_fragment);
    auto outline =
        gl::Program::build("outline", "", shaders::kOutlineVertex, shaders::kFlatFragment);
    auto ghost = gl::Program::build("ghost", "", shaders::kObjectVertex, shaders::kGhostFragment);
    for (const auto* program : {&lit, &of_material, &unshaded, &outline, &ghost}) {
        if (!*program) {
            return tl::make_unexpected(program->error());
        }
    }
    pass.lit_ = std::move(*lit);
    pass.lit_of_material_ = std::move(*of_material);
    pass.lit_unshaded_ = std::move(*unshaded);
    pass.outline_ = std::move(*outline);
    pass.ghost_ = std::move(*ghost);

    // What has no picture is white.
    pass.white_ = gl::Texture::make();
    glBindTexture(GL_TEXTURE_2D, pass.white_.name());
    const std::array<std::uint8_t, 4> white{255, 255, 255, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    return pass;
}

void ObjectPass::begin(const SceneFrame& frame, const ShadowPass& shadows) const {
    shadows.bind_map(1);
    for (const gl::Program* program : {&lit_, &lit_of_material_, &lit_unshaded_}) {
        program->use();
        program->set("u_clip_from_world", frame.clip_from_world);
        program->set("u_shadow_from_world", frame.light.shadow_from_world);
        program->set("u_shadow_offset_m", kShadowOffsetTexels * frame.light.texel_m);
        program->set("u_shadow_texel", 1.0F / static_cast<float>(shadows.size()));
        program->set("u_shadow_map", 1);
        program->set("u_picture", 0);
        program->set("u_to_light", frame.light.to_light);
        program->set("u_to_lamp", frame.light.to_lamp);
        program->set("u_eye", frame.eye_W);
        program->set("u_centre", frame.light.centre_W);
        program->set("u_fade_m", kHazeReach * frame.light.reach_m);
        program->set("u_horizon", Vector3f(theme::kHaze.r, theme::kHaze.g, theme::kHaze.b));
    }
    lit_unshaded_.use();
    lit_unshaded_.set("u_meadow", Vector3f(theme::kFloor.r, theme::kFloor.g, theme::kFloor.b));
    outline_.use();
    outline_.set("u_clip_from_world", frame.clip_from_world);
    outline_.set("u_pixel", Vector2f(2.0F / static_cast<float>(frame.width_px),
                                     2.0F / static_cast<float>(frame.height_px)));
    ghost_.use();
    ghost_.set("u_clip_from_world", frame.clip_from_world);
    ghost_.set("u_eye", frame.eye_W);
}

void ObjectPass::draw_lit(const gl::Mesh& mesh, const Placement& placement,
                          std::size_t level) const {
    lit_.use();
    draw_with(lit_, mesh, placement, level);
}

void ObjectPass::draw_of_material(const gl::Mesh& mesh, const Placement& placement,
                                  std::size_t level, int look) const {
    lit_of_material_.use();
    lit_of_material_.set("u_look", look);
    const Matrix3f stretched = placement.world_from_model.topLeftCorner<3, 3>();
    lit_of_material_.set("u_stretch", Vector3f(stretched.col(0).norm(), stretched.col(1).norm(),
                                               stretched.col(2).norm()));
    draw_with(lit_of_material_, mesh, placement, level);
}

void ObjectPass::draw_far(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                          double foot_m) const {
    lit_unshaded_.use();
    lit_unshaded_.set("u_foot_m", static_cast<float>(foot_m));
    draw_with(lit_unshaded_, mesh, placement, level);
}

void ObjectPass::draw_with(const gl::Program& program, const gl::Mesh& mesh,
                           const Placement& placement, std::size_t level) const {
    set_model(program, placement);
    glActiveTexture(GL_TEXTURE0);
    for (const gl::MeshPart& part : mesh.levels[level]) {
        const GLuint picture = part.texture >= 0
                                   ? mesh.textures[static_cast<std::size_t>(part.texture)].name()
                                   : white_.name();
        glBindTexture(GL_TEXTURE_2D, picture);
        const auto& c = part.base_colour;
        program.set("u_base_colour", Vector4f(c[0], c[1], c[2], c[3]));
        program.set("u_roughness", part.roughness);
        gl::draw(part);
    }
}

void ObjectPass::draw_stencil(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                              int mark) const {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, mark, 0xFF);
    glStencilOp(GL_KEEP, GL_REPLACE, GL_REPLACE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    outline_.use();
    set_model(outline_, placement);
    outline_.set("u_width_px", 0.0F);
    draw_parts(mesh, level);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDisable(GL_STENCIL_TEST);
}

void ObjectPass::draw_outline(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                              const Colour& colour, float width_px, int mark) const {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NOTEQUAL, mark, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    outline_.use();
    set_model(outline_, placement);
    outline_.set("u_width_px", width_px);
    outline_.set("u_flat", as_vector(colour));
    draw_parts(mesh, level);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDisable(GL_STENCIL_TEST);
}

void ObjectPass::draw_ghost(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                            const Colour& colour) const {
    ghost_.use();
    set_model(ghost_, placement);
    ghost_.set("u_flat", as_vector(colour));
    // First only the nearest depths, then colour where the depth is that one.
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_parts(mesh, level);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_EQUAL);
    glEnable(GL_BLEND);
    draw_parts(mesh, level);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
}

void ObjectPass::mark_seen(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                           int mark) const {
    ghost_.use();
    set_model(ghost_, placement);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, mark, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0F, -1.0F);  // a little nearer, for it lies there already
    draw_parts(mesh, level);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_STENCIL_TEST);
}

void ObjectPass::draw_hidden(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                             const Colour& colour, int mark) const {
    ghost_.use();
    set_model(ghost_, placement);
    ghost_.set("u_flat", as_vector(colour));
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NOTEQUAL, mark, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GREATER);
    glEnable(GL_BLEND);
    draw_parts(mesh, level);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_STENCIL_TEST);
}

}  // namespace fulcrum::runtime
