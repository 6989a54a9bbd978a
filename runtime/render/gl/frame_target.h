// Where the scene is drawn: several samples a pixel, sRGB storage, so that light adds up and edges
// are averaged as light; then copied as bytes to the framebuffer that is shown.
//
// Thread: the one that holds the context. Cost: (8 samples + 4) bytes a pixel.
#pragma once

#include "haptics/base/error.h"
#include "runtime/render/gl/handle.h"

namespace fulcrum::runtime::gl {

/// A multisampled framebuffer and its resolved copy.
class FrameTarget {
  public:
    /// Keeps or changes the size in pixels; takes fewer samples when the driver refuses. False when
    /// no framebuffer of this size can be had.
    [[nodiscard]] bool resize(int width, int height, int samples);

    /// Draws go here from now on, blending and writing light (sRGB conversion is on).
    void bind() const;

    /// Averages the samples and copies them to another framebuffer's lower left corner, which is
    /// bound from then on; sRGB conversion is off.
    void resolve_to(GLuint framebuffer) const;

  private:
    [[nodiscard]] bool build(int width, int height, int samples);

    Framebuffer drawn_;
    Renderbuffer drawn_colour_;
    Renderbuffer drawn_depth_;
    Framebuffer resolved_;
    Renderbuffer resolved_colour_;
    int width_ = 0;
    int height_ = 0;
    int samples_ = 0;
};

}  // namespace fulcrum::runtime::gl
