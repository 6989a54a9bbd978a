// Stands before the clock of the wall, which somebody sets: by $CLOCK_SET_BY seconds, from its tenth reading on.
#include <atomic>
#include <cstdlib>
#include <ctime>
#include <dlfcn.h>

extern "C" int clock_gettime(clockid_t clock, timespec* time) {
    using Read = int (*)(clockid_t, timespec*);
    static const auto kRead = reinterpret_cast<Read>(dlsym(RTLD_NEXT, "clock_gettime"));
    static std::atomic<int> n_readings{0};
    const int code = kRead(clock, time);
    const char* const by = std::getenv("CLOCK_SET_BY");
    if (clock == CLOCK_REALTIME && by != nullptr && n_readings.fetch_add(1) >= 10) {
        time->tv_sec += std::atol(by);
    }
    return code;
}

extern "C" time_t time(time_t* seconds) {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    if (seconds != nullptr) {
        *seconds = now.tv_sec;
    }
    return now.tv_sec;
}
