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

/// Passes ask's arguments, up to the bracket that closes them: perhaps a world, a name, perhaps options.
AskUse take_arguments(TextScanner& scanner) {
    AskUse use;
    if (scanner.pass("world")) {
        scanner.pass(",");
    }
    int depth = 1;
    bool behind_name = false;
    while (!scanner.at_end() && depth > 0) {
        if (auto text = scanner.take_text()) {
            scanner.pass("");  // blanks
            const bool is_whole = depth == 1 && !behind_name && !scanner.pass("..");
            if (is_whole) {
                use.name = std::move(*text);
            }
            continue;
        }
        if (scanner.pass_comment_or_text()) {
            continue;
        }
        const bool named = scanner.begins_name() && scanner.is_letter();
        if (depth == 2 && named && (scanner.pass("hint") || scanner.pass("again"))) {
            use.has_hint = scanner.pass("=") || use.has_hint;
            continue;
        }
        // A name behind the question's: options that were made elsewhere.
        use.has_hint = use.has_hint || (depth == 1 && named && behind_name);
        behind_name = behind_name || (depth == 1 && scanner.here() == ',');
        depth += depth_of(scanner.here());
        scanner.step();
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
