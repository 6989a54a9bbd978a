// What each word of the command line does. Each returns the program's exit code: 0 done, 1 the lesson or a test failed, 2
// wrong usage or unreadable input, 3 a replay's forces differ from its record's, 130 when Ctrl-C came before the lesson began.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/options.h"
#include "runtime/app/places.h"

namespace fulcrum::runtime {

/// What every command may need.
struct Installation {
    Places places;
    dialogue::Catalogue catalogue;
    double started_s = 0.0;  ///< when the program began, monotonic clock
};

/// Finds the folders and reads the words.
[[nodiscard]] Expected<Installation> open_installation(double started_s);

/// Says an error in one sentence on the terminal and gives the exit code.
int complain(const Error& error, int exit_code);
/// The same of a lesson that could not be made ready, 1; where Ctrl-C stopped that, nothing is said and the code is the signal's.
int complain_of_loading(const Error& error);

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
[[nodiscard]] int devices_command(const Options& options);
[[nodiscard]] int arm_command(const Options& options);
[[nodiscard]] int stop_command(const Options& options);
[[nodiscard]] int soak_command(const Installation& installation, const Options& options);

}  // namespace fulcrum::runtime
