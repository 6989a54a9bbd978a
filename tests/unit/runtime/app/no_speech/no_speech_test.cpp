#include "runtime/app/speech/speech_parts.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE(
    "no speech: who asks for a voice or to be heard gets one sentence that names the option") {
    CHECK(to_sentence(value_of(why_no_sphinx())) ==
          "this build has nobody who hears; build with -DFULCRUM_SPEECH=ON, give --speech "
          "exec:COMMAND, or type.");
    CHECK(to_sentence(value_of(why_no_voice())) ==
          "this build has no voice; build with -DFULCRUM_SPEECH=ON, or read what stands there "
          "(--voice none).");
}
