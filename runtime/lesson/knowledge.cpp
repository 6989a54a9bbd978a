#include "runtime/lesson/knowledge.h"

#include "dialogue/english/letters.h"
#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/sentences.h"
#include "dialogue/template/tokens.h"
#include "haptics/surface/materials.h"
#include "runtime/lesson/questions.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum::runtime {
namespace {

std::string at(const KnowledgeDescription& knowledge) {
    return "lesson.lua:" + std::to_string(knowledge.line);
}

/// Adds lists or rules of `knowledge`; the error where another meaning of a name is there already.
template <class Named>
Expected<void> add_named(const KnowledgeDescription& knowledge, const char* what, const Named& own,
                         Named& all) {
    for (const auto& each : own) {
        const auto known = std::ranges::find(all, each.first, &Named::value_type::first);
        if (known == all.end()) {
            all.push_back(each);
        } else if (known->second != each.second) {
            return fail(std::string("the ") + what + " \"" + each.first + "\" of what \"" +
                            knowledge.id + "\" asks for has other words elsewhere",
                        at(knowledge), "give it a name of its own");
        }
    }
    return {};
}

/// What things are made of that a lesson may not have: a learner asks for them all the same, and is told "No".
constexpr std::array kEverydayMaterials = {"plastic", "cloth|fabric", "ice", "leather", "clay"};

/// {material}, where no lesson gives it other words: the program's own materials, the lesson's own, and some more.
void add_materials(const LessonDescription& lesson, dialogue::NamedLists& lists) {
    const std::string list = "material";
    if (std::ranges::any_of(lists, [&](const auto& given) { return given.first == list; })) {
        return;
    }
    std::vector<std::string> words;
    const auto add = [&](const std::string& word) {
        const std::string called = word.substr(0, word.find('|'));
        const bool known = std::ranges::any_of(words, [&](const std::string& other) {
            return other.substr(0, other.find('|')) == called;
        });
        if (!known) {
            words.push_back(word);
        }
    };
    const bool has_stone = std::ranges::any_of(
        lesson.materials, [](const auto& own) { return own.felt.name == "stone"; });
    const auto add_material = [&](const std::string& name) {
        add(name == "rock" && !has_stone ? "rock|stone" : name);
    };
    for (const MaterialDescription& own : lesson.materials) {
        add_material(own.felt.name);
    }
    for (const Material& shipped : shipped_materials()) {
        add_material(shipped.name);
    }
    for (const char* everyday : kEverydayMaterials) {
        add(everyday);
    }
    lists.emplace_back(list, std::move(words));
}

/// The ways to ask for `knowledge`, beside what is there already.
Expected<void> add_ways(const KnowledgeDescription& knowledge, int subject,
                        dialogue::QuestionSource& source) {
    for (const std::string& way : knowledge.asked) {
        source.answers.push_back(way);
        source.subjects.push_back(subject);
    }
    for (const std::string& way : knowledge.nearly) {
        source.nearly.push_back(way);
        source.nearly_subjects.push_back(subject);
    }
    return add_named(knowledge, "list", knowledge.lists, source.lists).and_then([&] {
        return add_named(knowledge, "rule", knowledge.rules, source.rules);
    });
}

Expected<dialogue::Question> compile_ways(const LessonDescription& lesson,
                                          dialogue::QuestionSource source,
                                          const KnowledgeDescription& newest) {
    source.id = newest.id;
    add_things_of_the_scene(lesson, source.lists);
    add_materials(lesson, source.lists);
    auto compiled = dialogue::compile_question(source);
    if (!compiled) {
        return fail("what a learner may ask: " + with_letter(compiled.error()), at(newest), {});
    }
    return std::move(*compiled);
}

/// The error of what cannot be compiled together, at the line of the first that cannot be compiled with those before it; first of
/// all what cannot be compiled by itself.
Error find_culprit(const LessonDescription& lesson, Error together) {
    dialogue::QuestionSource before;
    before.prompt = "?";
    for (const KnowledgeDescription& knowledge : lesson.knowledge) {
        dialogue::QuestionSource alone;
        alone.prompt = "?";
        if (!add_ways(knowledge, 0, alone)) {
            continue;
        }
        if (auto compiled = compile_ways(lesson, std::move(alone), knowledge); !compiled) {
            return compiled.error();
        }
    }
    int subject = 0;
    for (const KnowledgeDescription& knowledge : lesson.knowledge) {
        if (auto added = add_ways(knowledge, subject++, before); !added) {
            return added.error();
        }
        if (auto compiled = compile_ways(lesson, before, knowledge); !compiled) {
            return compiled.error();
        }
    }
    return together;
}

}  // namespace

bool begins_as_question(std::string_view words) {
    constexpr std::array<std::string_view, 23> kOpeners = {
        "what", "what's", "how",  "which", "where", "who",  "whose", "why",
        "when", "is",     "are",  "does",  "do",    "did",  "was",   "were",
        "can",  "could",  "will", "would", "has",   "tell", "please"};
    const std::string text = dialogue::lower_case(words);
    const std::size_t begin = text.find_first_not_of(' ');
    const std::size_t last = text.find_last_not_of(' ');
    if (begin == std::string::npos) {
        return false;
    }
    const std::string_view first =
        std::string_view(text).substr(begin, text.find_first_of(" ,?.!", begin) - begin);
    return text[last] == '?' || std::ranges::find(kOpeners, first) != kOpeners.end();
}

