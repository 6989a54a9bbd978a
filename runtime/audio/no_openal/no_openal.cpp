// What stands for openal/ in a build without FULCRUM_SOUND.
#include "runtime/audio/openal/openal_microphone.h"
#include "runtime/audio/openal/openal_player.h"

namespace fulcrum::runtime {

Expected<std::unique_ptr<SoundPlayer>> open_openal_device(const SoundSettings& /*settings*/) {
    return fail("this build has no sound", {},
                "build with -DFULCRUM_SOUND=ON, or go on without sound (--mute)");
}

OpenMicrophone microphone_opener() {
    return []() -> Expected<std::unique_ptr<Microphone>> {
        return fail("this build has no microphone", {}, "build with -DFULCRUM_SOUND=ON, or type");
    };
}

}  // namespace fulcrum::runtime
