// Answers as learners give them, marked in one go: shared by the tests of marking.
#pragma once

#include "dialogue/marking/mark.h"
#include "dialogue/marking/readings.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// What learners say, the errors in it in their order, and the sentence that is said back.
struct MarkedRow {
    const char *said, *codes, *recast;
};

/// The errors' codes, a blank between two.
[[nodiscard]] inline std::string codes_of(const Mark& mark) {
    std::string codes;
    for (const FormError& error : mark.form_errors) {
        codes += (codes.empty() ? "" : " ") + std::string(error.errant());
    }
    return codes;
}

inline void check_rows(const Question& question, const std::vector<MarkedRow>& rows) {
    for (const MarkedRow& row : rows) {
        INFO(row.said);
        const Mark mark = mark_answer(question, row.said);
        CHECK(mark.understood);
        CHECK(codes_of(mark) == row.codes);
        CHECK(mark.emphasised == row.recast);
    }
}

/// "right", "wrong" or "?" where only `right` values are right, and the errors of form.
inline std::string verdict_on(const Question& question, const std::string& said,
                              const std::vector<std::string>& right) {
    Mark mark = mark_answer(question, said);
    if (!mark.understood) {
        return "?";
    }
    std::vector<bool> verdicts;
    for (const Slots& reading : readings_of(mark)) {
        verdicts.push_back(std::ranges::any_of(reading, [&](const auto& slot) {
            return std::ranges::find(right, slot.second) != right.end();
        }));
    }
    const std::string errors = codes_of(mark);
    return std::string(settle(mark, verdicts) ? "right" : "wrong") +
           (errors.empty() ? "" : " " + errors);
}

}  // namespace fulcrum::dialogue
