// The sounds that a lesson's text asks for: found before the lesson plays, so that a misspelt one is told at once.
//
// Thread: pure functions. Cost: linear in the text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// A sound named in a text.
struct SoundUse {
    std::string name;
    int line = 1;
};

/// Each world:sound "x" or world:sound("x") of a Lua text, in order; not those in comments and texts, nor a name that is
/// computed.
[[nodiscard]] std::vector<SoundUse> find_sounds(std::string_view text);

/// What is wrong with the name of a sound, and which was meant; empty when there is such a sound.
[[nodiscard]] std::string sound_problem(std::string_view name);

}  // namespace fulcrum::runtime
