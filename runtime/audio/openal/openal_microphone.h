// A microphone through OpenAL: the one that the system calls its default. No OpenAL header is needed to use this one.
//
// One that gives nothing for kPatience_s, or says that it has gone, is an error; then it is to be opened anew.
//
// Thread: one, the opener's; what stands above `microphone_opener` for itself.
#pragma once

#include "runtime/audio/microphone.h"

namespace fulcrum::runtime {

/// Opens it, on any thread; to be made on the thread that starts the others, before it does so.
[[nodiscard]] OpenMicrophone microphone_opener();

}  // namespace fulcrum::runtime
