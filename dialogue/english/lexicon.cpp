#include "dialogue/english/lexicon.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr std::array<std::string_view, 4> kFileEndings = {"noun", "verb", "adj", "adv"};
constexpr std::string_view kPackage = "wordnet-base";

std::size_t index_of(WordKind kind) {
    return static_cast<std::size_t>(kind);
}

/// An ending that goes and what comes instead of it.
struct Detachment {
    std::string_view ending, instead;
};
constexpr std::array kOfNouns = {Detachment{"s", ""},      Detachment{"ses", "s"},
                                 Detachment{"xes", "x"},   Detachment{"zes", "z"},
                                 Detachment{"ches", "ch"}, Detachment{"shes", "sh"},
                                 Detachment{"men", "man"}, Detachment{"ies", "y"}};
constexpr std::array kOfVerbs = {
    Detachment{"s", ""},   Detachment{"ies", "y"}, Detachment{"es", "e"},  Detachment{"es", ""},
    Detachment{"ed", "e"}, Detachment{"ed", ""},   Detachment{"ing", "e"}, Detachment{"ing", ""}};
constexpr std::array kOfAdjectives = {Detachment{"er", ""},   Detachment{"est", ""},
                                      Detachment{"er", "e"},  Detachment{"est", "e"},
                                      Detachment{"ier", "y"}, Detachment{"iest", "y"}};

std::span<const Detachment> detachments(WordKind kind) {
    switch (kind) {
        case WordKind::noun:
            return kOfNouns;
        case WordKind::verb:
            return kOfVerbs;
        case WordKind::adjective:
            return kOfAdjectives;
        case WordKind::adverb:
            break;
    }
    return {};
}

/// The words of one line, apart by spaces.
std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    while (!line.empty()) {
        const std::size_t end = std::min(line.find(' '), line.size());
        if (end > 0) {
            fields.push_back(line.substr(0, end));
        }
        line.remove_prefix(std::min(end + 1, line.size()));
    }
    return fields;
}

template <class Use>
void each_line(std::string_view text, const Use& use) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        use(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

/// Is this line of counts of `kind`? "heavy%3:00:01:: 1 32": 1 noun, 2 verb, 3 and 5 adjective, 4 adverb.
bool is_count_of(std::string_view rest, WordKind kind) {
    const char type = rest.empty() ? ' ' : rest[0];
    switch (kind) {
        case WordKind::noun:
            return type == '1';
        case WordKind::verb:
            return type == '2';
        case WordKind::adjective:
            return type == '3' || type == '5';
        case WordKind::adverb:
            break;
    }
    return type == '4';
}

}  // namespace

Lexicon::Lexicon(std::vector<SortedLines> indexes, std::vector<SortedLines> exceptions,
                 SortedLines counts)
    : indexes_(std::move(indexes)), exceptions_(std::move(exceptions)), counts_(std::move(counts)) {
    each_line(exceptions_[index_of(WordKind::noun)].text(), [&](std::string_view line) {
        const std::vector<std::string_view> fields = fields_of(line);
        for (std::size_t i = 1; i < fields.size(); ++i) {
            plurals_.emplace(fields[i], fields[0]);
        }
    });
}

Expected<Lexicon> Lexicon::open(std::string_view folder) {
    const std::string path = std::string(folder) + "/";
    std::vector<SortedLines> indexes;
    std::vector<SortedLines> exceptions;
    for (const std::string_view ending : kFileEndings) {
        auto index = SortedLines::open(concat({path, "index.", ending}), kPackage);
        if (!index) {
            return tl::unexpected<Error>(index.error());
        }
        auto list = SortedLines::open(concat({path, ending, ".exc"}), kPackage);
        if (!list) {
            return tl::unexpected<Error>(list.error());
        }
        indexes.push_back(std::move(*index));
        exceptions.push_back(std::move(*list));
    }
    auto counts = SortedLines::open(path + "cntlist.rev", kPackage);
    if (!counts) {
        return tl::unexpected<Error>(counts.error());
    }
    return Lexicon(std::move(indexes), std::move(exceptions), std::move(*counts));
}

bool Lexicon::has(std::string_view word, WordKind kind) const {
    return !word.empty() && word.front() != ' ' &&
           !indexes_[index_of(kind)].starting_with(std::string(word) + " ").empty();
}

int Lexicon::count(std::string_view word, WordKind kind) const {
    if (word.empty()) {
        return 0;
    }
    int sum = 0;
    const std::string key = std::string(word) + "%";
    each_line(counts_.starting_with(key), [&](std::string_view line) {
        const std::vector<std::string_view> fields = fields_of(line);
        if (fields.size() == 3 && is_count_of(line.substr(key.size()), kind)) {
            int times = 0;
            std::from_chars(fields[2].data(), fields[2].data() + fields[2].size(), times);
            sum += times;
        }
    });
    return sum;
}

std::vector<std::string> Lexicon::bases(std::string_view word, WordKind kind) const {
    std::vector<std::string> result;
    const auto add = [&](std::string base) {
        if (base != word && std::find(result.begin(), result.end(), base) == result.end()) {
            result.push_back(std::move(base));
        }
    };
    if (word.empty() || word.front() == ' ') {
        return result;
    }
    each_line(exceptions_[index_of(kind)].starting_with(std::string(word) + " "),
              [&](std::string_view line) {
                  const std::vector<std::string_view> fields = fields_of(line);
                  for (std::size_t i = 1; i < fields.size(); ++i) {
                      add(std::string(fields[i]));
                  }
              });
    if (!result.empty()) {
        return result;
    }
    for (const Detachment& rule : detachments(kind)) {
        const bool fits = word.size() > rule.ending.size() + 1 && word.ends_with(rule.ending) &&
                          !(rule.ending == "s" && word.ends_with("ss"));
        if (fits) {
            std::string base(word.substr(0, word.size() - rule.ending.size()));
            base += rule.instead;
            if (has(base, kind)) {
                add(std::move(base));
            }
        }
    }
    return result;
}

std::vector<std::string> Lexicon::irregular_plurals(std::string_view noun) const {
    std::vector<std::string> result;
    const auto range = plurals_.equal_range(noun);
    for (auto entry = range.first; entry != range.second; ++entry) {
        result.push_back(entry->second);
    }
    return result;
}

}  // namespace fulcrum::dialogue
