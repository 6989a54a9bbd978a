#include "runtime/render/scene/shadow_pass.h"

#include "runtime/render/scene/scene_shaders.h"

#include <array>

namespace fulcrum::runtime {

Expected<ShadowPass> ShadowPass::create(int size) {
    auto program =
        gl::Program::build("shadow", "", shaders::kShadowVertex, shaders::kShadowFragment);
    if (!program) {
        return tl::make_unexpected(program.error());
    }
    ShadowPass pass;
    pass.program_ = std::move(*program);
    pass.size_ = size;
    pass.map_ = gl::Texture::make();
    glBindTexture(GL_TEXTURE_2D, pass.map_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    // Outside the map all is in the light.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    const std::array<float, 4> lit{1.0F, 1.0F, 1.0F, 1.0F};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit.data());

    pass.framebuffer_ = gl::Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, pass.framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, pass.map_.name(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        return fail("the driver cannot draw shadows", {}, "update the graphics driver");
    }
    return pass;
}

void ShadowPass::begin(const Light& light) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, size_, size_);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    // What is above the lamp is flattened onto it instead of being cut off.
    glEnable(GL_DEPTH_CLAMP);
    // Depth grows with slope, so that a surface does not shade itself.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2.0F, 4.0F);
    glClear(GL_DEPTH_BUFFER_BIT);
    program_.use();
    program_.set("u_clip_from_world", light.clip_from_world);
}

void ShadowPass::draw(const gl::Mesh& mesh, const Placement& placement) const {
    program_.set("u_world_from_model", placement.world_from_model);
    glFrontFace(placement.mirrored ? GL_CW : GL_CCW);
    for (const gl::MeshPart& part : mesh.levels.back()) {
        gl::draw(part);
    }
}

void ShadowPass::end() const {
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
}

void ShadowPass::bind_map(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, map_.name());
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace fulcrum::runtime
