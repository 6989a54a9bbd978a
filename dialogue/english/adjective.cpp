#include "dialogue/english/adjective.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/word_table.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {

/// Forms that no rule makes. Two forms in one field stand apart by '/'.
struct Irregular {
    std::string_view positive, comparative, superlative;
};
constexpr std::array kIrregular = {
    Irregular{"good", "better", "best"},
    Irregular{"well", "better", "best"},
    Irregular{"bad", "worse", "worst"},
    Irregular{"ill", "worse", "worst"},
    Irregular{"far", "farther/further", "farthest/furthest"},
    Irregular{"little", "less/littler", "least/littlest"},
    Irregular{"few", "fewer", "fewest"},
    Irregular{"many", "more", "most"},
    Irregular{"much", "more", "most"},
    Irregular{"old", "older/elder", "oldest/eldest"},
    Irregular{"late", "later", "latest/last"},
    Irregular{"good-looking", "better-looking/more good-looking", "best-looking/most good-looking"},
    Irregular{"well-known", "better-known/more well-known", "best-known/most well-known"},
    Irregular{"shy", "shyer/shier", "shyest/shiest"},
    Irregular{"sly", "slyer/slier", "slyest/sliest"},
    Irregular{"wry", "wrier/wryer", "wriest/wryest"},
    Irregular{"dry", "drier/dryer", "driest/dryest"},
};

/// One or two syllables, yet compared by more and most.
constexpr std::array<std::string_view, 38> kOnlyMore = {
    "fun",     "real",    "right",   "wrong",  "like",    "worth",  "bored",  "scared",
    "pleased", "lost",    "hurt",    "used",   "loved",   "known",  "worn",   "torn",
    "burnt",   "shaped",  "closed",  "wooden", "golden",  "eager",  "proper", "fertile",
    "agile",   "fragile", "hostile", "mobile", "sterile", "docile", "futile", "virile",
    "woollen", "sudden",  "modern",  "famous", "careful", "useful"};

/// Compared in both ways; the ending comes first.
constexpr std::array<std::string_view, 52> kBoth = {
    "quiet",   "clever",   "simple",   "narrow",   "gentle",    "polite",     "common", "stupid",
    "cruel",   "pleasant", "handsome", "friendly", "lively",    "lovely",     "likely", "lonely",
    "deadly",  "costly",   "noble",    "humble",   "feeble",    "subtle",     "tender", "bitter",
    "mellow",  "shallow",  "hollow",   "yellow",   "sincere",   "severe",     "remote", "secure",
    "obscure", "solid",    "mature",   "able",     "ample",     "nimble",     "supple", "slender",
    "sober",   "unhappy",  "unlucky",  "untidy",   "unhealthy", "unfriendly", "purple", "orange",
    "silver",  "strict",   "dense",    "brittle"};

/// Both ways too, but "more" is what one teaches.
constexpr std::array<std::string_view, 7> kBothMoreFirst = {
    "tired", "wicked", "rotten", "crooked", "hateful", "just", "slippery"};

const Irregular* find_irregular(std::string_view adjective) {
    const auto* found =
        std::find_if(kIrregular.begin(), kIrregular.end(),
                     [&](const Irregular& entry) { return entry.positive == adjective; });
    return found == kIrregular.end() ? nullptr : found;
}

std::vector<std::string> split_forms(std::string_view forms) {
    std::vector<std::string> result;
    while (!forms.empty()) {
        const std::size_t bar = std::min(forms.find('/'), forms.size());
        result.emplace_back(forms.substr(0, bar));
        forms.remove_prefix(std::min(bar + 1, forms.size()));
    }
    return result;
}

std::string joined(std::string_view a, std::string_view b) {
    return std::string(a) + " " + std::string(b);
}

/// Vowels that meet at `i` but belong to two syllables: gi-ant, vi-olet, cru-el, qui-et.
bool said_apart(std::string_view word, std::size_t i) {
    const std::string_view pair = word.substr(i - 1, 2);
    const char before = i > 1 ? word[i - 2] : ' ';
    const bool soft = std::string_view("ctsg").find(before) != std::string_view::npos;
    const std::string_view end = word.substr(i - 1);
    return (pair == "ia" && (!soft || i == 2)) || (pair == "io" && !soft && before != 'n') ||
           pair == "uo" || end == "uel" || end == "iet";
}

