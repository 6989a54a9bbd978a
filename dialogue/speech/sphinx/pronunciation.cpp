#include "dialogue/speech/sphinx/pronunciation.h"

#include "dialogue/english/letters.h"

#include <algorithm>
#include <array>
#include <vector>

namespace fulcrum::dialogue {
namespace {

template <std::size_t N>
bool is_one_of(std::string_view sound, const std::array<std::string_view, N>& sounds) {
    return std::ranges::find(sounds, sound) != sounds.end();
}

std::string_view last_sound(std::string_view sounds) {
    const std::size_t space = sounds.rfind(' ');
    return space == std::string_view::npos ? sounds : sounds.substr(space + 1);
}

constexpr std::array<std::string_view, 9> kVoiceless{"P",  "T",  "K", "F", "TH",
                                                     "CH", "SH", "S", "HH"};
constexpr std::array<std::string_view, 6> kHissing{"S", "Z", "SH", "ZH", "CH", "JH"};

std::string sound_of_s(std::string_view before) {
    if (is_one_of(last_sound(before), kHissing)) {
        return "IH Z";
    }
    return is_one_of(last_sound(before), kVoiceless) ? "S" : "Z";
}

std::string sound_of_ed(std::string_view before) {
    const std::string_view last = last_sound(before);
    if (last == "T" || last == "D") {
        return "IH D";
    }
    return is_one_of(last, kVoiceless) ? "T" : "D";
}

struct Ending {
    std::string_view letters;
    std::string (*sound)(std::string_view before);
};

// The longer first.
constexpr std::array<Ending, 8> kEndings{{
    {"ness", [](std::string_view) { return std::string("N AH S"); }},
    {"est", [](std::string_view) { return std::string("AH S T"); }},
    {"er", [](std::string_view) { return std::string("ER"); }},
    {"ly", [](std::string_view) { return std::string("L IY"); }},
    {"ed", sound_of_ed},
    {"es", sound_of_s},
    {"'s", sound_of_s},
    {"s", sound_of_s},
}};

// What the word may have been before its ending.
std::vector<std::string> words_before(std::string_view stem) {
    std::vector<std::string> words{std::string(stem), std::string(stem) + "e"};
    const std::size_t n = stem.size();
    if (n >= 3 && stem[n - 1] == stem[n - 2] && !is_vowel_letter(stem[n - 1])) {
        words.emplace_back(stem.substr(0, n - 1));
    }
    if (n >= 2 && stem[n - 1] == 'i') {
        words.push_back(std::string(stem.substr(0, n - 1)) + "y");
    }
    return words;
}

}  // namespace

std::optional<std::string> pronounce(std::string_view word, const LookUp& look_up) {
    if (auto known = look_up(word)) {
        return known;
    }
    for (const Ending& ending : kEndings) {
        constexpr std::size_t kShortest = 2;
        if (!word.ends_with(ending.letters) || word.size() < ending.letters.size() + kShortest) {
            continue;
        }
        for (const std::string& before :
             words_before(word.substr(0, word.size() - ending.letters.size()))) {
            if (const auto sounds = look_up(before)) {
                return *sounds + " " + ending.sound(*sounds);
            }
        }
    }
    return {};
}

}  // namespace fulcrum::dialogue
