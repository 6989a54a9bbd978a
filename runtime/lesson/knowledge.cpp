#include "runtime/lesson/knowledge.h"

#include "dialogue/template/sentences.h"
#include "runtime/lesson/questions.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {
namespace {

std::string at(const KnowledgeDescription& knowledge) {
    return "lesson.lua:" + std::to_string(knowledge.line);
}

/// Adds what `knowledge` lists; the error where another meaning of a name is there already.
Expected<void> add_lists(const KnowledgeDescription& knowledge, dialogue::NamedLists& lists) {
    for (const auto& list : knowledge.lists) {
        const auto known =
            std::ranges::find(lists, list.first, &dialogue::NamedLists::value_type::first);
        if (known == lists.end()) {
            lists.push_back(list);
        } else if (known->second != list.second) {
            return fail("the list \"" + list.first + "\" of what \"" + knowledge.id +
                            "\" asks for has other words elsewhere",
                        at(knowledge), "give it a name of its own");
        }
    }
    return {};
}

/// The error of what cannot be compiled together, at the line of the one that cannot be compiled by itself.
Error find_culprit(const LessonDescription& lesson, dialogue::QuestionSource source,
                   const dialogue::Error& together) {
    for (const KnowledgeDescription& knowledge : lesson.knowledge) {
        source.id = knowledge.id;
        source.answers = knowledge.asked;
        if (const auto alone = dialogue::compile_question(source); !alone) {
            return {"what a learner may ask: " + alone.error().message, at(knowledge), {}};
        }
    }
    return {together.message, at(lesson.knowledge.front()), {}};
}

}  // namespace

Expected<std::optional<Knowledge>> Knowledge::compile(const LessonDescription& lesson,
                                                      const dialogue::Catalogue& catalogue) {
    if (lesson.knowledge.empty()) {
        return std::optional<Knowledge>();
    }
    Knowledge made(catalogue);
    dialogue::QuestionSource source;
    source.id = source.prompt = "knowledge";  // nobody asks it: the learner does
    for (const KnowledgeDescription& knowledge : lesson.knowledge) {
        if (auto added = add_lists(knowledge, source.lists); !added) {
            return tl::unexpected(added.error());
        }
        for (const std::string& way : knowledge.asked) {
            source.answers.push_back(way);
            made.names_.push_back(knowledge.id);
        }
    }
    add_things_of_the_scene(lesson, source.lists);
    auto compiled = dialogue::compile_question(source);
    if (!compiled) {
        return tl::unexpected(find_culprit(lesson, std::move(source), compiled.error()));
    }
    made.question_ = std::move(*compiled);
    for (std::size_t i = 0; i < made.names_.size(); ++i) {
        if (i == 0 || made.names_[i] != made.names_[i - 1]) {
            made.examples_.push_back(dialogue::render(
                dialogue::canonical_pieces(*made.question_.templates, static_cast<int>(i), {})));
        }
    }
    return std::optional(std::move(made));
}

std::optional<AskedFor> Knowledge::find(std::string_view words) const {
    dialogue::Mark mark = dialogue::mark_answer(question_, words);
    const bool is_whole = mark.understood && !mark.short_answer && mark.other_number.empty();
    if (!is_whole || mark.answer < 0 || static_cast<std::size_t>(mark.answer) >= names_.size()) {
        return std::nullopt;
    }
    return AskedFor{names_[static_cast<std::size_t>(mark.answer)], std::move(mark)};
}

std::string Knowledge::told(const AskedFor& asked, const std::string& answer) const {
    const std::string said = answer.empty() ? catalogue_->say("knowledge.not_known") : answer;
    return asked.mark.form_right()
               ? said
               : catalogue_->say("knowledge.recast",
                                 {{"sentence", asked.mark.emphasised}, {"answer", said}});
}

std::string Knowledge::unknown() {
    const std::string& example = examples_[next_example_];
    next_example_ = (next_example_ + 1) % examples_.size();
    return catalogue_->say("knowledge.unknown", {{"example", example}});
}

}  // namespace fulcrum::runtime
