#include "dialogue/template/tokens.h"

#include "dialogue/english/number.h"
#include "dialogue/unicode.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {

bool is_digit(char32_t code) {
    return code >= '0' && code <= '9';
}

bool is_apostrophe(char32_t code) {
    return code == '\'' || code == '`' || code == 0x2018 || code == 0x2019 || code == 0x02BC ||
           code == 0x00B4;
}

/// Letters and digits; beyond ASCII everything but known punctuation, spaces and private characters.
bool is_word_character(char32_t code) {
    if (code < 0x80) {
        return is_digit(code) || (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z');
    }
    const bool latin_letter = code >= 0xC0 && code != 0xD7 && code != 0xF7;
    const bool punctuation =  // with arrows and signs of calculation
        (code >= 0x2000 && code <= 0x206F) || (code >= 0x2190 && code <= 0x23FF) ||
        (code >= 0x3000 && code <= 0x303F) || code >= 0xE000;  // kReplacement too
    return latin_letter && !punctuation;
}

struct Ending {
    std::string_view short_form, word;
};
constexpr std::array kEndings = {Ending{"n't", "not"}, Ending{"'s", "is"},    Ending{"'re", "are"},
                                 Ending{"'m", "am"},   Ending{"'ve", "have"}, Ending{"'ll", "will"},
                                 Ending{"'d", "would"}};

/// Adds the word (its last apostrophe is at byte `apostrophe` of the text), parted when it is a contraction: it's, can't, they're. Other apostrophes are dropped.
void push_word(std::vector<Token>& tokens, const Token& raw, std::size_t apostrophe) {
    if (raw.text.find('\'') == std::string::npos) {
        tokens.push_back(raw);
        return;
    }
    for (const Ending& ending : kEndings) {
        if (raw.text.size() <= ending.short_form.size() || !raw.text.ends_with(ending.short_form)) {
            continue;
        }
        const std::size_t stem_size = raw.text.size() - ending.short_form.size();
        std::string stem = raw.text.substr(0, stem_size);
        if (stem == "ca") {
            stem = "can";
        } else if (stem == "wo") {
            stem = "will";
        }
        const std::string_view word = stem == "let" ? "us" : ending.word;
        const std::size_t middle = apostrophe - (ending.short_form == "n't" ? 1 : 0);
        tokens.push_back({std::move(stem), raw.begin, middle});
        tokens.push_back({std::string(word), middle, raw.end});
        return;
    }
    Token plain{"", raw.begin, raw.end};
    for (const char letter : raw.text) {
        if (letter != '\'') {
            plain.text.push_back(letter);
        }
    }
    if (!plain.text.empty()) {
        tokens.push_back(std::move(plain));
    }
}

/// "It's got" is "it has got", not "it is got".
void mend_got(std::vector<Token>& tokens) {
    const std::size_t n = tokens.size();
    const bool got = n > 2 && tokens[n - 1].text == "got" && tokens[n - 2].text == "is";
    // Both parts of a contraction meet within the word, without a space between them.
    if (got && tokens[n - 3].end == tokens[n - 2].begin) {
        tokens[n - 2].text = "has";
    }
}

/// Adds a run of digits as words; long ones stay digits.
void push_number(std::vector<Token>& tokens, const Token& raw) {
    if (raw.text.size() <= 6) {
        for (std::string& word : number_words(std::stol(raw.text))) {
            tokens.push_back({std::move(word), raw.begin, raw.end});
        }
        return;
    }
    tokens.push_back(raw);
}

/// A run of digits, or of letters with apostrophes inside.
struct Run {
    Token raw;
    std::size_t apostrophe = 0;  ///< byte of the last one
    bool number = false;
};

/// The digits of a whole number from `at` on: "3", "1,000", "3.0"; where they end in `end`.
std::string whole_digits(std::string_view text, std::size_t at, std::size_t& end) {
    const auto digits_from = [&](std::size_t from) {
        const std::size_t stop = std::min(text.find_first_not_of("0123456789", from), text.size());
        return stop - std::min(from, stop);
    };
    constexpr std::size_t kGroup = 3;
    std::size_t count = digits_from(at);
    std::string digits(text.substr(at, count));
    end = at + count;
    while (count <= kGroup && text.substr(end, 1) == "," && digits_from(end + 1) == kGroup) {
        digits += text.substr(end + 1, kGroup);
        end += 1 + kGroup;
    }
    // "3.0" is 3, "3.5" isn't.
    if (const std::size_t behind = text.substr(end, 1) == "." ? digits_from(end + 1) : 0;
        behind > 0) {
        const std::string_view fraction = text.substr(end + 1, behind);
        end += fraction.find_first_not_of('0') == std::string_view::npos ? 1 + behind : 0;
    }
    return digits;
}

/// A sign of its own before a number: "-3", no hyphen of "two-3" and no range "2-3".
bool is_minus(std::string_view text, std::size_t at, const Character& sign) {
    constexpr char32_t kMinus = 0x2212;
    const std::size_t next = at + sign.bytes;
    const bool apart = at == 0 || text[at - 1] == ' ' || text[at - 1] == '(';
    return (sign.code == '-' || sign.code == kMinus) && apart && next < text.size() &&
           is_digit(character_at(text, next).code);
}

/// Takes the run that begins at `at`; empty when a word can't begin there.
Run take_run(std::string_view text, std::size_t at) {
    Run run{{"", at, at}, at, is_digit(character_at(text, at).code)};
    if (run.number) {
        run.raw.text = whole_digits(text, at, run.raw.end);
        return run;
    }
    while (at < text.size()) {
        const Character character = character_at(text, at);
        const bool letter = is_word_character(character.code) && !is_digit(character.code);
        if (letter) {
            append_folded(run.raw.text, character.code);
        } else if (is_apostrophe(character.code) && !run.raw.text.empty()) {
            run.raw.text.push_back('\'');
            run.apostrophe = at;
        } else {
            break;
        }
        at += character.bytes;
        run.raw.end = at;
    }
    return run;
}

}  // namespace

std::vector<Token> tokenise(std::string_view text) {
    std::vector<Token> tokens;
    std::size_t at = 0;
    while (at < text.size()) {
        const Run run = take_run(text, at);
        if (run.raw.text.empty()) {
            const Character sign = character_at(text, at);
            if (is_minus(text, at, sign)) {
                tokens.push_back({"minus", at, at + sign.bytes});
            }
            at += sign.bytes;
            continue;
        }
        at = run.raw.end;
        if (!run.number) {
            push_word(tokens, run.raw, run.apostrophe);
            mend_got(tokens);
            continue;
        }
        push_number(tokens, run.raw);
        if (text.substr(at, 1) == "." && at + 1 < text.size() &&
            is_digit(character_at(text, at + 1).code)) {
            tokens.push_back({"point", at, at + 1});
            ++at;
        }
    }
    return tokens;
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    for (Token& token : tokenise(text)) {
        words.push_back(std::move(token.text));
    }
    return words;
}

std::string words_between_blanks(std::string_view text) {
    std::string words = " ";
    for (const Token& token : tokenise(text)) {
        words += token.text + " ";
    }
    return words;
}

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
    return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

}  // namespace fulcrum::dialogue
