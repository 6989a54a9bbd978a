#include "runtime/progress/database_path.h"

#include "runtime/files/user_folder.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr mode_t kFileMode = 0600;
constexpr const char* kChooseAnother = "choose another file with --db, or make the folder writable";

}  // namespace

Expected<std::string> default_database_path() {
    const auto data =
        find_user_folder("XDG_DATA_HOME", ".local/share", "name a file with --db, or set HOME");
    if (!data) {
        return tl::unexpected(data.error());
    }
    return (*data / "fulcrum" / "progress.db").string();
}

Expected<void> create_private_file(const std::string& path) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (auto made = create_private_folders(folder, kChooseAnother); !made) {
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
