#include "runtime/lesson/learner_model.h"

#include "dialogue/marking/mark_answer.h"

#include <map>

namespace fulcrum::runtime {
namespace {

constexpr const char* kUnclear = "hm well the thing you know";
constexpr const char* kGivesUp = "I don't know";

}  // namespace

LearnerModel::Kind LearnerModel::draw_kind() {
    const double u = chance_.draw_chance();
    if (u < rates_.wrong) {
        return Kind::wrong;
    }
    if (u < rates_.wrong + rates_.form) {
        return Kind::form;
    }
    return u < rates_.wrong + rates_.form + rates_.unclear ? Kind::unclear : Kind::right;
}

// Any of the question's whole answers: with errors by any way through it, else as a recast has it.
std::string LearnerModel::draw_sentence(const dialogue::TemplateSet& set, bool errors) {
    const auto graph = static_cast<int>(chance_.draw() % static_cast<std::uint64_t>(set.answers));
    const dialogue::Sample sample = dialogue::walk(set, graph, errors, [this](std::size_t n) {
        return static_cast<std::size_t>(chance_.draw() % n);
    });
    return errors ? sample.said
                  : dialogue::render(dialogue::canonical_pieces(set, graph, sample.slots));
}

Expected<std::string> LearnerModel::answer(const dialogue::Question& question,
                                           const Verdict& verdict) {
    const Kind kind = draw_kind();
    if (kind == Kind::unclear) {
        return kUnclear;
    }
    std::string right;  // to fall back on
    std::map<AnswerSlots, bool> judged;
    const auto judge = [&](const AnswerSlots& slots) -> Expected<bool> {
        const auto known = judged.find(slots);
        return known != judged.end() ? Expected<bool>(known->second)
                                     : verdict(slots).map([&](bool is_right) {
                                           return judged.emplace(slots, is_right).first->second;
                                       });
    };
    for (int walk = 0; walk < kMostWalks; ++walk) {
        const bool errs = kind == Kind::form && !(walk > kMostWalks / 2 && right.empty());
        const std::string said = draw_sentence(*question.templates, errs);
        const dialogue::Mark mark = dialogue::mark_answer(question, said);
        if (!mark.understood || !mark.other_number.empty() || mark.claim != dialogue::Claim::same) {
            continue;
        }
        const auto is_right = judge(mark.slots);
        if (!is_right) {
            return tl::unexpected(is_right.error());
        }
        const Kind said_kind = !*is_right          ? Kind::wrong
                               : mark.form_right() ? Kind::right
                                                   : Kind::form;
        if (said_kind == kind) {
            return said;
        }
        if (said_kind == Kind::right) {
            right = said;
        }
    }
    return right.empty() ? std::string(kGivesUp) : right;
}

}  // namespace fulcrum::runtime
