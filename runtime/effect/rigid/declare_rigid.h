// What world:body{ rigid = true, … } says of a rigid body, checked.
#pragma once

#include "runtime/lua/api/binding_table.h"
#include "runtime/scene/description.h"

namespace fulcrum::runtime {

/// Takes size, rigid, shape, density and joint over; raises the sentence that says what does not fit. `body` has its other fields.
void take_rigid(lua_State* lua, const LessonContext& context, const Arguments& arguments,
                BodyDescription& body);

}  // namespace fulcrum::runtime
