// An OpenGL context and a framebuffer without any display, for screenshots and tests.
//
// Thread: the context belongs to the thread that made it. Cost: one framebuffer of 8 bytes a pixel.
// Source: Khronos EGL extensions EGL_MESA_platform_surfaceless, EGL_EXT_platform_device,
// EGL_KHR_surfaceless_context.
#pragma once

#include "haptics/base/error.h"
#include "runtime/render/image.h"

#include <memory>

namespace fulcrum::runtime {

/// A current OpenGL 3.3 core context that draws into memory.
class Offscreen {
  public:
    /// Makes a context without a display, makes it current and binds a framebuffer of this size in
    /// pixels (1 to 16384 a side, the driver may allow less). One sentence when there is none.
    [[nodiscard]] static Expected<std::unique_ptr<Offscreen>> create(int width, int height);

    Offscreen(const Offscreen&) = delete;
    Offscreen& operator=(const Offscreen&) = delete;
    ~Offscreen();

    /// Gives the framebuffer another size; an error leaves the old one.
    [[nodiscard]] Expected<void> resize(int width, int height);

    /// Makes context and framebuffer current again after others were.
    void make_current();

    /// Waits until everything is drawn.
    void finish() const;

    [[nodiscard]] int width() const;   ///< pixels
    [[nodiscard]] int height() const;  ///< pixels

    /// What has been drawn, rows from the top; waits for the drawing to end.
    [[nodiscard]] Image read_back() const;

  private:
    struct Parts;
    explicit Offscreen(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace fulcrum::runtime
