// What each word of the command line does. Each returns the program's exit code: 0 done, 1 the lesson or a test failed, 2
// wrong usage or unreadable input, 3 a replay's forces differ from its record's, 130 when Ctrl-C came before the lesson began.
#pragma once

#include "runtime/app/installation.h"
#include "runtime/app/options.h"

namespace fulcrum::runtime {

[[nodiscard]] int menu_command(const Installation& installation, const Options& options);
[[nodiscard]] int run_command(const Installation& installation, const Options& options);
[[nodiscard]] int list_command(const Installation& installation);
[[nodiscard]] int check_command(const Installation& installation, const Options& options);
[[nodiscard]] int test_command(const Installation& installation, const Options& options);
[[nodiscard]] int explain_command(const Installation& installation, const Options& options);
/// Of a record instead of a lesson: why its force was felt at a time.
[[nodiscard]] int explain_force_command(const Options& options);
[[nodiscard]] int export_command(const Options& options);
[[nodiscard]] int report_command(const Options& options);
[[nodiscard]] int class_command(const Options& options);
[[nodiscard]] int devices_command(const Options& options);
[[nodiscard]] int arm_command(const Options& options);
[[nodiscard]] int stop_command(const Options& options);
[[nodiscard]] int soak_command(const Installation& installation, const Options& options);

}  // namespace fulcrum::runtime
