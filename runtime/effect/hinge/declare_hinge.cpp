#include "runtime/effect/hinge/declare_hinge.h"

#include "haptics/math/length.h"
#include "runtime/lua/api/lesson_context.h"

#include <sstream>

namespace fulcrum::runtime {

Vector3 place_on_hinge(lua_State* lua, const BodyDescription& body, const char* what,
                       const Vector3& place_W) {
    const Vector3 place_B = place_W - body.position_W;
    if (!(compute_length(place_B) <= kFarthestOnAxle_m)) {
        std::ostringstream problem;
        problem << "the " << what << " of " << body.name << " is farther than " << kFarthestOnAxle_m
                << " m from it; give a place nearer to where " << body.name << " is declared";
        raise_in_lesson(lua, problem.str());
    }
    return place_B;
}

}  // namespace fulcrum::runtime
