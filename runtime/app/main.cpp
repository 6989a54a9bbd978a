// The program: a lesson's process when it was started as one, else what the command line asks for.
#include "haptics/base/clock.h"
#include "runtime/app/bench_command.h"
#include "runtime/app/commands.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/parse_options.h"
#include "runtime/app/program_build.h"
#include "runtime/app/site_file.h"
#include "runtime/lua/process/lesson_process.h"

#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime {
namespace {

// What needs lessons, words and the limits of this place.
int run_with_lessons(Options options, double started_s) {
    const auto site = find_site_limits(options.force_limit_N);
    if (!site) {
        return complain(site.error(), 2);
    }
    if (options.force_limit_N && *options.force_limit_N > site->force_N) {
        std::fprintf(stderr, "This place allows %g N, so that is the limit, not %g N.\n",
                     site->force_N, *options.force_limit_N);
    }
    options.site = *site;
    const auto installation = open_installation(started_s);
    if (!installation) {
        return complain(installation.error(), 2);
    }
    switch (options.command) {
        case Command::run:
            return run_command(*installation, options);
        case Command::list:
            return list_command(*installation);
        case Command::check:
            return check_command(*installation, options);
        case Command::test:
            return test_command(*installation, options);
        case Command::explain:
            return explain_command(*installation, options);
        case Command::soak:
            return soak_command(*installation, options);
        default:
            break;
    }
    return menu_command(*installation, options);
}

int run_program(int argc, char** argv) {
    if (const auto socket = lesson_process_socket(argc, argv)) {
        return lesson_process_main(*socket);
    }

    const double started_s = monotonic_now_s();
    watch_for_interrupts();
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (!words.empty() && words[0] == "bench") {
        return bench_command(std::span(words).subspan(1));
    }
    const auto options = parse_options(words);
    if (!options) {
        return complain(options.error(), 2);
    }
    if (options->command == Command::help) {
        std::fputs(usage(options->help_for).c_str(), stdout);
        return 0;
    }
    if (options->command == Command::version) {
        std::printf("Fulcrum %s\n", kProgramVersion);
        return 0;
    }
    switch (options->command) {
        case Command::explain:
            return options->force_at_s ? explain_force_command(*options)
                                       : run_with_lessons(*options, started_s);
        case Command::export_record:
            return export_command(*options);
        case Command::report:
            return report_command(*options);
        case Command::school_class:
            return class_command(*options);
        case Command::devices:
            return devices_command(*options);
        case Command::arm:
            return arm_command(*options);
        case Command::stop:
            return stop_command(*options);
        default:
            return run_with_lessons(*options, started_s);
    }
}

// There is none for a sentence that is put together.
int complain_of_memory() noexcept {
    std::fputs("There is no memory left; end other programs and start again.\n", stderr);
    return 2;
}

std::terminate_handler usual_end = nullptr;

// Of a thread for which nobody catches. An arm fades once it hears nothing, what a joystick does ends by its own timer.
[[noreturn]] void end_without_memory() noexcept {
    try {
        if (const std::exception_ptr thrown = std::current_exception()) {
            std::rethrow_exception(thrown);
        }
    } catch (const std::bad_alloc&) {
        ::_exit(complain_of_memory());
    } catch (...) {
        usual_end();
    }
    std::abort();
}

}  // namespace
}  // namespace fulcrum::runtime

// Whatever was thrown has unwound by now, so that the force has faded. What was said must have arrived.
int main(int argc, char** argv) {
    using namespace fulcrum::runtime;
    usual_end = std::set_terminate(end_without_memory);
    int code = 2;
    try {
        code = run_program(argc, argv);
    } catch (const std::bad_alloc&) {
        return complain_of_memory();
    } catch (const std::exception& error) {
        return complain({std::string("the program cannot go on: ") + error.what(), {}, {}}, 2);
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        return complain(
            {"what the program said could not be written", "standard output", "make room there"},
            2);
    }
    return code;
}