bool asks_something(std::string_view words) {
    constexpr std::array<std::string_view, 9> kBefore = {"and", "but",    "so",   "ok",   "okay",
                                                         "oh",  "please", "well", "sorry"};
    constexpr std::array<std::string_view, 9> kAsking = {"what",  "what's", "whats", "how", "which",
                                                         "where", "who",    "whose", "why"};
    constexpr std::array<std::string_view, 23> kHelping = {
        "is",  "are",   "am",    "was",    "were",    "do",     "does", "did",
        "can", "could", "will",  "would",  "shall",   "should", "may",  "must",
        "has", "have",  "isn't", "aren't", "doesn't", "don't",  "can't"};
    constexpr std::array<std::string_view, 6> kPeople = {"i", "you", "he", "she", "we", "they"};
    constexpr std::array<std::string_view, 6> kThings = {"it",    "this",  "that",
                                                         "these", "those", "there"};
    constexpr std::array<std::string_view, 4> kBe = {"is", "are", "was", "were"};
    constexpr std::size_t kLeastHelped = 3;  // "is it red"; "does it" may be an answer
    const auto has = [](const auto& list, const std::string& word) {
        return std::ranges::find(list, word) != list.end();
    };
    std::vector<std::string> said = dialogue::words_of(words);
    while (!said.empty() && has(kBefore, said.front())) {
        said.erase(said.begin());
    }
    if (said.empty()) {
        return false;
    }
    const std::string& first = said.front();
    const bool has_mark = words[words.find_last_not_of(' ')] == '?';
    const bool tells = said.size() > 1 && (first == "tell" || first == "show") && said[1] == "me";
    if (tells || (has(kAsking, first) && (said.size() > 1 || has_mark))) {
        return true;
    }
    if (first == "when") {
        return has_mark || (said.size() > 1 && has(kHelping, said[1]));
    }
    if (!has(kHelping, first) || said.size() < kLeastHelped) {
        return false;
    }
    // "Is there one moon" is as likely an answer out of order; with its mark it asks.
    return has_mark || has(kPeople, said[1]) || (has(kThings, said[1]) && !has(kBe, first));
}

bool gives_away(const dialogue::Question& question, std::string_view asked, std::string_view told) {
    const std::string reply = dialogue::words_between_blanks(told);
    const std::string words = dialogue::words_between_blanks(asked) + reply;
    const auto holds = [&](const std::string& word) {
        return words.find(dialogue::words_between_blanks(word)) != std::string::npos;
    };
    const dialogue::TemplateSet& templates = *question.templates;
    const bool names_a_choice = std::ranges::any_of(templates.slot_lists, [&](int list) {
        return list >= 0 &&
               std::ranges::any_of(templates.lists[static_cast<std::size_t>(list)].items,
                                   [&](const dialogue::ListItem& item) {
                                       return holds(item.value) ||
                                              std::ranges::any_of(item.spoken,
                                                                  [&](const dialogue::Noun& noun) {
                                                                      return holds(noun.text);
                                                                  });
                                   });
    });
    return names_a_choice || reply.starts_with(" yes ") || reply.starts_with(" no ") ||
           std::ranges::any_of(dialogue::sentences_of(told), [&](const std::string& sentence) {
               return dialogue::mark_answer(question, sentence).understood;
           });
}

Expected<std::optional<Knowledge>> Knowledge::compile(const LessonDescription& lesson,
                                                      const dialogue::Catalogue& catalogue) {
    if (lesson.knowledge.empty()) {
        return std::optional<Knowledge>();
    }
    Knowledge made(catalogue);
    dialogue::QuestionSource source;
    source.prompt = "?";  // nobody asks it: the learner does
    int subject = 0;
    for (const KnowledgeDescription& knowledge : lesson.knowledge) {
        if (auto added = add_ways(knowledge, subject++, source); !added) {
            return tl::unexpected(added.error());
        }
        made.names_.resize(source.answers.size(), knowledge.id);
    }
    auto compiled = compile_ways(lesson, std::move(source), lesson.knowledge.back());
    if (!compiled) {
        return tl::unexpected(find_culprit(lesson, compiled.error()));
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

std::vector<AskingSentence> Knowledge::every_way() const {
    std::vector<AskingSentence> all;
    const dialogue::TemplateSet& set = *question_.templates;
    const auto add = [&](std::size_t way,
                         const std::vector<std::pair<std::string, std::string>>& slots) {
        std::string said =
            dialogue::render(dialogue::canonical_pieces(set, static_cast<int>(way), slots));
        if (all.empty() || all.back().said != said) {
            all.push_back({names_[way], std::move(said)});
        }
    };
    for (std::size_t way = 0; way < names_.size(); ++way) {
        add(way, {});
        for (std::size_t slot = 0; slot < set.slots.size(); ++slot) {
            if ((set.graphs[way].slots & (1U << slot)) == 0) {
                continue;
            }
            for (const dialogue::ListItem& item :
                 set.lists[static_cast<std::size_t>(set.slot_lists[slot])].items) {
                add(way, {{set.slots[slot], item.value}});
            }
        }
    }
    return all;
}

std::optional<AskedFor> Knowledge::find(std::string_view words, bool form) const {
    dialogue::Mark mark = dialogue::mark_answer(question_, words);
    const bool is_whole = mark.understood && !mark.short_answer && mark.other_number.empty() &&
                          mark.claim == dialogue::Claim::same;
    if (!is_whole || mark.answer < 0 || static_cast<std::size_t>(mark.answer) >= names_.size()) {
        return std::nullopt;
    }
    const std::string& name = names_[static_cast<std::size_t>(mark.answer)];
    return AskedFor{name, form ? std::move(mark) : without_form(std::move(mark)), {}};
}

std::string Knowledge::told(const AskedFor& asked, const std::string& answer) const {
    const std::string said = answer.empty() ? catalogue_->say("knowledge.not_known") : answer;
    if (!asked.praise.empty()) {
        return asked.praise + ' ' + said;
    }
    return asked.mark.form_errors.empty()
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
