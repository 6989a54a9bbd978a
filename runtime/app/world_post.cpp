#include "runtime/app/world_post.h"

namespace fulcrum::runtime {

Expected<void> WorldPost::send(std::span<const WorldCommand> commands, WorldCommandRing& world) {
    waiting_.insert(waiting_.end(), commands.begin(), commands.end());
    while (!waiting_.empty() && world.push(waiting_.front())) {
        waiting_.pop_front();
    }
    return waiting_.size() <= kMostWaiting
               ? Expected<void>{}
               : Expected<void>(
                     fail("the lesson moves more bodies than the world can take in, or the "
                          "world stands still",
                          {}, "move fewer bodies in one frame, or close other programs"));
}

}  // namespace fulcrum::runtime
