// What every command may need, and how one says that it cannot go on.
#pragma once

#include "dialogue/catalogue.h"
#include "haptics/base/error.h"
#include "runtime/app/places.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// The folders and the words.
struct Installation {
    Places places;
    dialogue::Catalogue catalogue;  ///< English: the lesson's, see home_words.h
    double started_s = 0.0;         ///< when the program began, monotonic clock
};

/// Finds the folders and reads the words.
[[nodiscard]] Expected<Installation> open_installation(double started_s);

/// A sentence for who sits at the terminal; nothing where it is empty.
void say(const std::string& sentence);
void say_all(const std::vector<std::string>& sentences);
/// Says an error in one sentence on the terminal and gives the exit code.
int complain(const Error& error, int exit_code);
/// The same of a lesson that could not be made ready, 1; where Ctrl-C stopped that, nothing is said and the code is the signal's.
int complain_of_loading(const Error& error);

}  // namespace fulcrum::runtime
