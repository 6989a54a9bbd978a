#include "runtime/files/private_folder.h"

#include "runtime/files/other_writers.h"
#include "runtime/files/user_folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr mode_t kFileMode = 0600;
constexpr std::string_view kTemporaryEnding = ".tmp";
// So many unfinished files of a program's number and a file's name there never are.
constexpr int kMostTemporaries = 64;

class Descriptor {
  public:
    explicit Descriptor(int number) noexcept : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) {
            close(number_);
        }
    }
    [[nodiscard]] int number() const noexcept { return number_; }

  private:
    int number_;
};

std::string describe(const char* what, int error_number) {
    return std::string(what) + ": " + std::strerror(error_number);
}

// Goes on after a signal. 0, or the error's number.
int read_all(int descriptor, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::read(descriptor, bytes.data(), bytes.size());
        if (n < 0 && errno != EINTR) {
            return errno;
        }
        if (n == 0) {
            return EIO;  // it has become shorter
        }
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    }
    return 0;
}

// Likewise, and until it is on the disk.
int write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
        if (n < 0 && errno != EINTR) {
            return errno;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    }
    return fsync(descriptor) == 0 ? 0 : errno;
}

// 0, or the error's number: then a file of that name is another's, or there is none.
int write_new(int folder, const std::string& name, std::span<const std::byte> bytes) {
    const Descriptor file(openat(folder, name.c_str(),
                                 O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kFileMode));
    if (file.number() < 0) {
        return errno;
    }
    const int error_number = write_all(file.number(), bytes);
    if (error_number != 0) {
        unlinkat(folder, name.c_str(), 0);
    }
    return error_number;
}

// What is wrong with an opened folder, or null.
const char* find_fault(const struct stat& about) {
    if (about.st_uid != geteuid()) {
        return "this folder is another user's";
    }
    // Stricter than other_writers.h: here a key lies, and a group of the user's number may have members.
    return (about.st_mode & (S_IWGRP | S_IWOTH)) != 0 ? "others may write to this folder" : nullptr;
}

bool are_digits(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// Takes what follows the last dot off; nothing where there is no dot.
std::string_view take_ending(std::string_view& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos) {
        return {};
    }
    const std::string_view ending = name.substr(dot + 1);
    name.remove_suffix(name.size() - dot);
    return ending;
}

}  // namespace

std::string_view find_target_name(std::string_view temporary_name) noexcept {
    if (!temporary_name.ends_with(kTemporaryEnding)) {
        return {};
    }
    temporary_name.remove_suffix(kTemporaryEnding.size());
    const bool is_numbered =
        are_digits(take_ending(temporary_name)) && are_digits(take_ending(temporary_name));
    return is_numbered ? temporary_name : std::string_view{};
}

Expected<std::optional<PrivateFolder>> PrivateFolder::open(const std::filesystem::path& folder,
                                                           const char* what_to_do) {
    const int descriptor =
        ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0 && errno == ENOENT) {
        return std::nullopt;
    }
    if (descriptor < 0) {
        const int error_number = errno;
        struct stat about {};
        const bool is_link = lstat(folder.c_str(), &about) == 0 && S_ISLNK(about.st_mode);
        return fail(is_link ? "this is a link, where a folder should be"
                            : describe("this folder can't be opened", error_number),
                    folder.string(), what_to_do);
    }
    PrivateFolder opened(descriptor);
    struct stat about {};
    if (fstat(descriptor, &about) != 0) {
        return fail(describe("this folder can't be looked at", errno), folder.string(), what_to_do);
    }
    if (const char* fault = find_fault(about); fault != nullptr) {
        return fail(fault, folder.string(), what_to_do);
    }
    return opened;
}

Expected<PrivateFolder> PrivateFolder::create(const std::filesystem::path& folder,
                                              const char* what_to_do) {
    if (auto made = create_private_folders(folder, what_to_do); !made) {
        return tl::unexpected(made.error());
    }
    auto opened = open(folder, what_to_do);
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    if (!*opened) {
        return fail("this folder is gone again", folder.string(), what_to_do);
    }
    return std::move(**opened);
}

PrivateFolder::~PrivateFolder() {
    if (descriptor_ >= 0) {
        close(descriptor_);
    }
}

