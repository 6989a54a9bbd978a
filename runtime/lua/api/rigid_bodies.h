// What world:body{ rigid = true, … } says of a rigid body, checked.
#pragma once

#include "runtime/lua/api/binding_table.h"
#include "runtime/scene/description.h"

#include <span>

namespace fulcrum::runtime {

/// The fields of joint = { … }.
[[nodiscard]] std::span<const Parameter> joint_parameters();
/// What is made of a body's felt and simulated models.
[[nodiscard]] const Parameter& felt_shape_parameter();
[[nodiscard]] const Parameter& shape_parameter();

/// Takes size, rigid, shape, density and joint over; raises the sentence that says what does not fit. `body` has its other fields.
void take_rigid(lua_State* lua, const LessonContext& context, const Arguments& arguments,
                BodyDescription& body);

}  // namespace fulcrum::runtime
