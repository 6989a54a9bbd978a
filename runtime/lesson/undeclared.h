// The error of a lesson that names what is not there.
#pragma once

#include "haptics/base/error.h"

namespace fulcrum::runtime {

[[nodiscard]] inline tl::unexpected<Error> undeclared() {
    return fail("the lesson named something that it never declared", "lesson.lua",
                "use the bodies, forces and questions that L:start and L:question made");
}

}  // namespace fulcrum::runtime