Expected<std::optional<std::vector<std::byte>>> PrivateFolder::read(
    const std::string& name, std::uint64_t most_bytes) const {
    const Descriptor file(
        openat(descriptor_, name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (file.number() < 0) {
        switch (errno) {
            case ENOENT:
                return std::nullopt;
            case ELOOP:
                return fail("this is a link, where a file should be");
            default:
                return fail(describe("this file can't be read", errno));
        }
    }
    struct stat about {};
    if (fstat(file.number(), &about) != 0 || !S_ISREG(about.st_mode) || about.st_uid != geteuid()) {
        return fail("this is no plain file of yours");
    }
    if (may_others_write(about)) {
        return fail("others may write to this file");
    }
    const auto n_bytes = static_cast<std::uint64_t>(about.st_size);
    if (n_bytes > most_bytes) {
        return fail("this file is longer than " + std::to_string(most_bytes) + " bytes");
    }
    std::vector<std::byte> bytes(static_cast<std::size_t>(n_bytes));
    if (const int error_number = read_all(file.number(), bytes); error_number != 0) {
        return fail(describe("this file can't be read", error_number));
    }
    // Where the time can't be set it counts as used longer ago.
    const std::array<timespec, 2> now{{{0, UTIME_NOW}, {0, UTIME_NOW}}};
    futimens(file.number(), now.data());
    return bytes;
}

// 0, or the error's number; then there is none.
int PrivateFolder::write_temporary(const std::string& name, std::span<const std::byte> bytes,
                                   std::string& temporary) const {
    const std::string begin = name + '.' + std::to_string(getpid()) + '.';
    int error_number = EEXIST;
    for (int n = 0; n < kMostTemporaries && error_number == EEXIST; ++n) {
        temporary = begin + std::to_string(n);
        temporary += kTemporaryEnding;
        error_number = write_new(descriptor_, temporary, bytes);
    }
    return error_number;
}

int PrivateFolder::create_file(const std::string& name, std::span<const std::byte> bytes) const {
    std::string temporary;
    if (const int error_number = write_temporary(name, bytes, temporary); error_number != 0) {
        return error_number;
    }
    // A second name is refused where it is taken, whole or not at all; a rename would put it over what is there.
    const bool is_made = linkat(descriptor_, temporary.c_str(), descriptor_, name.c_str(), 0) == 0;
    const int error_number = is_made ? 0 : errno;
    unlinkat(descriptor_, temporary.c_str(), 0);
    fsync(descriptor_);
    return error_number;
}

int PrivateFolder::replace(const std::string& name, std::span<const std::byte> bytes) const {
    std::string temporary;
    int error_number = write_temporary(name, bytes, temporary);
    if (error_number != 0) {
        return error_number;
    }
    if (renameat(descriptor_, temporary.c_str(), descriptor_, name.c_str()) != 0) {
        error_number = errno;
        unlinkat(descriptor_, temporary.c_str(), 0);
        return error_number;
    }
    fsync(descriptor_);
    return 0;
}

void PrivateFolder::remove(const std::string& name) const {
    unlinkat(descriptor_, name.c_str(), 0);
}

std::vector<FolderFile> PrivateFolder::list() const {
    std::vector<FolderFile> all;
    // A description of its own, so that it begins at the beginning.
    const int again = openat(descriptor_, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const std::unique_ptr<DIR, int (*)(DIR*)> entries(again < 0 ? nullptr : fdopendir(again),
                                                      closedir);
    while (entries) {
        const dirent* entry = readdir(entries.get());
        if (entry == nullptr) {
            break;
        }
        struct stat about {};
        if (fstatat(descriptor_, entry->d_name, &about, AT_SYMLINK_NOFOLLOW) == 0 &&
            S_ISREG(about.st_mode) && about.st_uid == geteuid()) {
            const auto since = std::chrono::seconds(about.st_mtim.tv_sec) +
                               std::chrono::duration_cast<std::chrono::system_clock::duration>(
                                   std::chrono::nanoseconds(about.st_mtim.tv_nsec));
            all.push_back({entry->d_name, std::chrono::system_clock::time_point(since),
                           static_cast<std::uint64_t>(about.st_size)});
        }
    }
    return all;
}

}  // namespace fulcrum::runtime
