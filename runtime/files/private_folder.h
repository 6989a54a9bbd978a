// A folder that is its user's alone, held open: its files are read, replaced and removed in the folder that was looked at, whatever
// somebody puts in its place meanwhile.
//
//   taken     a folder, no link to one, of the user who runs the program, that nobody else may write to
//   read      a plain file of that user's, no link to one, no longer than allowed, that nobody else may write to; a pipe makes nobody
//             wait
//   replace   to a new file NAME.PID.N.tmp, synced, then renamed: there is the old one, or the new one, or none, whenever a program
//             or a computer stops. A file that is there already by such a name is another program's, and is left alone
//
// Thread: one at a time an object; load.
#pragma once

#include "haptics/base/error.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

/// A plain file of the user's.
struct FolderFile {
    std::string name;
    std::chrono::system_clock::time_point used;  ///< read or written last
    std::uint64_t bytes = 0;
};

class PrivateFolder {
  public:
    /// Nothing where there is none. Refuses a link, what is no folder, another user's, and one that others may write to.
    [[nodiscard]] static Expected<std::optional<PrivateFolder>> open(
        const std::filesystem::path& folder, const char* what_to_do);
    /// Made with those above it where it is missing (mode 0700); refuses the same.
    [[nodiscard]] static Expected<PrivateFolder> create(const std::filesystem::path& folder,
                                                        const char* what_to_do);
    PrivateFolder(PrivateFolder&& other) noexcept
        : descriptor_(std::exchange(other.descriptor_, -1)) {}
    PrivateFolder& operator=(PrivateFolder&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~PrivateFolder();

    /// All of a file, which has been used now; nothing where there is none. The error says what is wrong with it, without place.
    [[nodiscard]] Expected<std::optional<std::vector<std::byte>>> read(
        const std::string& name, std::uint64_t most_bytes) const;
    /// 0, or the error's number: then all is as before.
    [[nodiscard]] int replace(const std::string& name, std::span<const std::byte> bytes) const;
    /// The same where there is no file of that name yet, whoever else is just making one: else EEXIST, and that one stays.
    [[nodiscard]] int create_file(const std::string& name, std::span<const std::byte> bytes) const;
    /// A file or link of that name goes, if there is one.
    void remove(const std::string& name) const;
    /// The user's plain files.
    [[nodiscard]] std::vector<FolderFile> list() const;

  private:
    [[nodiscard]] int write_temporary(const std::string& name, std::span<const std::byte> bytes,
                                      std::string& temporary) const;
    explicit PrivateFolder(int descriptor) noexcept : descriptor_(descriptor) {}
    int descriptor_;
};

/// For the name of a file that `replace` is writing, or never finished, the name that it would get; else empty.
[[nodiscard]] std::string_view find_target_name(std::string_view temporary_name) noexcept;

}  // namespace fulcrum::runtime
