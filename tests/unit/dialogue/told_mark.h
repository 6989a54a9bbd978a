// A mark and a parse as texts, for tables.
#pragma once

#include "dialogue/marking/mark_answer.h"
#include "dialogue/marking/readings.h"
#include "dialogue/template/matcher.h"
#include "dialogue/template/resolve.h"
#include "dialogue/template/sentences.h"
#include "dialogue/template/tokens.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/table.h"

namespace fulcrum::dialogue {

/// The errors' codes, a blank between two.
[[nodiscard]] inline std::string codes_of(const Mark& mark) {
    std::string codes;
    for (const FormError& error : mark.form_errors) {
        codes += (codes.empty() ? "" : " ") + std::string(error.errant());
    }
    return codes;
}

/// "thing=egg other=apple"
[[nodiscard]] inline std::string told_slots(
    const std::vector<std::pair<std::string, std::string>>& slots) {
    std::vector<std::string> texts;
    texts.reserve(slots.size());
    for (const auto& [slot, value] : slots) {
        texts.push_back(slot + "=" + value);
    }
    return spaced(texts);
}

/// One property of a mark by its name; of what is not understood "codes" are "?".
[[nodiscard]] inline std::string told_of(const Mark& mark, const std::string& field) {
    constexpr std::array kClaims{"same", "contrary", "excluded", "none",
                                 "any",  "every",    "reasoned"};
    std::string denied;
    for (const bool one : mark.denied) {
        denied += one ? '1' : '0';
    }
    const std::pair<const char*, std::string> texts[] = {
        {"understood", yes_or_no(mark.understood)},
        {"codes", mark.understood ? codes_of(mark) : "?" + codes_of(mark)},
        {"emphasised", mark.emphasised},
        {"corrected", mark.corrected},
        {"gapped", mark.gapped},
        {"short", mark.short_answer ? "short" : "whole"},
        {"form", mark.form_right() ? "right" : "wrong"},
        {"slots", told_slots(mark.slots)},
        {"claim", kClaims.at(static_cast<std::size_t>(mark.claim))},
        {"denied", denied},
        {"readings", std::to_string(readings_of(mark).size())},
        {"answer", std::to_string(mark.answer)},
        {"opposite", mark.opposite_said},
        {"opposite_of", mark.opposite_of},
        {"pointed", mark.pointed_with},
        {"number", mark.other_number},
        {"turned", mark.turned_round ? "turned" : "as asked"},
        {"phrase", mark.form_errors.empty() ? "" : mark.form_errors.front().phrase},
        {"unread", mark.unread}};
    for (const auto& [name, text] : texts) {
        if (field == name) {
            return text;
        }
    }
    FAIL("a mark has no " << field);
    return {};
}

/// One property of a parse by its name; of what does not match each is "?".
[[nodiscard]] inline std::string told_of(const std::optional<Parse>& parse,
                                         const std::string& field) {
    if (!parse) {
        return "?";
    }
    std::vector<std::string> codes;
    std::vector<std::string> wrong;
    for (const Piece& piece : parse->pieces) {
        if (piece.code != ErrorCode::none) {
            codes.emplace_back(errant_code(piece.code));
            wrong.push_back(codes.back() + "->" + piece.right);
        }
    }
    const std::pair<const char*, std::string> texts[] = {
        {"codes", spaced(codes)},
        {"wrong", spaced(wrong)},
        {"back", render(parse->pieces)},
        {"cost", std::to_string(parse->cost)},
        {"right", yes_or_no(parse->cost == 0)},
        {"total", std::to_string(total_cost(parse->pieces))},
        {"graph", std::to_string(parse->graph)},
        {"slots", told_slots(parse->slots)}};
    for (const auto& [name, text] : texts) {
        if (field == name) {
            return text;
        }
    }
    FAIL("a parse has no " << field);
    return {};
}

/// The properties that are named with a blank between two names, "|" between two of them.
template <class Told>
[[nodiscard]] std::string told_fields(const Told& told, const std::string& fields) {
    std::istringstream names(fields);
    std::vector<std::string> texts;
    for (std::string field; names >> field;) {
        texts.push_back(told_of(told, field));
    }
    return std::string(without_blanks(spaced(texts, " | ")));
}

/// The probe `match` of tables: with the names of properties.
[[nodiscard]] inline std::string probe_match(TableScene& scene, const std::string& in) {
    return told_fields(match(scene.templates(), in), scene.with);
}

/// The probe `mark` of tables: with the names of properties.
[[nodiscard]] inline std::string probe_mark(TableScene& scene, const std::string& in) {
    return told_fields(mark_answer(scene.question(), in), scene.with);
}

}  // namespace fulcrum::dialogue
