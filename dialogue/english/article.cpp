// a or an: by the sound that the next word begins with.
#include "dialogue/english/letters.h"
#include "dialogue/english/noun.h"
#include "dialogue/english/word_table.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {

/// Begin with a vowel letter but the sound of y or w: a uniform, a European, a one-way street.
constexpr std::array<std::string_view, 18> kConsonantSound = {
    "uni",  "use",   "usa", "usu",  "usi", "eu",   "ewe",  "ewer",   "once",
    "ubiq", "ukule", "ufo", "uran", "uri", "uter", "uten", "utilit", "utop"};
/// Words that begin so, yet with a vowel sound: an unidentified object, an unimportant one.
constexpr std::array<std::string_view, 6> kButVowel = {"unin",  "unim", "unid",
                                                       "uninv", "unig", "usher"};
/// Silent h.
constexpr std::array<std::string_view, 4> kSilentH = {"hour", "honest", "honor", "honour"};
constexpr std::array<std::string_view, 4> kHeirs = {"heir", "heirs", "heiress", "heirloom"};
/// Both are heard.
constexpr std::array<std::string_view, 6> kBothArticles = {"herb",       "herbal",    "historic",
                                                           "historical", "historian", "hotel"};
/// Letters whose name begins with a vowel: eff, aitch, el, em, en, ar, ess, ex.
constexpr std::string_view kVowelNames = "AEFHILMNORSX";
/// Initials that are said as a word.
constexpr std::array<std::string_view, 8> kSaidAsWord = {"NASA",  "NATO",  "LEGO", "LASER",
                                                         "RADAR", "SONAR", "SIM",  "RAM"};

std::string_view first_word(std::string_view phrase) {
    return phrase.substr(0, std::min(phrase.find(' '), phrase.size()));
}

template <class Table>
bool starts_with_any(const Table& table, std::string_view word) {
    return std::any_of(table.begin(), table.end(), [&](std::string_view start) {
        return word.substr(0, start.size()) == start;
    });
}

/// Eight, eleven, eighteen and their thousands begin with a vowel sound.
bool number_has_vowel_sound(std::string_view digits) {
    const std::size_t n = std::min(digits.find_first_not_of("0123456789"), digits.size());
    const std::string_view two = digits.substr(0, 2);
    return digits[0] == '8' || ((two == "11" || two == "18") && n % 3 == 2);
}

/// Spoken letter by letter: SUV, X-ray, MRI, a lone S.
bool is_initials(std::string_view word) {
    const std::string_view head = word.substr(0, std::min(word.find('-'), word.size()));
    const bool capitals = !head.empty() && std::all_of(head.begin(), head.end(), [](char letter) {
        return letter >= 'A' && letter <= 'Z';
    });
    return capitals && !contains(kSaidAsWord, head);
}

}  // namespace

std::string_view indefinite_article(std::string_view phrase) {
    const std::string_view first = first_word(phrase);
    if (first.empty()) {
        return {};
    }
    if (first[0] >= '0' && first[0] <= '9') {
        return number_has_vowel_sound(first) ? "an" : "a";
    }
    if (is_initials(first)) {
        return kVowelNames.find(first[0]) != std::string_view::npos ? "an" : "a";
    }
    const std::string word = lower_case(first);
    if (word == "one" || word.substr(0, 4) == "one-" || word == "u" || word.substr(0, 2) == "u-") {
        return "a";
    }
    if (word == "x-ray" || word == "x-rays") {
        return "an";
    }
    if (starts_with_any(kSilentH, word) || contains(kHeirs, word)) {
        return "an";
    }
    if (starts_with_any(kConsonantSound, word) && !starts_with_any(kButVowel, word)) {
        return "a";
    }
    return is_vowel_letter(word[0]) ? "an" : "a";
}

bool both_articles(std::string_view phrase) {
    return contains(kBothArticles, lower_case(first_word(phrase)));
}

}  // namespace fulcrum::dialogue
