#include "runtime/link/arm_key.h"

#include "runtime/files/private_folder.h"
#include "runtime/files/user_folder.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <sys/stat.h>

namespace fulcrum::runtime {
namespace {

constexpr const char* kKeyAgain =
    "remove it, and the next start makes a new one; then copy that to the arm's computer";

constexpr std::uint64_t kMostKeyBytes = 1024;

// 0 to 15, or -1.
int figure(char letter) noexcept {
    if (letter >= '0' && letter <= '9') {
        return letter - '0';
    }
    return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}

std::string written(const ArmKey& key) {
    constexpr const char* kFigures = "0123456789abcdef";
    std::string text;
    for (const std::byte byte : key) {
        text += kFigures[std::to_integer<unsigned>(byte >> 4)];
        text += kFigures[std::to_integer<unsigned>(byte & std::byte{15})];
    }
    return text + '\n';
}

Expected<ArmKey> parse(const std::vector<std::byte>& bytes, const std::string& where) {
    ArmKey key;
    const bool is_long_enough =
        bytes.size() == 2 * key.size() ||
        (bytes.size() == 2 * key.size() + 1 && bytes.back() == std::byte{'\n'});
    for (std::size_t i = 0; is_long_enough && i < key.size(); ++i) {
        const int high = figure(static_cast<char>(bytes[2 * i]));
        const int low = figure(static_cast<char>(bytes[2 * i + 1]));
        if (high < 0 || low < 0) {
            return fail("this is no key: 64 of 0-9 and a-f are one", where, kKeyAgain);
        }
        key[i] = static_cast<std::byte>(16 * high + low);
    }
    return is_long_enough ? Expected<ArmKey>(key)
                          : Expected<ArmKey>(fail("this is no key: 64 of 0-9 and a-f are one",
                                                  where, kKeyAgain));
}

}  // namespace

Expected<std::filesystem::path> find_arm_key_file(const std::string& given) {
    if (!given.empty()) {
        return std::filesystem::path(given);
    }
    return find_user_folder("XDG_CONFIG_HOME", ".config", "set HOME, or give --key FILE")
        .map([](const std::filesystem::path& folder) { return folder / "fulcrum" / "arm.key"; });
}

Expected<ArmKey> load_or_make_arm_key(const std::filesystem::path& file) {
    const std::filesystem::path parent = file.has_parent_path() ? file.parent_path() : ".";
    auto folder = PrivateFolder::create(parent, "give --key a file in a folder of your own");
    if (!folder) {
        return tl::unexpected(folder.error());
    }
    auto bytes = folder->read(file.filename(), kMostKeyBytes);
    if (bytes && !*bytes) {
        const ArmKey key = draw_arm_key();
        const std::string text = written(key);
        const int error = folder->create_file(file.filename(), std::as_bytes(std::span(text)));
        if (error == 0) {
            return key;
        }
        if (error != EEXIST) {
            return fail(std::string("the arm's key cannot be written: ") + std::strerror(error),
                        file.string(), "make room there, or give --key another file");
        }
        // Another program has just made one: that is the key of both.
        bytes = folder->read(file.filename(), kMostKeyBytes);
    }
    if (!bytes || !*bytes) {
        return fail(bytes ? "the arm's key is gone again" : bytes.error().message, file.string(),
                    kKeyAgain);
    }
    struct stat about {};
    if (::lstat(file.c_str(), &about) != 0 || (about.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
        return fail("others may read the arm's key, so it keeps nobody out", file.string(),
                    "chmod 600 it, or remove it and have a new one made");
    }
    return parse(**bytes, file.string());
}

}  // namespace fulcrum::runtime
