#include "runtime/app/option_table.h"
#include "runtime/app/parse_options.h"

#include <algorithm>
#include <sstream>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kTextColumn = 29;
constexpr std::size_t kLastColumn = 118;
constexpr const char* kHead =
    "Fulcrum: lessons that are felt. In () what holds without an option, in [] the numbers it "
    "takes.\n\n";
constexpr const char* kEnd = R"(
Exit codes: 0 done, 1 the lesson or a test failed, 2 wrong usage or unreadable input, 3 a replay gave other forces than its record,
4 the lesson was played and what the learner did was not all kept, 130 ended by Ctrl-C, 143 by SIGTERM (what there was of a run is kept).
)";

// What is said, so far into the line, and what it is for in a column beside it.
std::string beside(std::string line, std::string_view name, std::string_view value,
                   const std::string& text) {
    line += name;
    line += value.empty() ? "" : " ";
    line += value;
    std::string all;
    std::istringstream words(text);
    bool begins = true;
    for (std::string word; words >> word; begins = false) {
        if (line.size() + (begins ? 2 : 1 + word.size()) > (begins ? kTextColumn : kLastColumn)) {
            all += line + '\n';
            line.clear();
        }
        line += std::string(begins || line.empty() ? kTextColumn - line.size() : 1, ' ') + word;
    }
    return all + line + '\n';
}

std::string described(const OptionRow& option) {
    return beside("      ", option.name, option.value,
                  std::string(option.text) + (option.low < option.high
                                                  ? " [" + number_text(option.low) + " to " +
                                                        number_text(option.high) + ']'
                                                  : ""));
}

// A command and its options; those of an earlier command by their names, but where it stands `alone`.
std::string part_of(const CommandRow& command, bool alone) {
    std::string part = beside("  fulcrum ", command.word, command.takes, std::string(command.text));
    for (const CommandRow& owner : command_rows()) {
        std::string names;
        for (const OptionRow& option : option_rows()) {
            const bool is_owned = std::ranges::find_if(command_rows(), [&](const CommandRow& row) {
                                      return option.is_of(row.command);
                                  })->command == owner.command;
            if (!is_owned || !option.is_of(command.command)) {
                continue;
            }
            if (alone || owner.command == command.command) {
                part += described(option);
            } else {
                names += std::string(option.name) + ' ';
            }
        }
        part += names.empty() ? "" : beside("      ", "as with", owner.word, names);
    }
    return part;
}

}  // namespace

std::string usage(std::string_view command) {
    std::string all = kHead;
    for (const CommandRow& row : command_rows()) {
        if (row.word == command && !row.text.empty()) {
            return part_of(row, true) + "\nfulcrum help shows all commands.\n";
        }
        all += row.text.empty() ? "" : part_of(row, false);
    }
    return all + kEnd;
}

}  // namespace fulcrum::runtime
