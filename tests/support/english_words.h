// The program's own catalogue, read from the source tree.
#pragma once

#include "dialogue/catalogue.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace fulcrum::dialogue {

/// assets/words/en.txt.
inline Catalogue english_words() {
    std::ifstream file(FULCRUM_SOURCE_DIR "/assets/words/en.txt");
    std::stringstream text;
    text << file.rdbuf();
    auto catalogue = Catalogue::parse(text.str());
    if (!file || !catalogue) {
        throw std::runtime_error("assets/words/en.txt can't be read: " +
                                 (catalogue ? "" : catalogue.error().message));
    }
    return std::move(*catalogue);
}

}  // namespace fulcrum::dialogue
