#include "haptics/loop/scene_solids.h"

namespace fulcrum {

bool SceneSolids::step(const WorldFrame* told, double now_s) noexcept {
    poses_W_ = {};
    if (!places_.step(told)) {
        return false;
    }
    poses_W_ = axles ? axles->turn(places_.poses_W()) : places_.poses_W();
    put_ = places_.put() | (axles ? axles->put() : 0);
    if (bodies) {
        poses_W_ = bodies->place(poses_W_, now_s);
        put_ |= bodies->put();
    }
    return true;
}

}  // namespace fulcrum
