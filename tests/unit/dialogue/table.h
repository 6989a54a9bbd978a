// Tables (tests/support/table.h) of what is said to a question. It stands above, and holds until the next lines of this kind:
// "@question NAME" for one of questions.h, or a question of its own:
//
//   @prompt Which one?    @answer [the] {thing} is red    @nearly {thing} be red
//   @list thing: ball, box|case    @rule place: (on|under) it    @lists NAME (fruit or textures)
//
// "@talk …" says until the next law how a conversation goes.
#pragma once

#include "dialogue/marking/question.h"
#include "dialogue/template/tokens.h"
#include "tests/support/table.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"

namespace fulcrum::dialogue {

using fulcrum::listed;
using fulcrum::spaced;
using fulcrum::yes_or_no;

/// One of questions.h by its id.
[[nodiscard]] inline Question question_named(const std::string& name) {
    for (Question& question : all_questions()) {
        if (question.id == name) {
            return std::move(question);
        }
    }
    throw std::runtime_error("questions.h has no question " + name);
}

/// What stands above a line.
class TableScene {
  public:
    std::string law{};
    std::string talk{};
    std::string with{};                            ///< behind the probe's name
    QuestionSource source{"q", "Which one?", {}};  ///< of a question of the table's own

    /// Compiled at its first use; throws where it can't be.
    [[nodiscard]] const Question& question();
    [[nodiscard]] const TemplateSet& templates() { return *question().templates; }

    /// Takes what stands behind @law, or a line of a question.
    void read(const std::string& word, const std::string& rest);
    /// What is asked next is asked anew.
    void row_done() { done_ = true; }

  private:
    std::shared_ptr<const Question> question_{};
    bool done_ = false;
};

using Probe = std::function<std::string(TableScene& scene, const std::string& in)>;

inline const Question& TableScene::question() {
    if (!question_) {
        question_ = std::make_shared<const Question>(compiled(source));
    }
    return *question_;
}

inline void TableScene::read(const std::string& word, const std::string& rest) {
    if (word == "law") {
        law = rest;
        talk.clear();
        return;
    }
    if (word == "talk") {
        talk = rest;
        return;
    }
    question_.reset();
    if (std::exchange(done_, false) || word == "question") {
        source = {"q", "Which one?", {}};
    }
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    const std::string name = rest.substr(0, colon);
    const std::string behind =
        colon < rest.size() ? std::string(without_blanks(rest.substr(colon + 1))) : "";
    if (word == "question") {
        question_ = std::make_shared<const Question>(question_named(rest));
        done_ = true;
    } else if (word == "prompt") {
        source.prompt = rest;
    } else if (word == "answer") {
        source.answers.push_back(table_field(rest));
    } else if (word == "nearly") {
        source.nearly.push_back(table_field(rest));
    } else if (word == "list") {
        source.lists.emplace_back(name, listed(behind));
    } else if (word == "rule") {
        source.rules.emplace_back(name, behind);
    } else if (word == "lists") {
        const NamedLists& lists = rest == "fruit" ? fruit() : textures();
        source.lists.insert(source.lists.end(), lists.begin(), lists.end());
    } else {
        throw std::runtime_error("a table has no @" + word);
    }
}

/// Holds each table of a folder under tests/unit/dialogue, a section each.
inline void hold_tables(const std::string& folder, const std::map<std::string, Probe>& probes) {
    fulcrum::hold_tables(FULCRUM_SOURCE_DIR "/tests/unit/dialogue/" + folder, [&probes] {
        const auto scene = std::make_shared<TableScene>();
        TableReader reader;
        for (const auto& [name, probe] : probes) {
            reader.probes[name] = [scene, probe = probe](const std::string& with,
                                                         const std::string& in) {
                scene->with = with;
                std::string out = probe(*scene, in);
                scene->row_done();
                return out;
            };
        }
        reader.direct = [scene](const std::string& word, const std::string& rest) {
            scene->read(word, rest);
        };
        return reader;
    });
}

}  // namespace fulcrum::dialogue
