#include "dialogue/english/number.h"

#include <array>
#include <string_view>

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
