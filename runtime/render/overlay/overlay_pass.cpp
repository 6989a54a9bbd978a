#include "runtime/render/overlay/overlay_pass.h"

#include <cstddef>

namespace fulcrum::runtime {

namespace {

constexpr const char* kVertex = R"(
layout(location = 0) in vec2 a_position_px;
layout(location = 1) in vec2 a_uv;
layout(location = 2) in vec4 a_colour;
uniform vec2 u_size_px;
out vec2 v_uv;
out vec4 v_colour;
void main() {
  v_uv = a_uv;
  v_colour = a_colour;
  vec2 part = a_position_px / u_size_px;
  gl_Position = vec4(2.0 * part.x - 1.0, 1.0 - 2.0 * part.y, 0.0, 1.0);
}
)";

constexpr const char* kFragment = R"(
uniform sampler2D u_atlas;
in vec2 v_uv;
in vec4 v_colour;
out vec4 o_colour;
void main() { o_colour = vec4(v_colour.rgb, v_colour.a * texture(u_atlas, v_uv).r); }
)";

void describe_corner() {
    constexpr GLsizei kStride = sizeof(OverlayCorner);
    for (GLuint i = 0; i < 3; ++i) {
        glEnableVertexAttribArray(i);
    }
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride,
                          reinterpret_cast<const void*>(offsetof(OverlayCorner, x)));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride,
                          reinterpret_cast<const void*>(offsetof(OverlayCorner, u)));
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                          reinterpret_cast<const void*>(offsetof(OverlayCorner, rgba)));
}

void send_changed_rows(Font& font) {
    const auto [first, end] = font.take_changed_rows();
    if (first >= end) {
        return;
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first, kAtlasSide, end - first, GL_RED, GL_UNSIGNED_BYTE,
                    font.atlas().data() + static_cast<std::size_t>(first) * kAtlasSide);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

}  // namespace

Expected<OverlayPass> OverlayPass::create() {
    auto program = gl::Program::build("overlay", "", kVertex, kFragment);
    if (!program) {
        return tl::make_unexpected(program.error());
    }
    OverlayPass pass;
    pass.program_ = std::move(*program);
    pass.array_ = gl::VertexArray::make();
    pass.corners_ = gl::Buffer::make();
    glBindVertexArray(pass.array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, pass.corners_.name());
    describe_corner();
    pass.atlas_ = gl::Texture::make();
    glBindTexture(GL_TEXTURE_2D, pass.atlas_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kAtlasSide, kAtlasSide, 0, GL_RED, GL_UNSIGNED_BYTE,
                 nullptr);
    // A letter's pixels fall on the screen's, so the nearest one is the right one.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return pass;
}

void OverlayPass::draw(const DrawList& list, Font& font, int width_px, int height_px) const {
    if (list.corners().empty()) {
        return;
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, atlas_.name());
    send_changed_rows(font);
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(list.corners().size() * sizeof(OverlayCorner)),
                 list.corners().data(), GL_STREAM_DRAW);
    program_.use();
    program_.set("u_atlas", 0);
    program_.set("u_size_px",
                 Vector2f(static_cast<float>(width_px), static_cast<float>(height_px)));
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(list.corners().size()));
    glDisable(GL_BLEND);
}

}  // namespace fulcrum::runtime
