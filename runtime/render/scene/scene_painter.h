// Paints the scene of a View, or a model as an icon, into a frame target.
//
//   shadow map -> models -> floor, wall -> marks -> outlines -> ghost -> arrow
//
// Thread: the one that holds the context. Cost: see the passes.
#pragma once

#include "haptics/base/error.h"
#include "runtime/render/gl/frame_target.h"
#include "runtime/render/gl/mesh.h"
#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/scene/object_pass.h"
#include "runtime/render/scene/room.h"
#include "runtime/render/scene/scene_content.h"
#include "runtime/render/scene/shadow_pass.h"

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

namespace fulcrum::runtime {

/// Models and the passes that draw them.
class ScenePainter {
  public:
    [[nodiscard]] static Expected<ScenePainter> create(int shadow_map_size);

    [[nodiscard]] Expected<void> add_model(const LoadedModel& model);
    [[nodiscard]] bool has_model(const std::string& name) const;

    /// Paints a View's scene and says which words belong beside what.
    [[nodiscard]] std::vector<SceneLabel> draw_scene(const View& view, const Camera& camera,
                                                     const gl::FrameTarget& target, int width_px,
                                                     int height_px) const;

    /// Where in the picture the hand is seen; empty when it is not.
    [[nodiscard]] Box hand_seen(const View& view, const Camera& camera) const;

    /// Paints the wall alone.
    void draw_wall(const Camera& camera, const gl::FrameTarget& target) const;

    /// Paints a model, whole, into a box of the picture that was begun last, with nothing around; of a material, where it has a look.
    void draw_icon(const std::string& model, const std::string& look, const Box& box, int width_px,
                   int height_px) const;

  private:
    struct ArrowModel {
        gl::Mesh shaft;
        gl::Mesh head;
    };
    ScenePainter() = default;
    [[nodiscard]] const gl::Mesh& find(const std::string& model) const;
    void draw_shadows(const SceneContent& content, const Light& light) const;
    void draw_hidden_hands(const SceneContent& content) const;
    void draw_lights(const SceneContent& content, float scale) const;
    void draw_arms(const std::vector<Placement>& arms, float scale) const;
    void draw_arrow(const Arrow& arrow, const Camera& camera, float scale) const;

    ShadowPass shadows_;
    ObjectPass objects_;
    Room room_;
    std::unordered_map<std::string, gl::Mesh> meshes_;
    gl::Mesh ball_;
    std::array<ArrowModel, kForceLooks> arrows_;
    gl::Mesh arm_;
};

}  // namespace fulcrum::runtime
