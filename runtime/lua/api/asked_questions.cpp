#include "runtime/lua/api/asked_questions.h"

#include "runtime/lua/api/text_scanner.h"

#include <utility>

namespace fulcrum::runtime {
namespace {

/// How many brackets `passed` opens (1), closes (-1), or neither.
int depth_of(char passed) {
    return passed == '(' || passed == '{' || passed == '['   ? 1
           : passed == ')' || passed == '}' || passed == ']' ? -1
                                                             : 0;
}

bool begins_word(const TextScanner& scanner) {
    return scanner.begins_name() && scanner.is_letter();
}

/// Passes the name of an option that helps, and what gives it its value.
bool pass_help(TextScanner& scanner, AskUse& use) {
    if (!begins_word(scanner) || !(scanner.pass("hint") || scanner.pass("again"))) {
        return false;
    }
    use.has_hint = scanner.pass("=") || use.has_hint;
    return true;
}

/// Passes ask's arguments, up to the bracket that closes them: perhaps a world, a name, perhaps options.
AskUse take_arguments(TextScanner& scanner) {
    AskUse use;
    if (scanner.pass("world")) {
        scanner.pass(",");
    }
    bool behind_name = false;
    for (int depth = 1; !scanner.at_end() && depth > 0;) {
        if (auto text = scanner.take_text()) {
            scanner.pass("");  // blanks
            const bool is_whole = depth == 1 && !behind_name && !scanner.pass("..");
            use.name = is_whole ? std::move(*text) : use.name;
        } else if (!scanner.pass_comment_or_text() && !(depth == 2 && pass_help(scanner, use))) {
            // A name behind the question's: options that were made elsewhere.
            const bool is_options = depth == 1 && behind_name && begins_word(scanner);
            use.has_hint = use.has_hint || is_options;
            behind_name = behind_name || (depth == 1 && scanner.here() == ',');
            depth += depth_of(scanner.here());
            scanner.step();
        }
    }
    return use;
}

}  // namespace

std::vector<AskUse> find_asked(std::string_view text) {
    std::vector<AskUse> uses;
    TextScanner scanner(text);
    while (!scanner.at_end()) {
        if (scanner.pass_comment_or_text()) {
            continue;
        }
        if (!scanner.begins_name() || !scanner.pass("ask")) {
            scanner.step();
            continue;
        }
        if (auto name = scanner.take_text()) {
            uses.push_back({std::move(*name), false});
        } else if (scanner.pass("(")) {
            uses.push_back(take_arguments(scanner));
        }
    }
    return uses;
}

}  // namespace fulcrum::runtime
