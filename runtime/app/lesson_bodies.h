// Where a lesson's bodies are at first, and which of them somebody looks at.
#pragma once

#include "haptics/handover/messages.h"
#include "runtime/scene/description.h"

#include <optional>
#include <vector>

namespace fulcrum::runtime {

/// What a world is told before the first frame: which bodies are there.
[[nodiscard]] std::vector<WorldCommand> place_at_first(const LessonDescription& lesson);

/// A simulated person who may go where nobody planned sees the nearest thing to touch, and looks on until another is nearer by a good deal.
class NearestThing {
  public:
    /// Where it is; nothing where nothing can be touched. `world`: null where all stand as declared.
    [[nodiscard]] std::optional<Vector3> look(const LessonDescription& lesson,
                                              const WorldSnapshot* world, const Vector3& hand_W);

  private:
    std::size_t looked_at_ = kMaxBodies;  // a body by its index; none
};

}  // namespace fulcrum::runtime
