#include "haptics/base/error.h"

namespace fulcrum {

std::string to_sentence(const Error& error) {
    std::string sentence;
    if (!error.where.empty()) {
        sentence += error.where + ": ";
    }
    sentence += error.message;
    if (!error.what_to_do.empty()) {
        sentence += "; " + error.what_to_do;
    }
    // A question such as "did you mean …?" ends by itself.
    if (!sentence.ends_with('?') && !sentence.ends_with('!') && !sentence.ends_with('.')) {
        sentence += '.';
    }
    return sentence;
}

}  // namespace fulcrum
