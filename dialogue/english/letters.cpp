#include "dialogue/english/letters.h"

#include "dialogue/unicode.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {
constexpr std::size_t kLongestWord = 32;
}

std::string lower_case(std::string_view text) {
    std::string result(text);
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text, at);
        if (const char32_t small = small_letter(character.code); small != character.code) {
            std::string letter;
            append_utf8(letter, small);
            if (letter.size() == character.bytes) {
                result.replace(at, letter.size(), letter);
            }
        }
        at += character.bytes;
    }
    return result;
}

std::string sentence_case(std::string_view text) {
    std::string result(text);
    if (!result.empty() && result[0] >= 'a' && result[0] <= 'z') {
        result[0] = static_cast<char>(result[0] - 'a' + 'A');
    }
    return result;
}

std::string sentences_case(std::string_view text) {
    std::string result(text);
    const auto is_letter = [](char c) {  // all of a letter beyond ASCII too
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               (static_cast<unsigned char>(c) & 0x80U) != 0;
    };
    const auto parts_word = [](char c) { return c == ' ' || c == '*' || c == '\'' || c == ','; };
    bool starts = true;  // the next letter begins a sentence
    bool ended = false;  // a stop stood before this blank
    for (std::size_t i = 0; i < result.size(); ++i) {
        char& letter = result[i];
        const bool alone = letter == 'i' && (i == 0 || parts_word(result[i - 1])) &&
                           (i + 1 == result.size() || parts_word(result[i + 1]));
        if (alone || (starts && letter >= 'a' && letter <= 'z')) {
            letter = static_cast<char>(letter - 'a' + 'A');
        }
        starts = (starts && !is_letter(letter) && (letter < '0' || letter > '9')) ||
                 (ended && (letter == ' ' || letter == '\n'));
        ended = letter == '.' || letter == '!' || letter == '?' || (ended && letter == '*');
    }
    return result;
}

std::string as_sentences(std::string_view text) {
    const std::string sentences = sentences_case(text);
    const bool has_end =
        !sentences.empty() && std::string_view(".?!").find(sentences.back()) != std::string::npos;
    return sentences + (has_end ? "" : ".");
}

int edit_distance(std::string_view a, std::string_view b) {
    if (a.size() > kLongestWord || b.size() > kLongestWord) {
        return static_cast<int>(kLongestWord) + 1;
    }
    using Row = std::array<int, kLongestWord + 1>;
    Row before{};  // row i-2
    Row last{};    // row i-1
    Row row{};     // row i
    for (std::size_t j = 0; j <= b.size(); ++j) {
        last[j] = static_cast<int>(j);
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replace, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        before = last;
        last = row;
    }
    return last[b.size()];
}

}  // namespace fulcrum::dialogue
