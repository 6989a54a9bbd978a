#include "runtime/lua/sandbox/plain_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr std::string_view kTooDeep =
    "this calls itself too deeply (a function that never stops calling itself?)";

/// The word between `before` and the next ' or blank of `message`; empty when it isn't there.
std::string_view word_behind(std::string_view message, std::string_view before) {
    const std::size_t at = message.find(before);
    if (at == std::string_view::npos) {
        return {};
    }
    const std::string_view rest = message.substr(at + before.size());
    return rest.substr(0, rest.find_first_of("')"));
}

/// "'end' expected (to close 'function' at line 26) near <eof>".
std::string close_what(std::string_view message) {
    const std::string_view opened = word_behind(message, "(to close '");
    const std::string_view line = word_behind(message, "' at line ");
    const std::string_view closes = message.substr(1, message.find('\'', 1) - 1);
    return "write the " + std::string(closes) + " that belongs to the " + std::string(opened) +
           " of line " + std::string(line);
}

/// "attempt to index a nil value (local 'apple')", and the like of fields, functions and texts.
std::string advice_for_nil(std::string_view message) {
    if (const std::string_view name = word_behind(message, "(method '"); !name.empty()) {
        return "there is no function " + std::string(name) +
               " here; is it spelt right, and is the function around it written with a colon, as "
               "function L:start(world)?";
    }
    for (const std::string_view kind :
         {"(local '", "(field '", "(upvalue '", "(global '", "(constant '"}) {
        if (const std::string_view name = word_behind(message, kind); !name.empty()) {
            if (name == "?") {
                return "the table has nothing under the name that is looked for";
            }
            // What an answer leaves out is the usual one: answer.bodies.other.weight.
            const bool is_read = message.starts_with("attempt to index");
            const std::string asked = (kind == "(field '" ? "…." : "") + std::string(name);
            return std::string(name) + " has no value here" +
                   (is_read ? "; where it may be left out, ask first: if " + asked + " then … end"
                            : "");
        }
    }
    return {};
}

/// Part of a message of Lua's, and what helps.
struct Advice {
    std::string_view part, advice;
};
constexpr std::array kAdvice = {
    Advice{"near '<\\", "only plain signs belong there; write straight quotation marks, \"…\""},
    Advice{"near '!'", "\"is not\" is written ~="},
    Advice{"'end' expected (to close 'function' at line",
           "write the end of that function before this, or == where two values are compared"},
    Advice{"'(' expected near",
           "a function with a name stands outside all braces; is a } missing before it?"},
    Advice{"unexpected symbol near 'local'", "is a } missing before it?"},
    Advice{"unexpected symbol near 'return'", "is a } missing before it?"},
    Advice{"' expected near '='", "two values are compared with =="},
    Advice{"malformed number", "write a number without its unit, and with a point: 0.5"},
    Advice{"unfinished string",
           "a text ends on its own line, with the quotation mark that it began with"},
    Advice{"<eof> expected near 'end'", "take out this end, or one before it"},
    Advice{"'}' expected", "put a comma between two fields"},
    Advice{"')' expected", "put a comma between two values, and a ) behind the last"},
    Advice{"'then' expected", "write if … then"},
    Advice{"'do' expected", "write for … do, while … do"},
    Advice{"'=' expected", "write name = value, or name(…)"},
    Advice{"syntax error near", "look at the end of the line before, too"},
    Advice{"for iterator", "write for i, thing in ipairs(…), or for name, thing in pairs(…)"},
    Advice{"attempt to compare", "only two numbers can be compared, or two texts"},
};

/// Where a word that only begins a statement is met, a brace was left open before it: no field begins so.
bool begins_statement(std::string_view message) {
    constexpr std::array<std::string_view, 6> kWords = {"near 'local'", "near 'return'",
                                                        "near 'if'",    "near 'for'",
                                                        "near 'while'", "near 'function'"};
    return std::ranges::any_of(kWords,
                               [&](std::string_view word) { return message.ends_with(word); });
}

std::string advice_for(std::string_view message) {
    // Where the end of the file or another end is met, what is open is the mistake; else it is more likely a comma.
    const bool unclosed = message.find("(to close '") != std::string_view::npos &&
                          (message.ends_with("near <eof>") || message.ends_with("near 'end'") ||
                           (message.starts_with("'}'") && begins_statement(message)));
    if (unclosed) {
        return close_what(message);
    }
    for (const Advice& known : kAdvice) {
        if (message.find(known.part) != std::string_view::npos) {
            return std::string(known.advice);
        }
    }
    return message.find(" a nil value (") != std::string_view::npos ? advice_for_nil(message)
                                                                    : std::string{};
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r"), text.size());
    text.remove_prefix(begin);
    return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(trimmed(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// L:question "float", L:test, world:body and their like, with nothing behind.
bool is_call_of_table(std::string_view line) {
    constexpr std::array<std::string_view, 8> kWithTable = {"body", "test", "lesson", "material",
                                                            "hand", "kite", "bucket", "joint"};
    const bool is_named = line.ends_with('"') || line.ends_with('\'');
    if (is_named) {
        const std::size_t quote = line.rfind(line.back(), line.size() - 2);
        line = quote == std::string_view::npos ? "" : trimmed(line.substr(0, quote));
    }
    const std::size_t name = line.find_last_of(":. =") + 1;  // 0 where there is none
    const std::string_view called = line.substr(name);
    return is_named ? called == "question" || called == "knows"
                    : (called == "lesson" || (name > 0 && line[name - 1] == ':')) &&
                          std::ranges::find(kWithTable, called) != kWithTable.end();
}

/// "prompt = …": a field, or so it is meant.
bool is_field(std::string_view line) {
    const std::size_t equals = line.find('=');
    const std::string_view name =
        equals == std::string_view::npos ? "" : trimmed(line.substr(0, equals));
    return !name.empty() && !line.substr(equals).starts_with("==") &&
           std::ranges::all_of(name, [](char c) {
               return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
           });
}

}  // namespace

std::optional<MissingBrace> find_missing_brace(std::string_view text, int line) {
    const std::vector<std::string_view> lines = lines_of(text);
    std::string_view below;  // the next line that has anything
    for (std::size_t i = std::min(static_cast<std::size_t>(std::max(line, 0)), lines.size()); i > 0;
         --i) {
        const std::string_view here = lines[i - 1];
        if (is_call_of_table(here)) {
            return is_field(below)
                       ? std::optional(MissingBrace{static_cast<int>(i), std::string(here)})
                       : std::nullopt;
        }
        below = here.empty() ? below : here;
    }
    return std::nullopt;
}

std::string in_plain_words(std::string message) {
    if (message.find("stack overflow") != std::string::npos) {
        return std::string(kTooDeep);
    }
    if (const std::string advice = advice_for(message); !advice.empty()) {
        message += "; " + advice;
    }
    return message;
}

}  // namespace fulcrum::runtime
