// A file layer for sqlite that can lose power, be killed, and fail at a chosen operation.
//
// Files lie on the real disk as the page cache shows them. Beside each, memory holds what is certain: its bytes at the last
// sync, and in order every write, truncation, creation and removal since. At a power cut each of those is kept, dropped or
// garbled sector by sector, as a disk may do; a creation or removal is kept only if those before it are.
#pragma once

#include <sqlite3.h>

#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace fulcrum::runtime::test {

/// The operations that can be counted and made to fail.
enum class Operation : std::uint8_t { open, read, write, sync, truncate, remove, share, count_ };

/// What a power cut does to what was not synced.
enum class CutStyle : std::uint8_t {
    drop,   ///< all of it is lost
    pick,   ///< each operation is kept or lost
    garble  ///< each is kept, lost, or torn into sectors that are new, old or noise
};

class PowerVfs {
  public:
    /// Registers the layer with sqlite under `name()`.
    PowerVfs();
    PowerVfs(const PowerVfs&) = delete;
    PowerVfs& operator=(const PowerVfs&) = delete;
    ~PowerVfs();

    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    /// Forgets faults, counts, files and their pending operations; the power is on.
    void reset();

    /// From the `at`-th operation that changes the disk (from 1) nothing works any more.
    void stop_at(std::int64_t at) noexcept { stop_at_ = at; }
    [[nodiscard]] bool stopped() const noexcept { return stop_at_ > 0 && changes_ >= stop_at_; }
    /// Operations that changed the disk since `reset` or the last `stop_at`-free start.
    [[nodiscard]] std::int64_t changes() const noexcept { return changes_; }

    /// After the process was "killed": works again, the page cache is as it was left. All files must be closed.
    void revive() noexcept;
    /// The power was cut: decides what the disk holds, and works again. All files must be closed.
    void cut_power(CutStyle style, std::uint32_t seed);

    /// The `at`-th operation of a kind (from 1) returns `code`, and with `lasting` every later one too.
    void fail_at(Operation operation, std::int64_t at, bool lasting, int code) noexcept;
    /// True when the fault has struck.
    [[nodiscard]] bool fault_struck() const noexcept { return fault_struck_; }
    void clear_fault() noexcept { fault_at_ = 0; }

    /// With true, sync says that it worked and does nothing: a disk that lies.
    void lie_about_sync(bool lie) noexcept { lies_ = lie; }

  private:
    friend struct PowerVfsCalls;
    struct Pending {
        enum class Kind : std::uint8_t { write, truncate, create, remove };
        Kind kind = Kind::write;
        std::size_t offset = 0;  // or the new size
        std::vector<unsigned char> bytes;
    };
    struct Disk {
        bool exists = false;
        std::vector<unsigned char> bytes;
        std::vector<Pending> pending;
    };

    // The code of an injected fault, or SQLITE_OK.
    [[nodiscard]] int strike(Operation operation) noexcept;
    // Counts an operation that changes the disk; true when nothing works any more.
    [[nodiscard]] bool stops_now() noexcept;
    Disk& disk_of(const std::string& path);
    static void apply(const Pending& pending, Disk& disk);
    static void settle(Disk& disk);
    void lose(Disk& disk, CutStyle style, std::mt19937& random) const;

    sqlite3_vfs* real_;
    sqlite3_vfs vfs_{};
    std::string name_;
    std::map<std::string, Disk> disks_;
    std::int64_t stop_at_ = 0;
    std::int64_t changes_ = 0;
    Operation fault_ = Operation::open;
    std::int64_t fault_at_ = 0;
    bool fault_lasts_ = false;
    bool fault_struck_ = false;
    int fault_code_ = SQLITE_OK;
    bool lies_ = false;
    std::array<std::int64_t, static_cast<std::size_t>(Operation::count_)> counts_{};
};

}  // namespace fulcrum::runtime::test
