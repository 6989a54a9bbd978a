#include "runtime/lua/sandbox/sandbox.h"

#include "haptics/base/sanitized.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <grp.h>
#include <linux/audit.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kThisArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kThisArchitecture = AUDIT_ARCH_AARCH64;
#else
#error "the filter of system calls is written for x86-64 and aarch64"
#endif

constexpr std::uint32_t kX32Bit =
    0x4000'0000;  // x86-64 numbers with this bit are another calling convention
constexpr rlim_t kStackBytes = 8U << 20U;
constexpr uid_t kNobody = 65534;

tl::unexpected<Wall> refused(Wall wall) {
    return tl::unexpected<Wall>(wall);
}

// ---- the filter, as a list of small blocks
// ----------------------------------------------------------------------

using Filter = std::vector<sock_filter>;

void add(Filter& filter, int code, std::uint32_t k, std::uint8_t if_true = 0,
         std::uint8_t if_false = 0) {
    filter.push_back(sock_filter{static_cast<std::uint16_t>(code), if_true, if_false, k});
}

constexpr std::uint32_t kNumberOffset = offsetof(seccomp_data, nr);
constexpr std::uint32_t low_word_of_argument(int i) {
    return static_cast<std::uint32_t>(offsetof(seccomp_data, args)) +
           static_cast<std::uint32_t>(i) * 8U;  // little endian
}

/// The number of the call is in the accumulator before and after each block.
void allow(Filter& filter, long number) {
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(number), 0, 1);
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
}

/// Allowed when the argument equals `value`, kills otherwise.
void allow_if_equal(Filter& filter, long number, int argument, std::uint32_t value) {
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(number), 0, 4);
    add(filter, BPF_LD | BPF_W | BPF_ABS, low_word_of_argument(argument));
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1);
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
}

/// Allowed when the argument has all of `must` and none of `must_not`, kills otherwise.
void allow_if_bits(Filter& filter, long number, int argument, std::uint32_t must,
                   std::uint32_t must_not) {
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(number), 0, 5);
    add(filter, BPF_LD | BPF_W | BPF_ABS, low_word_of_argument(argument));
    add(filter, BPF_ALU | BPF_AND | BPF_K, must | must_not);
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, must, 0, 1);
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
}

/// mmap has two arguments to check: memory without a file, and nothing executable.
void allow_plain_mmap(Filter& filter) {
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(SYS_mmap), 0, 6);
    add(filter, BPF_LD | BPF_W | BPF_ABS, low_word_of_argument(2));
    add(filter, BPF_JMP | BPF_JSET | BPF_K, PROT_EXEC, 3, 0);
    add(filter, BPF_LD | BPF_W | BPF_ABS, low_word_of_argument(3));
    add(filter, BPF_JMP | BPF_JSET | BPF_K, MAP_ANONYMOUS, 0, 1);
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
}

Filter make_filter(int socket) {
    Filter filter;
    // Another architecture's numbers mean other calls.
    add(filter, BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offsetof(seccomp_data, arch)));
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, kThisArchitecture, 1, 0);
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
    add(filter, BPF_LD | BPF_W | BPF_ABS, kNumberOffset);
    add(filter, BPF_JMP | BPF_JGE | BPF_K, kX32Bit, 0, 1);
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
    // The one socket.
    if (kSanitized) {
        allow(filter, SYS_write);  // a sanitizer's findings go to standard error
    }
    allow_if_equal(filter, SYS_sendto, 0, static_cast<std::uint32_t>(socket));
    allow_if_equal(filter, SYS_read, 0, static_cast<std::uint32_t>(socket));
    // Memory, never executable, never a file.
    allow_plain_mmap(filter);
    allow_if_bits(filter, SYS_mprotect, 2, 0, PROT_EXEC);
    for (const long number : {SYS_munmap, SYS_mremap, SYS_brk, SYS_madvise}) {
        allow(filter, number);
    }
    // What the C library needs to compute and to end.
    for (const long number : {SYS_futex, SYS_clock_gettime, SYS_exit, SYS_exit_group,
                              SYS_rt_sigreturn, SYS_restart_syscall}) {
        allow(filter, number);
    }
    if (kSanitized) {
        for (const long number :
             {SYS_getpid, SYS_gettid, SYS_sched_yield, SYS_rt_sigprocmask, SYS_sigaltstack}) {
            allow(filter, number);
        }
    }
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
    return filter;
}

// ---- the other walls
// ----------------------------------------------------------------------------------------------

