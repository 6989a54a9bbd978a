#include "runtime/render/gl/read_framebuffer.h"

#include <algorithm>
#include <cstring>

namespace fulcrum::runtime::gl {

Image read_framebuffer(GLuint framebuffer, int width, int height) {
    Image image;
    image.width = std::max(width, 0);
    image.height = std::max(height, 0);
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(image.width);
    const auto rows = static_cast<std::size_t>(image.height);
    std::vector<std::uint8_t> upside_down(row_bytes * rows);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.data());
    // OpenGL counts rows from the bottom.
    image.rgba.resize(upside_down.size());
    for (std::size_t row = 0; row < rows; ++row) {
        std::memcpy(image.rgba.data() + row * row_bytes,
                    upside_down.data() + (rows - 1 - row) * row_bytes, row_bytes);
    }
    return image;
}

}  // namespace fulcrum::runtime::gl
