#include "runtime/lua/api/written_texts.h"

#include "runtime/lua/api/text_scanner.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum::runtime {
namespace {

/// The names behind which stands what a learner reads.
bool is_for_learner(std::string_view name) {
    constexpr std::array<std::string_view, 4> kShown = {"caption", "hint", "solution", "about"};
    return std::ranges::find(kShown, name) != kShown.end();
}

bool is_name_part(const TextScanner& scanner) {
    return !scanner.at_end() &&
           (scanner.is_letter() || (scanner.here() >= '0' && scanner.here() <= '9'));
}

/// What stands between a name and its value.
bool joins(char here) {
    return std::string_view(" \t\n(=").find(here) != std::string_view::npos;
}

}  // namespace

std::vector<WrittenText> find_texts(std::string_view lua) {
    std::vector<WrittenText> texts;
    TextScanner scanner(lua);
    std::string name;  // before what comes next
    while (!scanner.at_end()) {
        const int line = scanner.line();
        if (auto text = scanner.take_text()) {
            scanner.pass("");  // blanks
            const bool is_whole =
                !scanner.pass("..") && (scanner.at_end() || scanner.here() != ':');
            texts.push_back({std::move(*text), line, is_whole && is_for_learner(name)});
            name.clear();
        } else if (scanner.pass_comment_or_text()) {
            name.clear();
        } else if (scanner.is_letter() && scanner.begins_name()) {
            name.clear();
            for (; is_name_part(scanner); scanner.step()) {
                name += scanner.here();
            }
        } else {
            if (!joins(scanner.here())) {
                name.clear();
            }
            scanner.step();
        }
    }
    return texts;
}

}  // namespace fulcrum::runtime
