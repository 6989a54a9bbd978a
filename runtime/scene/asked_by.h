// Which line of a lesson asked for what, 0 where none did; for the plan's stages.
//
// Thread: load path.  Cost: one pass over the bodies.
#pragma once

#include "runtime/scene/description.h"

#include <algorithm>

namespace fulcrum::runtime {

/// Of the first rigid body.
inline SourceLine first_rigid_line(const LessonDescription& lesson) {
    const auto found = std::ranges::find_if(
        lesson.bodies, [](const BodyDescription& body) { return body.rigid.has_value(); });
    return found == lesson.bodies.end() ? 0 : found->line;
}

/// Of the first question, or of the first thing that may be asked for.
inline SourceLine line_of_dialogue(const LessonDescription& lesson) {
    return lesson.questions.empty() ? lesson.knowledge.front().line : lesson.questions.front().line;
}

/// Of the first solid body that is made of something.
inline SourceLine first_material_line(const LessonDescription& lesson) {
    const auto found = std::ranges::find_if(lesson.bodies, [](const BodyDescription& body) {
        return body.solid && body.material != kNoMaterial;
    });
    return found == lesson.bodies.end() ? 0 : found->line;
}

}  // namespace fulcrum::runtime
