#include "dialogue/english/common_words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum::dialogue {
namespace {

struct Ending {
    std::string_view form;
    std::string_view base;
};
constexpr std::array<Ending, 19> kEndings{{{"'s", ""},
                                           {"s", ""},
                                           {"es", ""},
                                           {"ies", "y"},
                                           {"ed", ""},
                                           {"ed", "e"},
                                           {"ied", "y"},
                                           {"ing", ""},
                                           {"ing", "e"},
                                           {"er", ""},
                                           {"er", "e"},
                                           {"ier", "y"},
                                           {"est", ""},
                                           {"est", "e"},
                                           {"iest", "y"},
                                           {"ly", ""},
                                           {"ily", "y"},
                                           {"our", "or"},
                                           {"tre", "ter"}}};

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '\'';
}
char to_small(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

struct WordAt {
    std::string small;
    bool is_name = false;  // a capital letter, and not where a sentence begins
};

std::vector<WordAt> words_of(std::string_view text) {
    std::vector<WordAt> words;
    bool begins = true;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (!is_letter(c)) {
            begins = c == ' ' ? begins : c == '.' || c == '!' || c == '?' || c == ':' || c == '"';
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && is_letter(text[end])) {
            ++end;
        }
        std::string_view whole = text.substr(at, end - at);
        while (!whole.empty() && whole.front() == '\'') {
            whole.remove_prefix(1);
        }
        while (!whole.empty() && whole.back() == '\'') {
            whole.remove_suffix(1);
        }
        if (!whole.empty()) {
            WordAt word{std::string(whole), !begins && whole.front() != to_small(whole.front())};
            std::ranges::transform(word.small, word.small.begin(), to_small);
            words.push_back(std::move(word));
        }
        begins = false;
        at = end;
    }
    return words;
}

}  // namespace

CommonWords::CommonWords(std::string_view list) {
    while (!list.empty()) {
        const std::string_view line = list.substr(0, list.find('\n'));
        list.remove_prefix(std::min(line.size() + 1, list.size()));
        if (!line.empty() && line.front() != '#') {
            words_.emplace(line);
        }
    }
}

void CommonWords::add(std::string_view text) {
    for (WordAt& word : words_of(text)) {
        words_.insert(std::move(word.small));
    }
}

bool CommonWords::has(std::string_view word) const {
    if (word.size() < 2 || words_.contains(word)) {
        return true;
    }
    return std::ranges::any_of(kEndings, [&](const Ending& ending) {
        if (!word.ends_with(ending.form) || word.size() < ending.form.size() + 2) {
            return false;
        }
        std::string base(word.substr(0, word.size() - ending.form.size()));
        base += ending.base;
        if (words_.contains(base)) {
            return true;
        }
        // "bigger", "stopping": the letter is doubled; "metres", "colours": a form of a form.
        const std::size_t n = base.size();
        if (ending.base.empty() && n > 3 && base[n - 1] == base[n - 2]) {
            return words_.contains(std::string_view(base).substr(0, n - 1));
        }
        return ending.form == "s" &&
               ((base.ends_with("our") && words_.contains(base.substr(0, n - 3) + "or")) ||
                (base.ends_with("tre") && words_.contains(base.substr(0, n - 3) + "ter")));
    });
}

std::vector<std::string> CommonWords::rare_words(std::string_view text) const {
    std::vector<std::string> rare;
    for (WordAt& word : words_of(text)) {
        if (!word.is_name && !has(word.small) &&
            std::ranges::find(rare, word.small) == rare.end()) {
            rare.push_back(std::move(word.small));
        }
    }
    return rare;
}

}  // namespace fulcrum::dialogue
