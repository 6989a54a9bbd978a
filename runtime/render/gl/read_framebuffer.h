// Takes a picture out of a framebuffer.
#pragma once

#include "runtime/render/image.h"

#include <epoxy/gl.h>

namespace fulcrum::runtime::gl {

/// The lower left `width` x `height` pixels of a framebuffer (0: the window's), rows from the top; waits for the drawing to
/// end. Needs the context to be current.
[[nodiscard]] Image read_framebuffer(GLuint framebuffer, int width, int height);

}  // namespace fulcrum::runtime::gl
