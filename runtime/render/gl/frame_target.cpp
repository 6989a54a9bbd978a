#include "runtime/render/gl/frame_target.h"

#include <algorithm>

namespace fulcrum::runtime::gl {

bool FrameTarget::resize(int width, int height, int samples) {
    if (width == width_ && height == height_ && samples == samples_) {
        return true;
    }
    GLint most_samples = 1;
    GLint widest = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &widest);
    width_ = 0;
    if (width > widest || height > widest) {
        return false;
    }
    for (int tried = std::min(samples, static_cast<int>(most_samples)); tried >= 1; tried /= 2) {
        if (build(width, height, tried)) {
            width_ = width;
            height_ = height;
            samples_ = samples;
            return true;
        }
    }
    return false;
}

bool FrameTarget::build(int width, int height, int samples) {
    while (glGetError() != GL_NO_ERROR) {
    }
    const int stored_samples = samples > 1 ? samples : 0;
    framebuffer_ = Framebuffer::make();
    colour_ = Renderbuffer::make();
    depth_ = Renderbuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, colour_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, stored_samples, GL_RGBA8, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, stored_samples, GL_DEPTH24_STENCIL8, width,
                                     height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              colour_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              depth_.name());
    const bool whole = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    return glGetError() == GL_NO_ERROR && whole;
}

void FrameTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glDisable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_MULTISAMPLE);
    glViewport(0, 0, width_, height_);
}

void FrameTarget::resolve_to(GLuint framebuffer, int width, int height) const {
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                      width == width_ && height == height_ ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

}  // namespace fulcrum::runtime::gl
