// The questions that a lesson's text asks, and whether a hint goes with them: game.ask("heavier", { hint = … }).
//
// Thread: pure functions.  Cost: linear in the text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// A call that asks a question.
struct AskUse {
    std::string name;       ///< empty where it is computed
    bool has_hint = false;  ///< it is given `hint` or `again`, or options that are made elsewhere
};

/// Each game.ask(…), story.ask(world, …) and world:ask(…) of a Lua text, in order; not those in comments and texts. What else
/// is called `ask` is taken for one of them, by any name of its module.
[[nodiscard]] std::vector<AskUse> find_asked(std::string_view text);

}  // namespace fulcrum::runtime
