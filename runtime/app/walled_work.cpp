#include "runtime/app/walled_work.h"

#include "haptics/base/clock.h"
#include "haptics/base/sanitized.h"
#include "runtime/app/interrupt.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr int kOutOfMemory = 99;  // the work's own codes are smaller
constexpr int kFailed = 2;

// Past the first limit of time there is a signal with a name of its own, past the second one none survives.
void limit(decltype(RLIMIT_CPU) what, rlim_t most, rlim_t grace = 0) {
    const rlimit both{most, most + grace};
    (void)::setrlimit(what, &both);
}

[[noreturn]] void run_here(const WorkWalls& walls, const std::function<int(StageTeller&)>& work,
                           StageTeller& stages) {
    (void)::prctl(PR_SET_PDEATHSIG, SIGTERM);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(walls.cpu_s)), 2);
    if (!kSanitized) {
        limit(RLIMIT_AS, walls.address_bytes);
    }
    int code = kFailed;
    try {
        code = work(stages);
    } catch (const std::bad_alloc&) {
        code = kOutOfMemory;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
    (void)std::fflush(nullptr);
    ::_exit(code);
}

// Until it has ended. A wish that this process end is handed on, once.
int await(pid_t child) {
    constexpr std::chrono::milliseconds kLook{5};
    int status = 0;
    bool is_told = false;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (interrupted() && !is_told) {
            is_told = true;
            (void)::kill(child, SIGTERM);
        }
        std::this_thread::sleep_for(kLook);
    }
    return status;
}

}  // namespace

StageTeller::StageTeller(char* page, std::string subject)
    : page_(page),
      subject_(std::move(subject)),
      is_watched_(::isatty(STDERR_FILENO) == 1),
      began_s_(monotonic_now_s()) {
    *page_ = '\0';
}

void StageTeller::begin(const std::string& stage) {
    const std::size_t n = std::min(stage.size(), kMostBytes - 1);
    std::copy_n(stage.begin(), n, page_);
    page_[n] = '\0';
    if (is_watched_ && monotonic_now_s() - began_s_ > kTold_s) {
        std::fprintf(stderr, "%s: %s …\n", subject_.c_str(), stage.c_str());
    }
}

int run_walled(const std::string& subject, const WorkWalls& walls,
               const std::function<int(StageTeller&)>& work) {
    void* const page = ::mmap(nullptr, StageTeller::kMostBytes, PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) {
        std::fprintf(stderr, "%s: there is no memory left; close other programs.\n",
                     subject.c_str());
        return kFailed;
    }
    StageTeller stages(static_cast<char*>(page), subject);
    (void)std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        run_here(walls, work, stages);
    }
    if (child < 0) {
        std::fprintf(stderr, "%s: no process can be started: %s.\n", subject.c_str(),
                     std::strerror(errno));
        return kFailed;
    }
    const int status = await(child);
    const std::string stage = static_cast<const char*>(page);
    (void)::munmap(page, StageTeller::kMostBytes);
    if (interrupt_exit_code() != 0) {
        return interrupt_exit_code();
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) != kOutOfMemory) {
        return WEXITSTATUS(status);
    }
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    std::string why = "took more memory than " + std::to_string(walls.address_bytes >> 20) + " MB";
    if (signal == SIGXCPU) {
        why = "took more than " + std::to_string(static_cast<int>(walls.cpu_s)) +
              " s of processor time";
    } else if (signal == SIGKILL) {
        why = "was ended from outside, or for want of memory";
    } else if (signal != 0) {
        why = std::string("failed (") + ::strsignal(signal) + ")";
    }
    std::fprintf(stderr, "%s: %s: looking at this %s; leave parts of it away to find which one.\n",
                 subject.c_str(), stage.empty() ? "the whole" : stage.c_str(), why.c_str());
    return kFailed;
}

}  // namespace fulcrum::runtime
