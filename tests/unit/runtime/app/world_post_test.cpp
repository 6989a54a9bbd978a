#include "runtime/app/world_post.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// Commands that are told apart by their body.
std::vector<WorldCommand> number_from(int first, int n) {
    std::vector<WorldCommand> commands(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        commands[static_cast<std::size_t>(i)].body = first + i;
    }
    return commands;
}

// Takes all that lie there; false where one is not the next.
bool take(WorldCommandRing& ring, int& next) {
    WorldCommand command;
    bool is_next = true;
    while (ring.pop(command)) {
        is_next = is_next && command.body == next++;
    }
    return is_next;
}

}  // namespace

TEST_CASE("world post: while the world stands what a lesson moves waits, and comes in order") {
    const auto ring = std::make_unique<WorldCommandRing>();
    WorldPost post;
    // Ten seconds of nine bodies that move with each of sixty frames a second, and the world takes none.
    constexpr int kFrames = 600;
    constexpr int kBodies = 9;
    for (int frame = 0; frame < kFrames; ++frame) {
        REQUIRE(post.send(number_from(frame * kBodies, kBodies), *ring));
    }
    CHECK(post.n_waiting() > 5000);
    // It goes on, a frame at a time: nothing was lost, and nothing overtakes.
    int next = 0;
    while (post.n_waiting() > 0) {
        REQUIRE(take(*ring, next));
        REQUIRE(post.send({}, *ring));
    }
    CHECK(take(*ring, next));
    CHECK(next == kFrames * kBodies);
}

TEST_CASE("world post: a world that stands for longer than that ends the lesson, in a sentence") {
    const auto ring = std::make_unique<WorldCommandRing>();
    WorldPost post;
    Expected<void> sent;
    int frames = 0;
    for (; sent && frames < 2000; ++frames) {
        sent = post.send(number_from(0, 9), *ring);
    }
    REQUIRE_FALSE(sent);
    CHECK(frames > 900);
    check_says(to_sentence(sent.error()), {"the world stands still"});
}
