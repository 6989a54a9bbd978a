#include "dialogue/english/number.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {
constexpr std::array<std::string_view, 20> kSmall = {
    "zero",     "one",     "two",     "three",     "four",     "five",    "six",
    "seven",    "eight",   "nine",    "ten",       "eleven",   "twelve",  "thirteen",
    "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
constexpr std::array<std::string_view, 10> kTens = {
    "", "", "twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"};

void append_below_thousand(long number, std::vector<std::string>& words) {
    if (number >= 100) {
        words.emplace_back(kSmall[static_cast<std::size_t>(number / 100)]);
        words.emplace_back("hundred");
        number %= 100;
        if (number == 0) {
            return;
        }
        words.emplace_back("and");
    }
    if (number >= 20) {
        words.emplace_back(kTens[static_cast<std::size_t>(number / 10)]);
        number %= 10;
        if (number == 0) {
            return;
        }
    }
    words.emplace_back(kSmall[static_cast<std::size_t>(number)]);
}
}  // namespace

bool is_number_word(std::string_view word) {
    const auto in = [&](const auto& words) {
        return !word.empty() && std::find(words.begin(), words.end(), word) != words.end();
    };
    return in(kSmall) || in(kTens) || word == "hundred" || word == "thousand";
}

std::vector<std::string> number_words(long number) {
    std::vector<std::string> words;
    if (number < 0 || number > kGreatestNumber) {
        return words;
    }
    if (number >= 1000) {
        append_below_thousand(number / 1000, words);
        words.emplace_back("thousand");
        number %= 1000;
        if (number == 0) {
            return words;
        }
        if (number < 100) {
            words.emplace_back("and");
        }
    }
    append_below_thousand(number, words);
    return words;
}

}  // namespace fulcrum::dialogue
