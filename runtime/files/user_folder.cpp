#include "runtime/files/user_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <pwd.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr mode_t kFolderMode = 0700;

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string{} : std::string(value);
}

std::string home_folder() {
    std::string home = environment("HOME");
    if (home.empty()) {
        const passwd* user = getpwuid(getuid());
        home = user == nullptr ? "" : user->pw_dir;
    }
    return home;
}

}  // namespace

Expected<std::filesystem::path> find_user_folder(const char* variable, const char* below_home,
                                                 const char* what_to_do) {
    std::filesystem::path folder = environment(variable);
    if (!folder.is_absolute()) {
        const std::filesystem::path home = home_folder();
        if (!home.is_absolute()) {
            return fail("there is no home folder", {}, what_to_do);
        }
        folder = home / below_home;
    }
    return folder;
}

void sync_folder(const std::filesystem::path& folder) {
    const std::string name = folder.empty() ? "." : folder.string();
    const int descriptor = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        fsync(descriptor);
        close(descriptor);
    }
}

Expected<void> create_private_folders(const std::filesystem::path& folder, const char* what_to_do) {
    std::filesystem::path made;
    for (const std::filesystem::path& part : folder) {
        const std::filesystem::path above = made;
        made /= part;
        std::error_code ignored;
        if (std::filesystem::is_directory(made, ignored)) {
            continue;
        }
        if (mkdir(made.c_str(), kFolderMode) != 0 && errno != EEXIST) {
            return fail(std::string("this folder can't be made: ") + std::strerror(errno),
                        made.string(), what_to_do);
        }
        sync_folder(above);
    }
    return {};
}

}  // namespace fulcrum::runtime
