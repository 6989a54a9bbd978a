// Numbers of the command line, what fulcrum arm and soak are told, and how the hand's device is set. For parse_options.cpp.
#pragma once

#include "runtime/app/options.h"

#include <optional>
#include <string>

namespace fulcrum::runtime {

/// The number that `text` is; refuses what is none or lies outside, naming the flag.
[[nodiscard]] Expected<double> number_in(const std::string& flag, const std::string& text,
                                         double low, double high);

/// What only an arm or a soak is told; nothing for a flag of others. Percentages and milliseconds, as people say them.
[[nodiscard]] std::optional<Expected<void>> set_arm_value(Options& options, const std::string& flag,
                                                          const std::string& value);

/// How the hand's device is set; likewise.
[[nodiscard]] std::optional<Expected<void>> set_fit_value(Options& options, const std::string& flag,
                                                          const std::string& value);

}  // namespace fulcrum::runtime
