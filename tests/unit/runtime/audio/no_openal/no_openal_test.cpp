#include "runtime/audio/openal/openal_microphone.h"
#include "runtime/audio/openal/openal_player.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE(
    "no sound: what asks for a card or a microphone gets one sentence that names the option") {
    CHECK(refusal_of(open_openal_device({})) ==
          "this build has no sound; build with -DFULCRUM_SOUND=ON, or go on without sound "
          "(--mute).");
    const OpenMicrophone open = microphone_opener();
    for (int i = 0; i < 2; ++i) {
        CHECK(refusal_of(open()) ==
              "this build has no microphone; build with -DFULCRUM_SOUND=ON, or type.");
    }
}
