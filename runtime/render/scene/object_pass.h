// Draws models: lit, outlined, or as ghosts.
//
// Thread: the one that holds the context. Cost: one pass over the triangles; an outline or a ghost
// takes another.
#pragma once

#include "haptics/base/error.h"
#include "runtime/render/camera.h"
#include "runtime/render/colour.h"
#include "runtime/render/gl/mesh.h"
#include "runtime/render/gl/program.h"
#include "runtime/render/scene/light.h"
#include "runtime/render/scene/placement.h"
#include "runtime/render/scene/shadow_pass.h"

namespace fulcrum::runtime {

/// Where floor and things have faded into the haze, in reaches of the light.
inline constexpr float kHazeReach = 7.0F;

/// What every model in a frame is drawn with.
struct SceneFrame {
    Matrix4f clip_from_world{Matrix4f::Identity()};
    Vector3f eye_W{Vector3f::Zero()};
    Light light;
    int width_px = 1;
    int height_px = 1;
};

/// Draws models into the current framebuffer, which has depth and stencil.
class ObjectPass {
  public:
    [[nodiscard]] static Expected<ObjectPass> create();

    /// Sets up all programs for a frame; the shadow map stays on texture unit 1.
    void begin(const SceneFrame& frame, const ShadowPass& shadows) const;

    /// A lit model at a level of detail, see gl::Mesh, on which others' shadows can fall.
    void draw_lit(const gl::Mesh& mesh, const Placement& placement, std::size_t level = 0) const;
    /// The same of a material, by its number (looks.h), instead of as it is painted.
    void draw_of_material(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                          int look) const;
    /// A lit model on which no shadow falls. Up to `foot_m` above the floor it has the floor's
    /// colour, more so the lower: a far hill grows out of its meadow.
    void draw_far(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                  double foot_m) const;
    /// Marks a model's pixels with a number, so that an outline can go around them: before
    /// `draw_outline`.
    void draw_stencil(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                      int mark) const;
    /// A line around what was marked with a number.
    void draw_outline(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                      const Colour& colour, float width_px, int mark) const;
    /// A see-through model: one layer, however often it folds over itself.
    void draw_ghost(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                    const Colour& colour) const;
    /// Marks the pixels in which a model, drawn before, is seen.
    void mark_seen(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                   int mark) const;
    /// What other things hide of a model, seen through them: one layer, nothing where a pixel has
    /// the mark, which is left in those drawn. After all that can hide it, and `mark_seen` of it.
    void draw_hidden(const gl::Mesh& mesh, const Placement& placement, std::size_t level,
                     const Colour& colour, int mark) const;

  private:
    void draw_with(const gl::Program& program, const gl::Mesh& mesh, const Placement& placement,
                   std::size_t level) const;

    gl::Program lit_;
    gl::Program lit_of_material_;
    gl::Program lit_unshaded_;
    gl::Program outline_;
    gl::Program ghost_;
    gl::Texture white_;
};

}  // namespace fulcrum::runtime
