#include "runtime/files/shape_cache.h"

#include "haptics/voxel/shape_fit.h"
#include "runtime/files/user_folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr std::string_view kShapeEnding = ".shape";
constexpr const char* kNothingKept = "what took long to make is made again each time";
// So long no program writes one file.
constexpr auto kAbandoned = std::chrono::hours(1);

std::string name_of(const Digest& key) {
    return to_hex(key).append(kShapeEnding);
}

bool is_shape_name(std::string_view name) {
    constexpr std::size_t kHexLetters = 2 * sizeof(Digest);
    return name.size() == kHexLetters + kShapeEnding.size() && name.ends_with(kShapeEnding) &&
           name.find_first_not_of("0123456789abcdef") == kHexLetters;
}

// The number that the system gives where there is no more room, or not for this user.
bool is_for_want_of_room(int error_number) {
    return error_number == ENOSPC || error_number == EDQUOT;
}

tl::unexpected<Error> refuse_other(const char* what) {
    return fail(std::string("the kept ") + what + " is not the one that was asked for", {},
                "it is made again");
}

bool are_alike(const VoxelFrame& a, const VoxelFrame& b) {
    return a.lower_O == b.lower_O && a.voxel_m == b.voxel_m && a.n_cells == b.n_cells;
}

}  // namespace

Expected<std::filesystem::path> default_shape_cache_folder() {
    return find_user_folder("XDG_CACHE_HOME", ".cache", "set HOME").map([](const auto& folder) {
        return folder / "fulcrum" / "shapes";
    });
}

void ShapeCache::tell(const std::string& name, const std::string& what) {
    told_.push_back(to_sentence({what, (settings_.folder / name).string(), kNothingKept}));
}

bool ShapeCache::open(bool is_made) {
    if (is_off_ || folder_) {
        return !is_off_;
    }
    Expected<std::optional<PrivateFolder>> opened =
        PrivateFolder::open(settings_.folder, kNothingKept);
    if (opened && !*opened && is_made) {
        opened = PrivateFolder::create(settings_.folder, kNothingKept);
    }
    if (!opened) {
        told_.push_back(to_sentence(opened.error()));
        is_off_ = true;
        return false;
    }
    folder_ = std::move(*opened);
    return folder_.has_value();
}

std::optional<Bytes> ShapeCache::read(const Digest& key) {
    if (!open(false)) {
        return std::nullopt;
    }
    auto bytes = folder_->read(name_of(key), settings_.most_file_bytes);
    if (!bytes) {
        tell(name_of(key), bytes.error().message);
        return std::nullopt;
    }
    counts_.n_read += *bytes ? 1 : 0;
    return std::move(*bytes);
}

void ShapeCache::write(const Digest& key, double took_s, std::uint64_t n_bytes,
                       const std::function<Bytes()>& make_bytes) {
    ++counts_.n_made;
    if (is_off_ || took_s < settings_.least_build_s) {
        return;
    }
    if (n_bytes > std::min(settings_.most_file_bytes, settings_.most_bytes)) {
        tell(name_of(key), "this shape is too large to be kept");
        return;
    }
    if (!open(true)) {
        return;
    }
    const Bytes bytes = make_bytes();
    int error_number = folder_->replace(name_of(key), bytes);
    if (is_for_want_of_room(error_number)) {
        trim(bytes.size());
        error_number = folder_->replace(name_of(key), bytes);
    }
    if (error_number != 0) {
        tell(name_of(key), std::string("this shape can't be kept: ") + std::strerror(error_number));
        // What comes after would only drive out what is kept.
        is_off_ = is_for_want_of_room(error_number);
        return;
    }
    ++counts_.n_kept;
    trim(0);
}

void ShapeCache::forget(const Digest& key, const Error& why) {
    ++counts_.n_refused;
    told_.push_back(
        to_sentence({why.message, (settings_.folder / name_of(key)).string(), why.what_to_do}));
    if (open(false)) {
        folder_->remove(name_of(key));
    }
}

