#include "runtime/lua/api/sound_names.h"

#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/text_scanner.h"
#include "runtime/scene/sounds.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kLongestShown_bytes = 40;

}  // namespace

std::vector<SoundUse> find_sounds(std::string_view text) {
    std::vector<SoundUse> uses;
    TextScanner scanner(text);
    while (!scanner.at_end()) {
        if (scanner.pass_comment_or_text()) {
            continue;
        }
        if (!scanner.begins_name() || !scanner.pass("world:sound")) {
            scanner.step();
            continue;
        }
        const int line = scanner.line();
        scanner.pass("(");
        if (auto name = scanner.take_text()) {
            scanner.pass("");  // blanks
            // What is joined to something else is not the whole name.
            if (!scanner.pass("..")) {
                uses.push_back({std::move(*name), line});
            }
        }
    }
    return uses;
}

std::string sound_problem(std::string_view name) {
    if (std::find(kSoundNames.begin(), kSoundNames.end(), name) != kSoundNames.end()) {
        return {};
    }
    std::string known;
    for (const std::string_view each : kSoundNames) {
        known += (known.empty() ? "" : ", ") + std::string(each);
    }
    const std::string near = nearest_word(name, {kSoundNames.begin(), kSoundNames.end()});
    return "there is no sound \"" + std::string(name.substr(0, kLongestShown_bytes)) + "\"; " +
           (near.empty() ? "the sounds are " + known : "did you mean \"" + near + "\"?");
}

}  // namespace fulcrum::runtime
