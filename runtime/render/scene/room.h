// The room, in the open air: a sky with clouds over hills, a meadow with a round rug, and marks under things.
//
// Thread: the one that holds the context. Cost: each pixel of the floor looks up the shadow map.
#pragma once

#include "haptics/base/error.h"
#include "runtime/render/camera.h"
#include "runtime/render/gl/handle.h"
#include "runtime/render/gl/program.h"
#include "runtime/render/scene/object_pass.h"
#include "runtime/render/scene/outdoors.h"
#include "runtime/render/scene/space.h"

#include <vector>

namespace fulcrum::runtime {

/// A mark on the floor straight below a thing: where it is, and where it will land.
struct FloorMark {
    Vector3 centre_W{Vector3::Zero()};  ///< of the thing
    double radius_m = 0.05;             ///< of the thing
    double height_m = 0.0;              ///< of the thing's lowest point above the floor
    bool dashed = false;                ///< the hand's mark: a dashed ring
};

/// Wall, floor and marks.
class Room {
  public:
    [[nodiscard]] static Expected<Room> create();

    /// The floor, and where it is seen, marked with `mark` in the stencil, what grows on it: that hides nothing. Then the sky
    /// wherever nothing was drawn.
    void draw(const SceneFrame& frame, const Camera& camera, const PictureSize& size,
              int mark) const;
    /// The shadows of things on the floor. Marks each darkened pixel with `mark` in the stencil, so
    /// that none is darkened twice.
    void draw_shadows(const SceneFrame& frame, const ShadowPass& shadows,
                      const std::vector<Bounds>& casters, int mark) const;
    /// Only the wall, over the whole picture.
    void draw_wall(const Camera& camera) const;
    /// Stars and orbits on a dark sky, wherever nothing was drawn.
    void draw_space(const Camera& camera, const std::vector<Orbit>& orbits,
                    const PictureSize& size) const;
    /// Marks, over the floor and under things that stand before it.
    void draw_marks(const SceneFrame& frame, const std::vector<FloorMark>& marks) const;

  private:
    void draw_floor(const gl::Program& program, const SceneFrame& frame, std::size_t first,
                    std::size_t count) const;
    void draw_meadow(const SceneFrame& frame, int mark) const;
    void draw_sky(const Camera& camera, const PictureSize& size) const;

    gl::Program near_floor_;
    gl::Program far_floor_;
    gl::Program wall_;
    gl::Program sky_;
    gl::Program meadow_;
    gl::Program floor_shadow_;
    gl::Program mark_;
    gl::Program dashed_mark_;
    gl::VertexArray floor_array_;
    gl::Buffer floor_corners_;
    gl::VertexArray wall_array_;
    gl::Buffer wall_corners_;
    gl::VertexArray sky_array_;
    gl::Buffer sky_corners_;
    gl::VertexArray meadow_array_;
    gl::Buffer meadow_corners_;
    std::vector<Plant> plants_;
    gl::VertexArray shadow_array_;
    gl::Buffer shadow_corners_;
    gl::VertexArray mark_array_;
    gl::Buffer mark_corners_;
};

}  // namespace fulcrum::runtime
