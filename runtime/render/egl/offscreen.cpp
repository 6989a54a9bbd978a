#include "runtime/render/egl/offscreen.h"

#include "runtime/render/gl/handle.h"
#include "runtime/render/gl/read_framebuffer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace fulcrum::runtime {

namespace {

constexpr int kLargestSide = 16384;
constexpr const char* kNoContext = "OpenGL without a display is not available";
constexpr const char* kInstall = "install the packages libegl-mesa0 and libgl1-mesa-dri";

/// A display that needs no screen: Mesa's surfaceless one, else the first graphics device.
EGLDisplay screenless_display() {
    const char* known = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto has = [&](const char* extension) {
        return known != nullptr && std::strstr(known, extension) != nullptr;
    };
    if (!has("EGL_EXT_platform_base")) {
        return EGL_NO_DISPLAY;
    }
    if (has("EGL_MESA_platform_surfaceless")) {
        EGLDisplay display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) {
            return display;
        }
    }
    if (has("EGL_EXT_platform_device") && has("EGL_EXT_device_enumeration")) {
        EGLDeviceEXT device = nullptr;
        EGLint count = 0;
        if (eglQueryDevicesEXT(1, &device, &count) == EGL_TRUE && count > 0) {
            EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
            if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) {
                return display;
            }
        }
    }
    return EGL_NO_DISPLAY;
}

EGLContext make_context(EGLDisplay display) {
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
        return EGL_NO_CONTEXT;
    }
    const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &count) != EGL_TRUE || count < 1) {
        return EGL_NO_CONTEXT;
    }
    const std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                        3,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        3,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
}

}  // namespace

struct Offscreen::Parts {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    gl::Framebuffer framebuffer;
    gl::Renderbuffer colour;
    int width = 0;
    int height = 0;

    ~Parts() {
        // Names go first, while their context is current.
        if (context != EGL_NO_CONTEXT) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
            framebuffer = {};
            colour = {};
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(display, context);
        }
        // The display stays initialised: EGL shares one among all that asked for it.
    }
};

Offscreen::Offscreen(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Offscreen::~Offscreen() = default;

Expected<std::unique_ptr<Offscreen>> Offscreen::create(int width, int height) {
    auto parts = std::make_unique<Parts>();
    parts->display = screenless_display();
    if (parts->display == EGL_NO_DISPLAY) {
        return fail(kNoContext, {}, kInstall);
    }
    parts->context = make_context(parts->display);
    if (parts->context == EGL_NO_CONTEXT ||
        eglMakeCurrent(parts->display, EGL_NO_SURFACE, EGL_NO_SURFACE, parts->context) !=
            EGL_TRUE) {
        return fail("OpenGL 3.3 without a display is not available", {}, kInstall);
    }
    std::unique_ptr<Offscreen> offscreen(new Offscreen(std::move(parts)));
    if (auto sized = offscreen->resize(width, height); !sized) {
        return tl::make_unexpected(sized.error());
    }
    return offscreen;
}

Expected<void> Offscreen::resize(int width, int height) {
    eglMakeCurrent(parts_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, parts_->context);
    GLint widest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &widest);
    widest = std::min(widest, kLargestSide);
    if (width < 1 || height < 1 || width > widest || height > widest) {
        return fail("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels cannot be drawn",
                    {}, "choose 1 to " + std::to_string(widest) + " pixels a side");
    }
    gl::Framebuffer framebuffer = gl::Framebuffer::make();
    gl::Renderbuffer colour = gl::Renderbuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, colour.name());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.name());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        make_current();
        return fail("the driver has no memory for a picture of this size", {},
                    "choose a smaller one");
    }
    parts_->framebuffer = std::move(framebuffer);
    parts_->colour = std::move(colour);
    parts_->width = width;
    parts_->height = height;
    make_current();
    return {};
}

void Offscreen::make_current() {
    eglMakeCurrent(parts_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, parts_->context);
    glBindFramebuffer(GL_FRAMEBUFFER, parts_->framebuffer.name());
    glViewport(0, 0, parts_->width, parts_->height);
}

void Offscreen::finish() const {
    glFinish();
}

int Offscreen::width() const {
    return parts_->width;
}
int Offscreen::height() const {
    return parts_->height;
}

Image Offscreen::read_back() const {
    return gl::read_framebuffer(parts_->framebuffer.name(), parts_->width, parts_->height);
}

}  // namespace fulcrum::runtime
