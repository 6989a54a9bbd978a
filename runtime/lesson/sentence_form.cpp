#include "runtime/lesson/sentence_form.h"

#include "dialogue/result.h"

#include <algorithm>
#include <string_view>

namespace fulcrum::runtime {
namespace {

/// "is is": a form of grammar brings a word that the template has as well.
std::string doubled_word(std::string_view sentence) {
    std::string_view before;
    while (!sentence.empty()) {
        const std::size_t end = std::min(sentence.find(' '), sentence.size());
        const std::string_view word = sentence.substr(0, end);
        // "A million million tonnes" is a number.
        if (word == before && !word.empty() && word != "that" && word != "had" &&
            word != "million") {
            return std::string(word);
        }
        before = word;
        sentence.remove_prefix(std::min(end + 1, sentence.size()));
    }
    return {};
}

}  // namespace

std::string tell_form(const dialogue::FormCheck& check, const std::string& text) {
    return check ? tell_checked(check(text), text) : std::string();
}

std::string tell_checked(const dialogue::CheckedText& checked, const std::string& text) {
    if (const std::string doubled = doubled_word(text); !doubled.empty()) {
        return "has \"" + doubled + "\" twice; take one out, or the form of grammar that brings it";
    }
    if (checked.errors.empty()) {
        return {};
    }
    if (checked.proven) {
        return dialogue::concat({"is no good English; better is \"", checked.corrected, "\""});
    }
    const dialogue::FreeError& error = checked.errors.front();
    return error.right.empty()
               ? dialogue::concat({"is no good English; take out \"", error.said, "\""})
               : dialogue::concat({"is no good English; write \"", error.right,
                                   error.said.empty() ? "\" too" : "\" for \"" + error.said + '"'});
}

}  // namespace fulcrum::runtime
