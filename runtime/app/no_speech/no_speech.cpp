// What stands for speech/ in a build without FULCRUM_SPEECH.
#include "runtime/app/speech/speech_parts.h"

namespace fulcrum::runtime {

std::optional<Error> why_no_sphinx() {
    return Error{"this build has nobody who hears",
                 {},
                 "build with -DFULCRUM_SPEECH=ON, give --speech exec:COMMAND, or type"};
}

std::optional<Error> why_no_voice() {
    return Error{"this build has no voice",
                 {},
                 "build with -DFULCRUM_SPEECH=ON, or read what stands there (--voice none)"};
}

}  // namespace fulcrum::runtime
