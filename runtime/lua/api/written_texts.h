// The texts that a lesson's files have, each with its line; of some it is plain that the learner reads them.
//
//   world:caption "Lift it."    hint = "Is it hard?"    solution = "It is hard."    about = "This is a bowl."
//
// Thread: pure functions.  Cost: linear in the text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

struct WrittenText {
    std::string text;
    int line = 1;
    bool is_shown =
        false;  ///< it is the whole of a caption, a hint, a solution or what is said about a thing
};

/// Each text between quotes of a Lua file, in order; none of those in comments or long brackets.
[[nodiscard]] std::vector<WrittenText> find_texts(std::string_view lua);

}  // namespace fulcrum::runtime
