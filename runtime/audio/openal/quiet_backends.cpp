#include "runtime/audio/openal/quiet_backends.h"

#include <cstdlib>
#include <dlfcn.h>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

/// The type of ALSA's error handler (alsa/error.h): file, line, function, error number, printf
/// format and arguments.
using AlsaErrorHandler = void (*)(const char*, int, const char*, int, const char*, ...);

void say_nothing(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/,
                 const char* /*format*/, ...) {}

constexpr int kKeepUsersChoice = 0;
constexpr std::string_view kShortPeriods = "[general]\nperiod_size = 256\nperiods = 3\n";

bool quieten_once() {
    ::setenv("ALSOFT_LOGLEVEL", "0", kKeepUsersChoice);
    // The handle stays open: the library must keep its handler for as long as OpenAL may use it.
    if (void* alsa = ::dlopen("libasound.so.2", RTLD_LAZY | RTLD_LOCAL)) {
        using SetHandler = int (*)(AlsaErrorHandler);
        if (auto set = reinterpret_cast<SetHandler>(::dlsym(alsa, "snd_lib_error_set_handler"))) {
            set(&say_nothing);
        }
    }
    return true;
}

bool shorten_once() {
    const int file = ::memfd_create("fulcrum-openal", MFD_CLOEXEC);
    if (file < 0) {
        return false;
    }
    // Stays open for as long as the process runs; without it sound is late, no more.
    if (::write(file, kShortPeriods.data(), kShortPeriods.size()) ==
        static_cast<ssize_t>(kShortPeriods.size())) {
        ::setenv("ALSOFT_CONF", ("/proc/self/fd/" + std::to_string(file)).c_str(),
                 kKeepUsersChoice);
    }
    return true;
}

}  // namespace

void quieten_backends() {
    static const bool done = quieten_once();
    static_cast<void>(done);
}

void ask_for_short_periods() {
    static const bool done = shorten_once();
    static_cast<void>(done);
}

}  // namespace fulcrum::runtime
