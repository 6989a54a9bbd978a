// Sends a draw list to the screen.
//
// Thread: the one that holds the context. Cost: one draw call; the atlas' new rows are sent once.
#pragma once

#include "haptics/base/error.h"
#include "runtime/render/gl/handle.h"
#include "runtime/render/gl/program.h"
#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/text/font.h"

namespace fulcrum::runtime {

/// Draws flat shapes and words over what is there.
class OverlayPass {
  public:
    [[nodiscard]] static Expected<OverlayPass> create();

    /// Draws into the current framebuffer of this size in pixels.
    void draw(const DrawList& list, Font& font, int width_px, int height_px) const;

  private:
    gl::Program program_;
    gl::VertexArray array_;
    gl::Buffer corners_;
    gl::Texture atlas_;
};

}  // namespace fulcrum::runtime
