// Draws what the light sees: the depth of everything that casts a shadow.
//
// Thread: the one that holds the context. Cost: one pass over the triangles, 4 bytes a texel.
#pragma once

#include "haptics/base/error.h"
#include "runtime/render/gl/handle.h"
#include "runtime/render/gl/mesh.h"
#include "runtime/render/gl/program.h"
#include "runtime/render/scene/light.h"
#include "runtime/render/scene/placement.h"

namespace fulcrum::runtime {

/// A depth picture from the light, compared when it is looked up.
class ShadowPass {
  public:
    [[nodiscard]] static Expected<ShadowPass> create(int size);

    /// Starts an empty map; `draw` adds to it until `end`.
    void begin(const Light& light) const;
    void draw(const gl::Mesh& mesh, const Placement& placement) const;
    void end() const;

    /// Binds the map to a texture unit.
    void bind_map(int unit) const;
    [[nodiscard]] int size() const { return size_; }

  private:
    gl::Program program_;
    gl::Framebuffer framebuffer_;
    gl::Texture map_;
    int size_ = 0;
};

}  // namespace fulcrum::runtime
