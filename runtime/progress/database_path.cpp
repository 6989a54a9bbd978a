#include "runtime/progress/database_path.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr mode_t kFolderMode = 0700;
constexpr mode_t kFileMode = 0600;
constexpr const char* kChooseAnother = "choose another file with --db, or make the folder writable";

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

// A new entry is only certain after its folder is synced. Folders that can't be opened for reading
// are left to the system: their entries are synced with the file on the usual file systems.
void sync_folder(const std::filesystem::path& folder) {
    const std::string name = folder.empty() ? "." : folder.string();
    const int descriptor = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        fsync(descriptor);
        close(descriptor);
    }
}

Expected<void> create_folders(const std::filesystem::path& folder) {
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
                        made.string(), kChooseAnother);
        }
        sync_folder(above);
    }
    return {};
}

}  // namespace

Expected<std::string> default_database_path() {
    std::filesystem::path data = environment("XDG_DATA_HOME");
    if (!data.is_absolute()) {
        const std::filesystem::path home = home_folder();
        if (!home.is_absolute()) {
            return fail("there is no home folder to keep progress in", {},
                        "name a file with --db, or set HOME");
        }
        data = home / ".local" / "share";
    }
    return (data / "fulcrum" / "progress.db").string();
}

Expected<void> create_private_file(const std::string& path) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (auto made = create_folders(folder); !made) {
        return made;
    }
    const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kFileMode);
    if (descriptor < 0) {
        if (errno == EEXIST) {
            return {};
        }
        return fail(std::string("this file can't be made: ") + std::strerror(errno), path,
                    kChooseAnother);
    }
    close(descriptor);
    sync_folder(folder);
    return {};
}

}  // namespace fulcrum::runtime
