#include "runtime/audio/openal/quiet_backends.h"

#include <cstdlib>
#include <dlfcn.h>

namespace fulcrum::runtime {
namespace {

/// The type of ALSA's error handler (alsa/error.h): file, line, function, error number, printf
/// format and arguments.
using AlsaErrorHandler = void (*)(const char*, int, const char*, int, const char*, ...);

void say_nothing(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/,
                 const char* /*format*/, ...) {}

bool quieten_once() {
    constexpr int kKeepUsersChoice = 0;
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

}  // namespace

void quieten_backends() {
    static const bool done = quieten_once();
    static_cast<void>(done);
}

}  // namespace fulcrum::runtime
