#include "dialogue/speech/external/partner_lines.h"

#include "dialogue/speech/external/json_line.h"

#include <optional>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kLongestLine =
    20'000;  // bytes: each letter of the longest text written as \uXXXX, and much room

/// The character at `at` of good UTF-8, and how many bytes it has.
struct Character {
    char32_t code = 0;
    std::size_t bytes = 1;
};
Character character_at(std::string_view text, std::size_t at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t bytes = lead < 0x80U ? 1 : lead < 0xE0U ? 2 : lead < 0xF0U ? 3 : 4;
    char32_t code = bytes == 1 ? lead : lead & (0x7FU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        code = code << 6U | (static_cast<unsigned char>(text[at + i]) & 0x3FU);
    }
    return {code, bytes};
}

/// What orders a screen about instead of standing there: ASCII's and Latin-1's controls, zero widths, directions.
bool is_left_out(char32_t code) {
    return code < 0x20U || (code >= 0x7FU && code < 0xA0U) || code == 0xADU ||
           (code >= 0x200BU && code <= 0x200FU) || (code >= 0x2028U && code <= 0x202EU) ||
           (code >= 0x2060U && code <= 0x206FU) || code == 0xFEFFU;
}

/// Latin letters with their accents, and the marks of print: dashes, quotes, the ellipsis, the euro.
bool is_readable(char32_t code) {
    return code < 0x250U || (code >= 0x2010U && code <= 0x205EU) || code == 0x20ACU;
}

}  // namespace

std::string write_line(const TurnLine& line) {
    Json object{{"turn", line.turn}, {"level", line.level}, {"ours", line.ours}};
    if (!line.asks.empty()) {
        object["asks"] = line.asks;
        return to_text(object);
    }
    object["prompt"] = line.prompt;
    object["said"] = line.said;
    object["kind"] = line.kind;
    object["attempt"] = line.attempt;
    object["corrected"] = line.corrected;
    object["errors"] = line.errors;
    return to_text(object);
}

Expected<TextLine> read_text_line(std::string_view line) {
    const Json object = parse_line(line, kLongestLine);
    const auto turn = whole_number(object, "turn");
    const auto text = text_of(object, "text");
    if (!turn || !text) {
        return fail("says a line that is no {\"turn\": …, \"text\": …}");
    }
    TextLine read{*turn, {}};
    std::size_t n = 0;
    for (std::size_t at = 0; at < text->size();) {
        const Character character = character_at(*text, at);
        if (!is_left_out(character.code)) {
            if (!is_readable(character.code)) {
                return fail("says what is not in the letters of English");
            }
            read.text.append(*text, at, character.bytes);
            ++n;
        } else if (character.code == U'\n' || character.code == U'\t') {
            read.text += ' ';
            ++n;
        }
        at += character.bytes;
    }
    if (read.text.find_first_not_of(' ') == std::string::npos) {
        return fail("says nothing in its text");
    }
    if (n > kLongestPartnerText) {
        return fail("says more than 400 characters");
    }
    return read;
}

}  // namespace fulcrum::dialogue