// Removes what nobody finished, and the shapes unused for longest until those that are left are few enough and `to_free` bytes fewer.
void ShapeCache::trim(std::uint64_t to_free) {
    const auto now = std::chrono::system_clock::now();
    std::vector<FolderFile> shapes;
    std::uint64_t bytes = 0;
    for (FolderFile& file : folder_->list()) {
        if (is_shape_name(file.name)) {
            bytes += file.bytes;
            shapes.push_back(std::move(file));
        } else if (is_shape_name(find_target_name(file.name)) && now - file.used > kAbandoned) {
            folder_->remove(file.name);
        }
    }
    std::sort(shapes.begin(), shapes.end(),
              [](const FolderFile& a, const FolderFile& b) { return a.used < b.used; });
    const std::uint64_t most = std::min(settings_.most_bytes, bytes - std::min(bytes, to_free));
    for (const FolderFile& shape : shapes) {
        if (bytes <= most) {
            break;
        }
        folder_->remove(shape.name);
        bytes -= shape.bytes;
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
    const auto decode = [&](const Bytes& bytes, const Digest& key) {
        return decode_distance_field(bytes, key)
            .and_then([&](DistanceField field) -> Expected<DistanceField> {
                if (!are_alike(field.frame(), frame) ||
                    field.band_m() != settings.band_voxels * frame.voxel_m ||
                    field.sheet_m() != settings.sheet_voxels * frame.voxel_m ||
                    !can_be_of(field, mesh)) {
                    return refuse_other("distance field");
                }
                return field;
            });
    };
    return recall(cache, compute_shape_key(ShapeKind::distance_field, mesh, numbers), decode,
                  [&] { return DistanceField::build(mesh, frame, settings, progress); });
}

Expected<VoxelGrid> recall_voxels(ShapeCache& cache, const TriangleMesh& mesh,
                                  const VoxeliseSettings& settings, const LoadProgress& progress) {
    const std::array<double, 3> numbers{settings.voxel_m,
                                        static_cast<double>(settings.offset_layers),
                                        static_cast<double>(settings.proximity_layers)};
    const auto decode = [&](const Bytes& bytes, const Digest& key) {
        return decode_voxel_grid(bytes, key).and_then([&](VoxelGrid grid) -> Expected<VoxelGrid> {
            const auto frame = make_voxel_frame(mesh, settings);
            if (!frame || !are_alike(grid.frame, *frame) || !can_be_of(grid, mesh)) {
                return refuse_other("block of voxels");
            }
            return grid;
        });
    };
    return recall(cache, compute_shape_key(ShapeKind::voxel_grid, mesh, numbers), decode,
                  [&] { return voxelise(mesh, settings, progress); });
}

Expected<Pointshell> recall_surface_pointshell(ShapeCache& cache, const TriangleMesh& mesh,
                                               int n_points, const LoadProgress& progress) {
    const std::array<double, 1> numbers{static_cast<double>(n_points)};
    const auto decode = [&](const Bytes& bytes, const Digest& key) {
        return decode_pointshell(bytes, key)
            .and_then([&](Pointshell shell) -> Expected<Pointshell> {
                if (shell.size() != static_cast<std::size_t>(n_points) || !can_be_of(shell, mesh)) {
                    return refuse_other("pointshell");
                }
                return shell;
            });
    };
    return recall(cache, compute_shape_key(ShapeKind::pointshell, mesh, numbers), decode,
                  [&] { return make_surface_pointshell(mesh, n_points, progress); });
}

Expected<std::shared_ptr<const ContactLevels>> recall_contact_levels(
    ShapeCache& cache, const TriangleMesh& mesh, const ContactLevelSettings& settings,
    const LoadProgress& progress) {
    using Levels = std::shared_ptr<const ContactLevels>;
    const std::array<double, 1> numbers{settings.within_m};
    const auto decode = [&](const Bytes& bytes, const Digest& key) {
        return decode_contact_levels(bytes, key).and_then([&](Levels levels) -> Expected<Levels> {
            if (levels->settings().within_m != settings.within_m || !can_be_of(*levels, mesh)) {
                return refuse_other("tree of contact levels");
            }
            return levels;
        });
    };
    return recall(cache, compute_shape_key(ShapeKind::contact_levels, mesh, numbers), decode,
                  [&] { return ContactLevels::create(mesh, settings, progress); });
}

Expected<MeasuredSolid> recall_measured_solid(ShapeCache& cache, const TriangleMesh& mesh,
                                              const LoadProgress& progress) {
    const auto decode = [&](const Bytes& bytes, const Digest& key) {
        return decode_measured_solid(bytes, key)
            .and_then([&](const MeasuredSolid& solid) -> Expected<MeasuredSolid> {
                if (!can_be_of(solid, mesh)) {
                    return refuse_other("mass");
                }
                return solid;
            });
    };
    return recall(cache, compute_shape_key(ShapeKind::solid_moments, mesh, {}), decode,
                  [&] { return measure_solid(mesh, {}, progress); });
}

}  // namespace fulcrum::runtime
