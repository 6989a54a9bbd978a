// What a View puts into the scene: models placed and checked, the ghost, the arrow, marks on the
// floor, and words beside things.
//
// Thread: any; values. Cost: linear in the bodies.
#pragma once

#include "runtime/render/camera.h"
#include "runtime/render/gl/mesh.h"
#include "runtime/render/overlay/labels.h"
#include "runtime/render/scene/arrow.h"
#include "runtime/render/scene/placement.h"
#include "runtime/render/scene/room.h"
#include "runtime/scene/view.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// A model in the scene.
struct SceneItem {
    const gl::Mesh* mesh = nullptr;
    Placement placement;
    Bounds bounds;
    BodyLight light = BodyLight::off;
    int look = 0;           ///< of a material, looks.h; 0: as it is painted
    std::size_t level = 0;  ///< of detail
    bool near = true;       ///< where the lamp's shadows reach
    bool casts_shadow = true;
    bool is_hand = false;
    bool is_held = false;  ///< within the hand, as an apple in a bucket
    double sunk_m = 0.0;   ///< how deep its lowest point is below the floor
};

/// Everything in one frame's scene.
struct SceneContent {
    std::vector<SceneItem> items;
    std::optional<SceneItem> ghost;
    float ghost_strength = 1.0F;  ///< 0 where tool and ghost are the same, 1 where they are apart
    /// Of the hands beside the first.
    struct Ghost {
        SceneItem item;
        float strength = 1.0F;
    };
    std::vector<Ghost> more_ghosts;
    std::optional<Arrow> arrow;
    std::vector<Arrow> arrows;    ///< of all other forces
    std::vector<Placement> arms;  ///< lever arms, to be drawn with make_arrow_shaft
    std::vector<FloorMark> marks;
    std::vector<Orbit> orbits;
    std::vector<SceneLabel> labels;
};

/// Finds a model by name; never fails, a plain ball stands for what is missing.
using FindMesh = std::function<const gl::Mesh&(const std::string&)>;

/// More forces and torques than this are left out.
inline constexpr std::size_t kMostForces = 8;

/// More bodies than this are left out.
inline constexpr std::size_t kMostBodies = 10'000;

/// Reads a View; whatever has a number that is not finite is left out.
[[nodiscard]] SceneContent content_of(const View& view, const Camera& camera,
                                      const FindMesh& find_mesh);

/// Where in the picture the hand is seen; empty when it is not.
[[nodiscard]] Box hand_seen(const View& view, const Camera& camera, const FindMesh& find_mesh);

}  // namespace fulcrum::runtime
