#include "tests/system/progress/power_vfs.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace fulcrum::runtime::test {
namespace {

constexpr std::size_t kSector = 512;

using Bytes = std::vector<unsigned char>;

Bytes read_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write_file(const std::string& path, const Bytes& bytes) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

// One open file: sqlite's view first, the real layer's file right behind it in memory.
struct PowerFile {
    sqlite3_file base;
    PowerVfs* vfs;
    const std::string* path;  // null for a temporary file, which no power cut concerns
    sqlite3_file* real;
};

// sqlite's callbacks.
struct PowerVfsCalls {
    static PowerFile& of(sqlite3_file* file) { return *reinterpret_cast<PowerFile*>(file); }
    static sqlite3_file* real(sqlite3_file* file) { return of(file).real; }
    static PowerVfs& of(sqlite3_vfs* vfs) { return *static_cast<PowerVfs*>(vfs->pAppData); }

    static void note(PowerFile& file, PowerVfs::Pending pending) {
        if (file.path != nullptr) {
            file.vfs->disk_of(*file.path).pending.push_back(std::move(pending));
        }
    }

    static int close(sqlite3_file* file) { return real(file)->pMethods->xClose(real(file)); }

    static int read(sqlite3_file* file, void* into, int size, sqlite3_int64 offset) {
        if (const int code = of(file).vfs->strike(Operation::read); code != SQLITE_OK) {
            return code;
        }
        return real(file)->pMethods->xRead(real(file), into, size, offset);
    }

    static int write(sqlite3_file* file, const void* from, int size, sqlite3_int64 offset) {
        PowerFile& self = of(file);
        if (self.vfs->stops_now()) {
            return SQLITE_IOERR_WRITE;
        }
        const int code = self.vfs->strike(Operation::write);
        // A write that fails may have written its first half.
        const int written = code == SQLITE_OK ? size : size / 2;
        const auto* bytes = static_cast<const unsigned char*>(from);
        note(self, {PowerVfs::Pending::Kind::write, static_cast<std::size_t>(offset),
                    Bytes(bytes, bytes + written)});
        const int really = real(file)->pMethods->xWrite(real(file), from, written, offset);
        return code == SQLITE_OK ? really : code;
    }

    static int truncate(sqlite3_file* file, sqlite3_int64 size) {
        PowerFile& self = of(file);
        if (self.vfs->stops_now()) {
            return SQLITE_IOERR_TRUNCATE;
        }
        if (const int code = self.vfs->strike(Operation::truncate); code != SQLITE_OK) {
            return code;
        }
        note(self, {PowerVfs::Pending::Kind::truncate, static_cast<std::size_t>(size), {}});
        return real(file)->pMethods->xTruncate(real(file), size);
    }

    static int sync(sqlite3_file* file, int /*flags*/) {
        PowerFile& self = of(file);
        if (self.vfs->stops_now()) {
            return SQLITE_IOERR_FSYNC;
        }
        if (const int code = self.vfs->strike(Operation::sync); code != SQLITE_OK) {
            return code;
        }
        if (self.path != nullptr && !self.vfs->lies_) {
            PowerVfs::settle(self.vfs->disk_of(*self.path));
        }
        return SQLITE_OK;
    }

    static int file_size(sqlite3_file* file, sqlite3_int64* size) {
        return real(file)->pMethods->xFileSize(real(file), size);
    }
    static int lock(sqlite3_file* file, int level) {
        return real(file)->pMethods->xLock(real(file), level);
    }
    static int unlock(sqlite3_file* file, int level) {
        return real(file)->pMethods->xUnlock(real(file), level);
    }
    static int check_lock(sqlite3_file* file, int* taken) {
        return real(file)->pMethods->xCheckReservedLock(real(file), taken);
    }
    static int control(sqlite3_file* file, int operation, void* argument) {
        return real(file)->pMethods->xFileControl(real(file), operation, argument);
    }
    static int sector_size(sqlite3_file* file) {
        return real(file)->pMethods->xSectorSize(real(file));
    }
    static int characteristics(sqlite3_file* file) {
        return real(file)->pMethods->xDeviceCharacteristics(real(file));
    }
    static int shm_map(sqlite3_file* file, int page, int size, int extend, volatile void** memory) {
        if (const int code = of(file).vfs->strike(Operation::share); code != SQLITE_OK) {
            return code;
        }
        return real(file)->pMethods->xShmMap(real(file), page, size, extend, memory);
    }
    static int shm_lock(sqlite3_file* file, int offset, int count, int flags) {
        return real(file)->pMethods->xShmLock(real(file), offset, count, flags);
    }
    static void shm_barrier(sqlite3_file* file) { real(file)->pMethods->xShmBarrier(real(file)); }
    static int shm_unmap(sqlite3_file* file, int remove) {
        return real(file)->pMethods->xShmUnmap(real(file), remove);
    }

