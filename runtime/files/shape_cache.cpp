#include "runtime/files/shape_cache.h"

#include "runtime/files/user_folder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr mode_t kFileMode = 0600;
constexpr const char* kShapeEnding = ".shape";
constexpr const char* kTemporaryEnding = ".tmp";
constexpr const char* kNothingKept = "what took long to make is made again each time";
// So long no program writes one file.
constexpr auto kAbandoned = std::chrono::hours(1);

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

// Both go on after a signal. 0, or the error's number.
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

// To a new file that no other program or thread writes. 0, or the error's number; then there is no file.
int write_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    int error_number = 0;
    {
        const Descriptor file(
            open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kFileMode));
        error_number = file.number() < 0 ? errno : write_all(file.number(), bytes);
    }
    if (error_number != 0) {
        unlink(path.c_str());
    }
    return error_number;
}

struct Kept {
    std::filesystem::path path;
    std::filesystem::file_time_type used;
    std::uint64_t bytes = 0;
};

// The shapes of a folder; temporary files that nobody finished are removed.
std::vector<Kept> list(const std::filesystem::path& folder) {
    std::vector<Kept> all;
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
        std::error_code gone;
        const auto used = at->last_write_time(gone);
        const bool is_plain =
            !gone && at->symlink_status(gone).type() == std::filesystem::file_type::regular;
        const std::uint64_t bytes = is_plain ? at->file_size(gone) : 0;
        if (!is_plain || gone) {
            continue;
        }
        const std::filesystem::path ending = at->path().extension();
        if (ending == kShapeEnding) {
            all.push_back({at->path(), used, bytes});
        } else if (ending == kTemporaryEnding &&
                   std::filesystem::file_time_type::clock::now() - used > kAbandoned) {
            std::filesystem::remove(at->path(), gone);
        }
    }
    return all;
}

}  // namespace

Expected<std::filesystem::path> default_shape_cache_folder() {
    return find_user_folder("XDG_CACHE_HOME", ".cache", "set HOME").map([](const auto& folder) {
        return folder / "fulcrum" / "shapes";
    });
}

std::filesystem::path ShapeCache::path_of(const Digest& key) const {
    return settings_.folder / (to_hex(key) + kShapeEnding);
}

void ShapeCache::tell(const std::filesystem::path& path, const char* what, int error_number) {
    const std::string why =
        error_number == 0 ? "" : std::string(": ") + std::strerror(error_number);
    told_.push_back(to_sentence({what + why, path.string(), kNothingKept}));
}

std::optional<Bytes> ShapeCache::read(const Digest& key) {
    if (settings_.folder.empty()) {
        return std::nullopt;
    }
    const std::filesystem::path path = path_of(key);
    // Not even a pipe or another's link makes it wait or read elsewhere.
    const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (file.number() < 0) {
        if (errno != ENOENT) {
            tell(path, "this kept shape can't be read", errno);
        }
        return std::nullopt;
    }
    struct stat about {};
    if (fstat(file.number(), &about) != 0 || !S_ISREG(about.st_mode) || about.st_uid != geteuid() ||
        static_cast<std::uint64_t>(about.st_size) > settings_.most_file_bytes) {
        tell(path, "this kept shape is no plain file of yours or is too large", 0);
        return std::nullopt;
    }
    Bytes bytes(static_cast<std::size_t>(about.st_size));
    if (const int error_number = read_all(file.number(), bytes); error_number != 0) {
        tell(path, "this kept shape can't be read", error_number);
        return std::nullopt;
    }
    // Used now; where the time can't be set it goes the sooner.
    const std::array<timespec, 2> now{{{0, UTIME_NOW}, {0, UTIME_NOW}}};
    futimens(file.number(), now.data());
    return bytes;
}

void ShapeCache::write(const Digest& key, std::span<const std::byte> bytes) {
    if (settings_.folder.empty()) {
        return;
    }
    const std::filesystem::path path = path_of(key);
    if (bytes.size() > std::min(settings_.most_file_bytes, settings_.most_bytes)) {
        tell(path, "this shape is too large to be kept", 0);
        return;
    }
    if (const auto made = create_private_folders(settings_.folder, kNothingKept); !made) {
        told_.push_back(to_sentence(made.error()));
        return;
    }
    static std::atomic<unsigned> n_written{0};
    std::filesystem::path temporary = path;
    temporary += '.' + std::to_string(getpid()) + '.' + std::to_string(n_written.fetch_add(1)) +
                 kTemporaryEnding;
    int error_number = write_file(temporary, bytes);
    if (error_number == 0 && rename(temporary.c_str(), path.c_str()) != 0) {
        error_number = errno;
        unlink(temporary.c_str());
    }
    if (error_number != 0) {
        tell(path, "this shape can't be kept", error_number);
        return;
    }
    sync_folder(settings_.folder);
    trim();
}

void ShapeCache::forget(const Digest& key, const Error& why) {
    const std::filesystem::path path = path_of(key);
    told_.push_back(to_sentence({why.message, path.string(), why.what_to_do}));
    unlink(path.c_str());
}

void ShapeCache::trim() {
    std::vector<Kept> all = list(settings_.folder);
    std::uint64_t bytes = 0;
    for (const Kept& kept : all) {
        bytes += kept.bytes;
    }
    std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
    for (const Kept& kept : all) {
        if (bytes <= settings_.most_bytes) {
            break;
        }
        unlink(kept.path.c_str());
        bytes -= kept.bytes;
    }
}

Expected<DistanceField> recall_distance_field(ShapeCache& cache, const TriangleMesh& mesh,
                                              const VoxelFrame& frame,
                                              const DistanceFieldSettings& settings,
                                              const LoadProgress& progress) {
    const std::array<double, 9> numbers{frame.lower_O.x(),
                                        frame.lower_O.y(),
                                        frame.lower_O.z(),
                                        frame.voxel_m,
                                        static_cast<double>(frame.n_cells[0]),
                                        static_cast<double>(frame.n_cells[1]),
                                        static_cast<double>(frame.n_cells[2]),
                                        settings.band_voxels,
                                        settings.sheet_voxels};
    return recall(cache, compute_shape_key(ShapeKind::distance_field, mesh, numbers),
                  decode_distance_field,
                  [&] { return DistanceField::build(mesh, frame, settings, progress); });
}

Expected<VoxelGrid> recall_voxels(ShapeCache& cache, const TriangleMesh& mesh,
                                  const VoxeliseSettings& settings, const LoadProgress& progress) {
    const std::array<double, 3> numbers{settings.voxel_m,
                                        static_cast<double>(settings.offset_layers),
                                        static_cast<double>(settings.proximity_layers)};
    return recall(cache, compute_shape_key(ShapeKind::voxel_grid, mesh, numbers), decode_voxel_grid,
                  [&] { return voxelise(mesh, settings, progress); });
}

Expected<Pointshell> recall_surface_pointshell(ShapeCache& cache, const TriangleMesh& mesh,
                                               int n_points) {
    const std::array<double, 1> numbers{static_cast<double>(n_points)};
    return recall(cache, compute_shape_key(ShapeKind::pointshell, mesh, numbers), decode_pointshell,
                  [&] { return make_surface_pointshell(mesh, n_points); });
}

}  // namespace fulcrum::runtime
