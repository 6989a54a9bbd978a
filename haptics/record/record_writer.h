// Writes a record while the run goes on. Bytes only ever go to the end, a block at a time, so that a
// cut-off file keeps all whole blocks.
//
// Thread: one that is not the haptic thread; it takes samples from the ring (`drain`) or is given them.
// Cost: a copy a sample, a write every kRecordBlockSamples samples.
#pragma once

#include "haptics/base/error.h"
#include "haptics/handover/channels.h"
#include "haptics/handover/told.h"
#include "haptics/record/record.h"

#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace fulcrum {

/// Turns a run into the bytes of a record; the caller takes them where it likes.
class RecordEncoder {
  public:
    /// Puts the header at the front of the bytes.
    explicit RecordEncoder(const RecordHeader& header);

    /// Adds one round of the haptic loop; every kRecordBlockSamples of them close a block. `shares_W`: what each effect of the
    /// header adds to its force; those that are missing are zero.
    void append(const RecordSample& sample, std::span<const Wrench> shares_W = {}) {
        append(0, sample, shares_W);
    }
    void append(const RecordRound& round) { append(0, round); }
    /// The same of hand `hand`, 0 for the first; of one that the header has not nothing is kept.
    void append(std::size_t hand, const RecordSample& sample,
                std::span<const Wrench> shares_W = {});
    void append(std::size_t hand, const RecordRound& round);
    /// Adds an event; it is written when the next block of samples closes.
    void append(const RecordEvent& event);
    /// Adds where a body was found; written like an event.
    void append(const RecordBody& body);
    /// Adds what the loop of a hand was told in a round: one of those types that RecordToldKind names. Written like an event.
    template <class T>
    void append(std::size_t hand, const Told<T>& told);
    /// Closes the blocks that are open. Use it rarely: where blocks end is part of the bytes.
    void close_blocks();
    /// Closes the record; nothing may be appended after it.
    void finish();
    /// The bytes made since the last call.
    [[nodiscard]] std::vector<std::byte> take_bytes();

  private:
    void put_block(std::uint32_t kind, const std::vector<std::byte>& payload);

    // The samples of a hand's open block.
    struct Hand {
        std::size_t n_effects = 0;
        std::vector<std::byte> bytes{};
        std::size_t n_open = 0;
        std::uint64_t n_samples = 0;
        std::vector<std::byte> told{};  // of an open block
    };

    std::vector<std::byte> bytes_;
    std::vector<Hand> hands_;  // the first, and the others
    std::vector<std::byte> events_;
    std::vector<std::byte> bodies_;
    std::uint64_t n_events_ = 0;
    std::uint64_t n_bodies_ = 0;
    std::uint64_t n_told_ = 0;
};

/// A record in a file.
class RecordWriter {
  public:
    /// Makes the file at `path`, its owner's alone to read, or says why not; an older one is replaced.
    [[nodiscard]] static Expected<RecordWriter> create(const std::string& path,
                                                       const RecordHeader& header);
    RecordWriter(RecordWriter&&) noexcept = default;
    RecordWriter& operator=(RecordWriter&&) noexcept = default;
    /// Closes the file; without `finish` it stays a cut-off one.
    ~RecordWriter() = default;

    /// Adds everything that waits in the ring. The ring's only consumer.
    [[nodiscard]] Expected<void> drain(RecordRing& ring);
    [[nodiscard]] Expected<void> append(const RecordRound& round) { return append(0, round); }
    /// Of hand `hand`, 0 for the first.
    [[nodiscard]] Expected<void> append(std::size_t hand, const RecordRound& round);
    [[nodiscard]] Expected<void> append(const RecordEvent& event);
    [[nodiscard]] Expected<void> append(const RecordBody& body);
    template <class T>
    [[nodiscard]] Expected<void> append(std::size_t hand, const Told<T>& told) {
        encoder_.append(hand, told);
        return write_out();
    }
    /// Writes the end and closes the file.
    [[nodiscard]] Expected<void> finish();

  private:
    struct CloseFile {
        void operator()(std::FILE* file) const noexcept { (void)std::fclose(file); }
    };
    RecordWriter(std::string path, std::FILE* file, const RecordHeader& header);
    [[nodiscard]] Expected<void> write_out();

    std::string path_;
    std::unique_ptr<std::FILE, CloseFile> file_;
    RecordEncoder encoder_;
};

}  // namespace fulcrum