    static const sqlite3_io_methods& methods() {
        static const sqlite3_io_methods kMethods{2,
                                                 close,
                                                 read,
                                                 write,
                                                 truncate,
                                                 sync,
                                                 file_size,
                                                 lock,
                                                 unlock,
                                                 check_lock,
                                                 control,
                                                 sector_size,
                                                 characteristics,
                                                 shm_map,
                                                 shm_lock,
                                                 shm_barrier,
                                                 shm_unmap,
                                                 nullptr,
                                                 nullptr};
        return kMethods;
    }

    static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out) {
        PowerVfs& self = of(vfs);
        PowerFile& opened = of(file);
        opened.base.pMethods = nullptr;
        if (const int code = self.strike(Operation::open); code != SQLITE_OK) {
            return code;
        }
        const bool is_new = name != nullptr && !std::filesystem::exists(name);
        if (is_new && (flags & SQLITE_OPEN_CREATE) != 0 && self.stops_now()) {
            return SQLITE_CANTOPEN;
        }
        PowerVfs::Disk* disk = name == nullptr ? nullptr : &self.disk_of(name);
        opened.vfs = &self;
        opened.path = name == nullptr ? nullptr : &self.disks_.find(name)->first;
        opened.real = reinterpret_cast<sqlite3_file*>(&opened + 1);
        const int code = self.real_->xOpen(self.real_, name, opened.real, flags, out);
        if (code == SQLITE_OK) {
            opened.base.pMethods = &methods();
            if (is_new && disk != nullptr) {
                disk->pending.push_back({PowerVfs::Pending::Kind::create, 0, {}});
            }
        }
        return code;
    }

    static int remove(sqlite3_vfs* vfs, const char* name, int sync_folder) {
        PowerVfs& self = of(vfs);
        if (self.stops_now()) {
            return SQLITE_IOERR_DELETE;
        }
        if (const int code = self.strike(Operation::remove); code != SQLITE_OK) {
            return code;
        }
        PowerVfs::Disk& disk = self.disk_of(name);
        disk.pending.push_back({PowerVfs::Pending::Kind::remove, 0, {}});
        if (sync_folder != 0 && !self.lies_) {
            PowerVfs::settle(disk);
        }
        return self.real_->xDelete(self.real_, name, 0);
    }

    static int access(sqlite3_vfs* vfs, const char* name, int flags, int* result) {
        return of(vfs).real_->xAccess(of(vfs).real_, name, flags, result);
    }
    static int full_path(sqlite3_vfs* vfs, const char* name, int size, char* out) {
        return of(vfs).real_->xFullPathname(of(vfs).real_, name, size, out);
    }
};

PowerVfs::PowerVfs() : real_(sqlite3_vfs_find(nullptr)) {
    static int made = 0;
    name_ = "power" + std::to_string(++made);
    vfs_ = *real_;  // time, sleep, random numbers and the rest stay the real layer's
    vfs_.szOsFile = static_cast<int>(sizeof(PowerFile)) + real_->szOsFile;
    vfs_.pNext = nullptr;
    vfs_.zName = name_.c_str();
    vfs_.pAppData = this;
    vfs_.xOpen = PowerVfsCalls::open;
    vfs_.xDelete = PowerVfsCalls::remove;
    vfs_.xAccess = PowerVfsCalls::access;
    vfs_.xFullPathname = PowerVfsCalls::full_path;
    sqlite3_vfs_register(&vfs_, 0);
}

PowerVfs::~PowerVfs() {
    sqlite3_vfs_unregister(&vfs_);
}

