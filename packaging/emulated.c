// What a program for arm64 lacks under qemu's user emulation, supplied for the trial in cross_build.sh alone: loaded before the program's
// own libraries (LD_PRELOAD), part of no build. So what is tried is byte for byte what ships, and its sandbox is as it is.
//
// - The kernel starts no program of another architecture: the lesson's process is started through the emulator. It is told to list the
//   system calls that the process asks for (-strace), on standard error.
// - The emulator has no filter of system calls (seccomp): it is asked all the same, so that this stands in the list, and its refusal is
//   not told. Nothing is filtered; the script compares the list with what the filter allows.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { kMostArguments = 16 };

int posix_spawn(pid_t* pid, const char* path, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* attributes, char* const arguments[], char* const environment[]) {
    int (*spawn)(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*, char* const[], char* const[]) =
        dlsym(RTLD_NEXT, "posix_spawn");
    // The emulator started anew would take it for itself.
    char own[4096] = "";
    if (strcmp(path, "/proc/self/exe") == 0 && readlink(path, own, sizeof own - 1) > 0) {
        path = own;
    }
    char preload[4096];
    snprintf(preload, sizeof preload, "LD_PRELOAD=%s", getenv("LD_PRELOAD"));
    char* words[kMostArguments] = {"qemu-aarch64-static", "-strace", "-E", preload, "-0", arguments[0], (char*)path};
    int n = 7;
    for (char* const* argument = arguments + 1; *argument != NULL; ++argument) {
        if (n == kMostArguments - 1) {
            return E2BIG;
        }
        words[n++] = *argument;
    }
    return spawn(pid, "/usr/bin/qemu-aarch64-static", actions, attributes, words, environment);
}

long syscall(long number, ...) {
    long (*call)(long, ...) = dlsym(RTLD_NEXT, "syscall");
    va_list list;
    va_start(list, number);
    long a[6];
    for (int i = 0; i < 6; ++i) {
        a[i] = va_arg(list, long);
    }
    va_end(list);
    const long answer = call(number, a[0], a[1], a[2], a[3], a[4], a[5]);
    return number == SYS_seccomp && answer == -1 && errno == ENOSYS ? 0 : answer;
}

// The list needs standard error, which the lesson's process gives up.
int dup2(int from, int to) {
    const int is_lesson = strcmp(program_invocation_short_name, "fulcrum-lesson") == 0;
    return from == to || (is_lesson && to == STDERR_FILENO) ? to : dup3(from, to, 0);
}
