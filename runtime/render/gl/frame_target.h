// Where the scene is drawn: several samples a pixel, then averaged into the framebuffer that is shown.
//
//   Shaders compute in light (linear) and store sRGB, so that bytes mean the same here and on the
//   screen, whatever it calls itself; edges are averaged as stored, which is even to the eye.
//
// Thread: the one that holds the context. Cost: 8 bytes a sample.
#pragma once

#include "runtime/render/gl/handle.h"

namespace fulcrum::runtime::gl {

/// A multisampled framebuffer with depth and stencil.
class FrameTarget {
  public:
    /// Keeps or changes the size in pixels; takes fewer samples when the driver refuses. False when
    /// no framebuffer of this size can be had.
    [[nodiscard]] bool resize(int width, int height, int samples);

    /// Draws go here from now on.
    void bind() const;

    /// Averages the samples into another framebuffer's lower left corner, `width` x `height` pixels, which is bound from then on. A
    /// size other than its own only of one sample: it is stretched smoothly.
    void resolve_to(GLuint framebuffer, int width, int height) const;
    void resolve_to(const FrameTarget& target) const {
        resolve_to(target.framebuffer_.name(), target.width_, target.height_);
    }

  private:
    [[nodiscard]] bool build(int width, int height, int samples);

    Framebuffer framebuffer_;
    Renderbuffer colour_;
    Renderbuffer depth_;
    int width_ = 0;
    int height_ = 0;
    int samples_ = 0;
};

}  // namespace fulcrum::runtime::gl
