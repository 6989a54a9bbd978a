#include "runtime/app/parse_options.h"

#include "dialogue/english/letters.h"
#include "runtime/app/option_table.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace fulcrum::runtime {
namespace {

const CommandRow* find_command(std::string_view word) {
    const auto rows = command_rows();
    const auto found = std::ranges::find(rows, word, &CommandRow::word);
    return found == rows.end() ? nullptr : &*found;
}

// Names the known word that is meant, where one is near.
tl::unexpected<Error> unknown(const std::string& what, const std::string& word,
                              const std::vector<std::string_view>& known) {
    const auto distance = [&](std::string_view other) {
        return dialogue::edit_distance(word, other);
    };
    const auto best = std::ranges::min_element(known, {}, distance);
    // A third of the letters may be wrong; a guess that is further off would puzzle more than help.
    const int most = std::clamp(static_cast<int>(word.size()) / 3, 2, 3);
    const bool is_near = best != known.end() && distance(*best) <= most;
    return fail(what + " \"" + word + "\" is not known", "",
                is_near ? "did you mean " + std::string(*best) + "?  See fulcrum help"
                        : "see fulcrum help");
}

// A word that is no option.
Expected<void> set_lesson(Options& options, const CommandRow& command, const std::string& word) {
    if (command.command == Command::help && find_command(word) != nullptr) {
        options.help_for = word;
        return {};
    }
    if (command.takes_several()) {
        options.words.push_back(word);
        return {};
    }
    if (command.takes.empty() || !options.lesson.empty()) {
        return fail("\"" + word + "\" is one word too many", "", "see fulcrum help");
    }
    options.lesson = word;
    return {};
}

// The word at `i`, and its value where it has one.
Expected<void> take_word(Options& options, const CommandRow& command,
                         std::span<const std::string> words, std::size_t& i) {
    const std::string& word = words[i];
    if (!word.starts_with("--")) {
        return set_lesson(options, command, word);
    }
    std::vector<std::string_view> known;
    const OptionRow* option = nullptr;
    for (const OptionRow& row : option_rows()) {
        if (row.is_of(command.command)) {
            known.push_back(row.name);
            option = row.name == word ? &row : option;
        }
    }
    if (option == nullptr) {
        return unknown("for " + std::string(command.word) + ", the option", word, known);
    }
    if (option->value.empty()) {
        return option->set(options, *option, {});
    }
    if (i + 1 == words.size()) {
        return fail(word + " needs a value", "", "see fulcrum help");
    }
    return option->set(options, *option, words[++i]);
}

}  // namespace

Expected<Options> parse_options(std::span<const std::string> words) {
    Options options;
    if (words.empty()) {
        return options;
    }
    // Options alone are those of the list of lessons.
    const bool only_options = words[0].starts_with("--") && find_command(words[0]) == nullptr;
    const CommandRow* const command = find_command(only_options ? "room" : words[0]);
    if (command == nullptr) {
        std::vector<std::string_view> known;
        std::ranges::transform(command_rows(), std::back_inserter(known), &CommandRow::word);
        return unknown("the command", words[0], known);
    }
    options.command = command->command;
    for (std::size_t i = only_options ? 0 : 1; i < words.size(); ++i) {
        if (words[i] == "--help" || words[i] == "-h") {
            options.command = Command::help;
            options.help_for = words[0];
            return options;
        }
        if (auto taken = take_word(options, *command, words, i); !taken) {
            return tl::unexpected(taken.error());
        }
    }
    if (command->takes_several()) {
        return options.words.empty() ? fail(words[0] + " needs to know what to do", "",
                                            "see fulcrum help " + words[0])
                                     : Expected<Options>(options);
    }
    if (!command->takes.empty() && options.lesson.empty()) {
        return command->command == Command::export_record || options.force_at_s
                   ? fail(words[0] + " needs a record", "", "name a file that --record wrote")
                   : fail(words[0] + " needs a lesson", "", "name one; fulcrum list shows them");
    }
    return options;
}

}  // namespace fulcrum::runtime
