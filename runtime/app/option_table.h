// The command line's one table: each command and each option stands here once. What is taken, what is refused and in which words, the help
// and the manual page come from it.
#pragma once

#include "runtime/app/options.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

struct CommandRow {
    std::string_view word;
    Command command;
    std::string_view
        takes;  ///< the one word behind it that is no option, or several where it ends in "..."; empty: none
    std::string_view text;  ///< for the help; empty: another word for the same

    [[nodiscard]] bool takes_several() const { return takes.ends_with("..."); }
};

struct OptionRow {
    /// Takes a value, empty where there is none to take; refuses what it cannot be, saying what it can.
    using Set = Expected<void> (*)(Options& options, const OptionRow& row,
                                   const std::string& value);

    std::string_view name;  ///< with its dashes
    std::string_view
        value;  ///< as the help names it, choices with | between them; empty: it takes none
    std::uint32_t commands;  ///< that understand it, a bit each
    Set set;
    std::string_view text;         ///< for the help, blanks and ends of lines alike
    double low = 0.0, high = 0.0;  ///< of a number, both included; the same: of none

    [[nodiscard]] bool is_of(Command command) const {
        return (commands >> static_cast<unsigned>(command) & 1U) != 0;
    }
};

[[nodiscard]] std::span<const CommandRow> command_rows();
[[nodiscard]] std::span<const OptionRow> option_rows();

/// "0.25", "86400".
[[nodiscard]] std::string number_text(double number);

}  // namespace fulcrum::runtime
