#include "runtime/scene/gltf/model_files.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fulcrum::runtime::gltf {
namespace {

int hex_digit(char c) {
    if (c >= '0' && c <= '9') {
        return c - '0';
    }
    const char lower = static_cast<char>(c | 0x20);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

std::string decode_percent(std::string_view uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool escape = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 &&
                            hex_digit(uri[i + 2]) >= 0;
        if (escape) {
            name += static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2]));
            i += 2;
        } else {
            name += uri[i];
        }
    }
    return name;
}

/// Closes a file descriptor when it goes.
struct Descriptor {
    int fd;
    explicit Descriptor(int opened) : fd(opened) {}
    ~Descriptor() {
        if (fd >= 0) {
            ::close(fd);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
};

}  // namespace

Expected<std::string> plain_file_name(std::string_view uri) {
    std::string name = decode_percent(uri);
    const bool odd_character = std::any_of(name.begin(), name.end(), [](char c) {
        return c == '/' || c == '\\' || c == ':' || static_cast<unsigned char>(c) < 0x20;
    });
    if (name.empty() || name == "." || name == ".." || odd_character || name.size() > 255) {
        return fail("it names a file that does not lie in its own folder", {},
                    "embed pictures and buffers, or keep them beside the model");
    }
    return name;
}

Expected<Bytes> read_regular_file(const std::filesystem::path& path, std::size_t limit_bytes,
                                  bool follow_links) {
    const std::string name = path.filename().string().substr(0, 80);
    const int flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | (follow_links ? 0 : O_NOFOLLOW);
    const Descriptor file(::open(path.c_str(), flags));
    struct stat status {};
    if (file.fd < 0 || ::fstat(file.fd, &status) != 0) {
        const std::string why = errno == ELOOP ? "is a link" : std::strerror(errno);
        return fail("the file " + name + " cannot be read (" + why + ")", {},
                    "put the file there or mend the path");
    }
    if (!S_ISREG(status.st_mode)) {
        return fail(name + " is not a file", {}, "name a model file");
    }
    if (static_cast<std::uintmax_t>(status.st_size) > limit_bytes) {
        return fail(
            "the file " + name + " is larger than " + std::to_string(limit_bytes >> 20) + " MiB",
            {}, "reduce its triangles and pictures");
    }

    Bytes bytes(static_cast<std::size_t>(status.st_size));
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ::ssize_t got = ::read(file.fd, bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got <= 0) {
            return fail("the file " + name + " cannot be read to its end", {}, "copy it again");
        }
        done += static_cast<std::size_t>(got);
    }
    return bytes;
}

}  // namespace fulcrum::runtime::gltf
