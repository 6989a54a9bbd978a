// Tables of what goes in and what comes out: NAME_table.txt beside the tests of a folder, a case a line. A line is
//
//   IN => OUT        what comes out is OUT
//   IN =~ OUT        the same, where " … " in OUT stands for anything
//   IN               what comes out is that of the last @give
//   @each IN / IN    several of these
//   @law NAME        what the lines below it show
//   @try PROBE WITH  what is done with what goes in; the test of the folder has the probes
//   @give OUT
//   # …              says why
//
// A text in quotes may have \n, \t, \r, \\, \" and \xHH in it. What is asked stands above, and holds until the next lines of
// this kind: "@question NAME" for one of questions.h, or a question of its own:
//
//   @prompt Which one?    @answer [the] {thing} is red    @nearly {thing} be red
//   @list thing: ball, box|case    @rule place: (on|under) it    @lists NAME (fruit or textures)
#pragma once

#include "dialogue/marking/question.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// What stands above a line.
class TableScene {
  public:
    std::string law{};
    std::string with{};                            ///< behind the probe's name
    QuestionSource source{"q", "Which one?", {}};  ///< of a question of the table's own

    /// Compiled at its first use; throws where it can't be.
    [[nodiscard]] const Question& question();
    [[nodiscard]] const TemplateSet& templates() { return *question().templates; }

    /// Takes a line that begins with @, but for @law, @try and @give.
    void read(const std::string& word, const std::string& rest);
    /// What is asked next is asked anew.
    void row_done() { done_ = true; }

  private:
    std::shared_ptr<const Question> question_{};
    bool done_ = false;
};

using Probe = std::function<std::string(TableScene& scene, const std::string& in)>;

/// Holds each table of a folder under tests/unit/dialogue, a section each. A table without a line, a line without an
/// outcome and an unknown probe fail.
void hold_tables(const std::string& folder, const std::map<std::string, Probe>& probes);

/// Each with a blank behind the one before.
template <class Range>
[[nodiscard]] std::string spaced(const Range& texts, const char* between = " ") {
    std::string all;
    bool first = true;
    for (const auto& text : texts) {
        all += first ? "" : between;
        all += text;
        first = false;
    }
    return all;
}

/// The parts of "a, b, c"; none of "".
[[nodiscard]] std::vector<std::string> listed(const std::string& text,
                                              const std::string& between = ", ");

[[nodiscard]] inline std::string yes_or_no(bool is) {
    return is ? "yes" : "no";
}

}  // namespace fulcrum::dialogue