/// One vowel letter in the whole word, then one consonant letter that can be doubled: big, thin, quit; not cheap, slow, tired.
bool doubles_last_letter(std::string_view word) {
    const std::size_t n = word.size();
    if (n < 3 || !is_vowel_letter(word[n - 2]) || is_vowel_letter(word[n - 1]) ||
        std::string_view("wxy").find(word[n - 1]) != std::string_view::npos) {
        return false;
    }
    for (std::size_t i = 0; i + 2 < n; ++i) {
        const bool mute_u = word[i] == 'u' && i > 0 && word[i - 1] == 'q';
        if ((is_vowel_letter(word[i]) && !mute_u) || (word[i] == 'y' && i > 0)) {
            return false;
        }
    }
    return true;
}

}  // namespace

int syllables(std::string_view word) {
    int count = 0;
    bool in_vowels = false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const bool vowel = is_vowel_letter(word[i]) || (word[i] == 'y' && i > 0);
        const bool mute_u = word[i] == 'u' && i > 0 && word[i - 1] == 'q';
        if (vowel && !mute_u && !in_vowels) {
            ++count;
        }
        count += vowel && in_vowels && said_apart(word, i) ? 1 : 0;
        in_vowels = vowel && !mute_u;
    }
    // A final e is silent, unless it is the only vowel or makes "-le" after a consonant.
    const std::size_t n = word.size();
    if (n > 2 && word[n - 1] == 'e' && !is_vowel_letter(word[n - 2]) && count > 1 &&
        !(word[n - 2] == 'l' && !is_vowel_letter(word[n - 3]))) {
        --count;
    }
    // "-ed" is a syllable after t and d only.
    if (n > 3 && word.substr(n - 2) == "ed" && word[n - 3] != 't' && word[n - 3] != 'd' &&
        count > 1 && !is_vowel_letter(word[n - 3])) {
        --count;
    }
    return std::max(count, 1);
}

std::string with_ending(std::string_view adjective, std::string_view ending) {
    std::string stem(adjective);
    const std::size_t n = stem.size();
    if (n == 0) {
        return stem;
    }
    if (stem.back() == 'e') {
        stem.pop_back();  // large -> larg + er
    } else if (n > 1 && stem.back() == 'y' && !is_vowel_letter(stem[n - 2])) {
        stem.back() = 'i';  // heavy -> heavi + er
    } else if (doubles_last_letter(adjective)) {
        stem.push_back(stem.back());  // big -> bigg + er
    }
    return stem + std::string(ending);
}

Comparison comparison_of(std::string_view adjective) {
    if (find_irregular(adjective) != nullptr) {
        return Comparison::irregular;
    }
    if (contains(kOnlyMore, adjective) || adjective.find_first_of(" -") != std::string_view::npos) {
        return Comparison::more_most;
    }
    if (contains(kBoth, adjective) || contains(kBothMoreFirst, adjective)) {
        return Comparison::both;
    }
    const int count = syllables(adjective);
    const bool in_y = adjective.size() > 2 && adjective.back() == 'y' &&
                      !is_vowel_letter(adjective[adjective.size() - 2]);
    const bool ending = count == 1 || (count == 2 && in_y);
    return ending ? Comparison::ending : Comparison::more_most;
}

std::vector<std::string> degree_forms(std::string_view adjective, Degree degree) {
    if (adjective.empty() || degree == Degree::positive) {
        return {std::string(adjective)};
    }
    const bool comparative = degree == Degree::comparative;
    const std::string inflected = with_ending(adjective, comparative ? "er" : "est");
    const std::string phrase = joined(comparative ? "more" : "most", adjective);
    if (const Irregular* entry = find_irregular(adjective)) {
        return split_forms(comparative ? entry->comparative : entry->superlative);
    }
    const Comparison comparison = comparison_of(adjective);
    if (comparison != Comparison::both) {
        return {comparison == Comparison::ending ? inflected : phrase};
    }
    if (contains(kBothMoreFirst, adjective)) {
        return {phrase, inflected};
    }
    return {inflected, phrase};
}

}  // namespace fulcrum::dialogue
