#include "runtime/app/speech/speech_parts.h"

namespace fulcrum::runtime {

std::optional<Error> why_no_sphinx() {
    return std::nullopt;
}

std::optional<Error> why_no_voice() {
    return std::nullopt;
}

}  // namespace fulcrum::runtime