void PowerVfs::reset() {
    disks_.clear();
    counts_.fill(0);
    fault_at_ = 0;
    fault_struck_ = false;
    lies_ = false;
    revive();
}

void PowerVfs::revive() noexcept {
    stop_at_ = 0;
    changes_ = 0;
}

void PowerVfs::fail_at(Operation operation, std::int64_t at, bool lasting, int code) noexcept {
    fault_ = operation;
    fault_at_ = at;
    fault_lasts_ = lasting;
    fault_code_ = code;
    fault_struck_ = false;
    counts_.fill(0);
}

int PowerVfs::strike(Operation operation) noexcept {
    const std::int64_t count = ++counts_[static_cast<std::size_t>(operation)];
    const bool due = fault_at_ > 0 && operation == fault_ &&
                     (count == fault_at_ || (fault_lasts_ && count > fault_at_));
    fault_struck_ = fault_struck_ || due;
    return due ? fault_code_ : SQLITE_OK;
}

bool PowerVfs::stops_now() noexcept {
    if (!stopped()) {
        ++changes_;
    }
    return stopped();
}

PowerVfs::Disk& PowerVfs::disk_of(const std::string& path) {
    const auto [place, is_new] = disks_.try_emplace(path);
    // What lay there before this layer saw it counts as synced.
    if (is_new && std::filesystem::exists(path)) {
        place->second.exists = true;
        place->second.bytes = read_file(path);
    }
    return place->second;
}

void PowerVfs::apply(const Pending& pending, Disk& disk) {
    switch (pending.kind) {
        case Pending::Kind::write:
            disk.bytes.resize(std::max(disk.bytes.size(), pending.offset + pending.bytes.size()));
            std::copy(pending.bytes.begin(), pending.bytes.end(),
                      disk.bytes.begin() + static_cast<std::ptrdiff_t>(pending.offset));
            break;
        case Pending::Kind::truncate:
            disk.bytes.resize(pending.offset);
            break;
        case Pending::Kind::create:
        case Pending::Kind::remove:
            disk.exists = pending.kind == Pending::Kind::create;
            disk.bytes.clear();
            break;
    }
}

void PowerVfs::settle(Disk& disk) {
    for (const Pending& pending : disk.pending) {
        apply(pending, disk);
    }
    disk.pending.clear();
}

void PowerVfs::lose(Disk& disk, CutStyle style, std::mt19937& random) const {
    for (Pending& pending : disk.pending) {
        const bool keep = style != CutStyle::drop && random() % 2 == 0;
        const bool is_entry =
            pending.kind == Pending::Kind::create || pending.kind == Pending::Kind::remove;
        if (is_entry && !keep) {
            break;  // later writes went to a file that no folder names
        }
        if (keep) {
            apply(pending, disk);
            continue;
        }
        if (style != CutStyle::garble || pending.kind != Pending::Kind::write) {
            continue;
        }
        for (std::size_t at = 0; at < pending.bytes.size(); at += kSector) {
            const std::size_t end = std::min(at + kSector, pending.bytes.size());
            Pending sector{Pending::Kind::write, pending.offset + at, {}};
            const auto first = pending.bytes.begin() + static_cast<std::ptrdiff_t>(at);
            sector.bytes.assign(first, pending.bytes.begin() + static_cast<std::ptrdiff_t>(end));
            const auto fate = random() % 3;
            if (fate == 0) {
                std::generate(sector.bytes.begin(), sector.bytes.end(),
                              [&] { return static_cast<unsigned char>(random()); });
            }
            if (fate != 1) {
                apply(sector, disk);
            }
        }
    }
    disk.pending.clear();
}

void PowerVfs::cut_power(CutStyle style, std::uint32_t seed) {
    std::mt19937 random(seed);
    for (auto& [path, disk] : disks_) {
        lose(disk, style, random);
        if (disk.exists) {
            write_file(path, disk.bytes);
        } else {
            std::filesystem::remove(path);
        }
        // The shared index is memory: after a cut its file holds anything.
        if (std::filesystem::exists(path + "-shm")) {
            write_file(path + "-shm", Bytes(32'768, static_cast<unsigned char>(random())));
        }
    }
    revive();
}

}  // namespace fulcrum::runtime::test