/// Bytes of address space this process has mapped; 0 when unknown.
std::size_t mapped_bytes() {
    std::size_t pages = 0;
    if (FILE* statm = std::fopen("/proc/self/statm", "re"); statm != nullptr) {
        if (std::fscanf(statm, "%zu", &pages) != 1) {
            pages = 0;
        }
        std::fclose(statm);
    }
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

Walled<void> set_limits(std::size_t more_memory_bytes) {
    struct Limit {
        __rlimit_resource_t resource;
        rlim_t value;
    };
    std::vector<Limit> limits = {{RLIMIT_CORE, 0},  {RLIMIT_FSIZE, 0},   {RLIMIT_NOFILE, 0},
                                 {RLIMIT_NPROC, 0}, {RLIMIT_MEMLOCK, 0}, {RLIMIT_MSGQUEUE, 0}};
    const std::size_t mapped = mapped_bytes();
    if (!kSanitized) {
        if (mapped == 0) {
            return refused(Wall::memory);
        }
        limits.push_back({RLIMIT_AS, mapped + more_memory_bytes});
        limits.push_back({RLIMIT_STACK, kStackBytes});
    }
    for (const Limit& limit : limits) {
        // Whoever started the program may have set a lower one, which nobody can raise.
        rlimit inherited{};
        if (getrlimit(limit.resource, &inherited) != 0) {
            return refused(Wall::limits);
        }
        const rlim_t value = std::min(limit.value, inherited.rlim_max);
        const rlimit both{value, value};
        if (setrlimit(limit.resource, &both) != 0) {
            return refused(Wall::limits);
        }
    }
    return {};
}

/// Root's rights are given up; a plain user has none to give.
Walled<void> drop_rights() {
    if (geteuid() != 0) {
        return {};
    }
    if (setgroups(0, nullptr) != 0 || setresgid(kNobody, kNobody, kNobody) != 0 ||
        setresuid(kNobody, kNobody, kNobody) != 0) {
        // In a container that maps no such user the capabilities still go.
        if (errno != EINVAL && errno != EPERM) {
            return refused(Wall::rights);
        }
    }
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    const std::array<__user_cap_data_struct, 2> none{};
    if (syscall(SYS_capset, &header, none.data()) != 0) {
        return refused(Wall::rights);
    }
    return {};
}

}  // namespace

const char* wall_text(Wall wall) {
    switch (wall) {
        case Wall::page:
            return "the system gives it no page to share with the program (mmap)";
        case Wall::files:
            return "the system can't close its files (close_range)";
        case Wall::memory:
            return "the system doesn't say how much memory is in use (/proc/self/statm)";
        case Wall::limits:
            return "the system sets no limits on it (setrlimit)";
        case Wall::rights:
            return "the rights of root can't be given up (setresuid, capset)";
        case Wall::no_new_rights:
            return "the system doesn't keep it from getting new rights (prctl)";
        case Wall::filter:
            return "the system can't filter system calls (seccomp)";
    }
    return "";
}

Walled<void> close_all_files_but(int keep, int keep_too) {
    const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nothing < 0) {
        return refused(Wall::files);
    }
    const int last_standard = kSanitized ? STDOUT_FILENO : STDERR_FILENO;
    for (int file = STDIN_FILENO; file <= last_standard; ++file) {
        if (dup2(nothing, file) < 0) {
            return refused(Wall::files);
        }
    }
    // Everything from 3 up, in the gaps round the two that stay.
    const auto low = static_cast<unsigned>(keep < keep_too ? keep : keep_too);
    const auto high = static_cast<unsigned>(keep < keep_too ? keep_too : keep);
    const std::array<std::array<unsigned, 2>, 3> gaps = {
        {{3U, low - 1U}, {low + 1U, high - 1U}, {high + 1U, ~0U}}};
    for (const auto& gap : gaps) {
        if (gap[0] <= gap[1] && syscall(SYS_close_range, gap[0], gap[1], 0U) != 0) {
            return refused(Wall::files);
        }
    }
    return {};
}

Walled<void> enter_sandbox(const SandboxSettings& settings) {
    if (auto limited = set_limits(settings.more_memory_bytes); !limited) {
        return limited;
    }
    if (auto dropped = drop_rights(); !dropped) {
        return dropped;
    }
    // After the change of user, which forgets the first of these.
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || prctl(PR_SET_DUMPABLE, 0) != 0 ||
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
        return refused(Wall::no_new_rights);
    }
    Filter filter = make_filter(settings.socket);
    const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    if (syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) != 0) {
        return refused(Wall::filter);
    }
    return {};
}

}  // namespace fulcrum::runtime
