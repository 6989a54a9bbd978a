#include "runtime/scene/gltf/deflate_length.h"

#include <algorithm>
#include <array>
#include <vector>

namespace fulcrum::runtime::gltf {
namespace {

constexpr int kMaxCodeLength = 15;
constexpr std::size_t kLiteralCodes = 288;
constexpr std::size_t kDistanceCodes = 32;
constexpr std::uint32_t kEndOfBlock = 256;

/// Bits from the lowest of each byte upwards; past the end it hands out zeros and remembers.
class BitReader {
  public:
    explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    std::uint32_t bits(int n) {
        while (held_ < n) {
            value_ |= static_cast<std::uint64_t>(next_byte()) << held_;
            held_ += 8;
        }
        const auto result = static_cast<std::uint32_t>(value_ & ((std::uint64_t{1} << n) - 1));
        value_ >>= n;
        held_ -= n;
        return result;
    }

    void to_byte() {
        value_ >>= held_ % 8;
        held_ -= held_ % 8;
    }

    /// Skips whole bytes; to be called at a byte's beginning.
    void skip_bytes(std::size_t n) {
        for (; n > 0 && held_ > 0; --n) {
            bits(8);
        }
        overrun_ = overrun_ || n > bytes_.size() - at_;
        at_ = std::min(bytes_.size(), at_ + n);
    }

    [[nodiscard]] bool overrun() const { return overrun_; }

  private:
    std::uint8_t next_byte() {
        if (at_ == bytes_.size()) {
            overrun_ = true;
            return 0;
        }
        return bytes_[at_++];
    }

    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
    std::uint64_t value_ = 0;
    int held_ = 0;
    bool overrun_ = false;
};

/// A canonical Huffman code: symbols in order of length, and how many there are of each length.
class HuffmanCode {
  public:
    /// False when more codes are asked for than the lengths have room for.
    bool build(std::span<const std::uint8_t> lengths) {
        counts_.fill(0);
        for (const std::uint8_t length : lengths) {
            ++counts_[length];
        }
        counts_[0] = 0;
        int room = 1;
        for (int length = 1; length <= kMaxCodeLength; ++length) {
            room = 2 * room - counts_[static_cast<std::size_t>(length)];
            if (room < 0) {
                return false;
            }
        }
        // Where the symbols of each length begin, then every symbol to its place.
        std::array<std::size_t, kMaxCodeLength + 2> next{};
        for (std::size_t length = 1; length <= kMaxCodeLength; ++length) {
            next[length + 1] = next[length] + static_cast<std::size_t>(counts_[length]);
        }
        symbols_.resize(next[kMaxCodeLength + 1]);
        for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
            if (lengths[symbol] != 0) {
                symbols_[next[lengths[symbol]]++] = static_cast<std::uint16_t>(symbol);
            }
        }
        return true;
    }

    /// The next symbol, or a value no code has when the bits fit none.
    [[nodiscard]] std::uint32_t decode(BitReader& reader) const {
        int code = 0;
        int first = 0;
        int index = 0;
        for (std::size_t length = 1; length <= kMaxCodeLength; ++length) {
            code |= static_cast<int>(reader.bits(1));
            if (code - first < counts_[length]) {
                return symbols_[static_cast<std::size_t>(index + code - first)];
            }
            index += counts_[length];
            first = (first + counts_[length]) << 1;
            code <<= 1;
        }
        return ~0U;
    }

  private:
    std::array<int, kMaxCodeLength + 1> counts_{};
    std::vector<std::uint16_t> symbols_;
};

struct BlockCodes {
    HuffmanCode literals;
    HuffmanCode distances;
};

bool fixed_codes(BlockCodes& codes) {
    std::array<std::uint8_t, kLiteralCodes> lengths{};
    std::fill(lengths.begin(), lengths.begin() + 144, std::uint8_t{8});
    std::fill(lengths.begin() + 144, lengths.begin() + 256, std::uint8_t{9});
    std::fill(lengths.begin() + 256, lengths.begin() + 280, std::uint8_t{7});
    std::fill(lengths.begin() + 280, lengths.end(), std::uint8_t{8});
    std::array<std::uint8_t, kDistanceCodes> distances{};
    distances.fill(5);
    return codes.literals.build(lengths) && codes.distances.build(distances);
}

bool dynamic_codes(BitReader& reader, BlockCodes& codes) {
    constexpr std::array<std::uint8_t, 19> kOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                  11, 4,  12, 3, 13, 2, 14, 1, 15};
    const std::size_t n_literals = reader.bits(5) + 257;
    const std::size_t n_distances = reader.bits(5) + 1;
    const std::size_t n_lengths = reader.bits(4) + 4;
    std::array<std::uint8_t, 19> length_lengths{};
    for (std::size_t i = 0; i < n_lengths; ++i) {
        length_lengths[kOrder[i]] = static_cast<std::uint8_t>(reader.bits(3));
    }
    HuffmanCode length_code;
    if (!length_code.build(length_lengths)) {
        return false;
    }

    // The lengths of both codes, one after the other: literal lengths, or a repeat of the last or
    // of zero.
    std::vector<std::uint8_t> lengths;
    while (lengths.size() < n_literals + n_distances) {
        const std::uint32_t symbol = length_code.decode(reader);
        if (symbol < 16) {
            lengths.push_back(static_cast<std::uint8_t>(symbol));
            continue;
        }
        if (symbol > 18 || reader.overrun() || (symbol == 16 && lengths.empty())) {
            return false;
        }
        const std::size_t repeat = symbol == 16   ? 3 + reader.bits(2)
                                   : symbol == 17 ? 3 + reader.bits(3)
                                                  : 11 + reader.bits(7);
        lengths.insert(lengths.end(), repeat, symbol == 16 ? lengths.back() : std::uint8_t{0});
    }
    const std::span<const std::uint8_t> all(lengths);
    return lengths.size() == n_literals + n_distances &&
           codes.literals.build(all.first(n_literals)) &&
           codes.distances.build(all.subspan(n_literals));
}

/// Bytes that a length symbol (257 to 285) stands for; reads its extra bits. RFC 1951,
/// section 3.2.5.
std::size_t match_length(std::uint32_t symbol, BitReader& reader) {
    const std::uint32_t code = symbol - 257;
    if (code == 28) {
        return 258;
    }
    if (code < 8) {
        return code + 3;
    }
    const int extra = static_cast<int>(code / 4) - 1;
    return ((4U + code % 4) << extra) + 3 + reader.bits(extra);
}

/// Adds a compressed block's length; false when it is malformed or passes the limit.
bool add_block(BitReader& reader, const BlockCodes& codes, std::size_t limit, std::size_t& total) {
    while (total <= limit && !reader.overrun()) {
        const std::uint32_t symbol = codes.literals.decode(reader);
        if (symbol == kEndOfBlock) {
            return true;
        }
        if (symbol < kEndOfBlock) {
            ++total;
            continue;
        }
        if (symbol > 285) {
            return false;
        }
        total += match_length(symbol, reader);
        const std::uint32_t distance = codes.distances.decode(reader);
        if (distance > 29) {
            return false;
        }
        reader.bits(std::max(0, static_cast<int>(distance / 2) - 1));
    }
    return false;
}

/// Adds a stored block's length, by its header; skips its bytes.
bool add_stored(BitReader& reader, std::size_t limit, std::size_t& total) {
    reader.to_byte();
    const std::uint32_t length = reader.bits(16);
    if ((reader.bits(16) ^ length) != 0xFFFF) {
        return false;
    }
    total += length;
    reader.skip_bytes(length);
    return total <= limit && !reader.overrun();
}

}  // namespace

std::optional<std::size_t> inflated_length(std::span<const std::uint8_t> zlib,
                                           std::size_t limit_bytes) {
    BitReader reader(zlib);
    const std::uint32_t method = reader.bits(8);
    const std::uint32_t flags = reader.bits(8);
    const bool preset_dictionary = (flags & 0x20U) != 0;
    if ((method & 0x0FU) != 8 || (method * 256 + flags) % 31 != 0 || preset_dictionary) {
        return std::nullopt;
    }
    std::size_t total = 0;
    for (bool last = false; !last;) {
        last = reader.bits(1) == 1;
        const std::uint32_t type = reader.bits(2);
        BlockCodes codes;
        const bool ok =
            type == 0   ? add_stored(reader, limit_bytes, total)
            : type == 1 ? fixed_codes(codes) && add_block(reader, codes, limit_bytes, total)
            : type == 2
                ? dynamic_codes(reader, codes) && add_block(reader, codes, limit_bytes, total)
                : false;
        if (!ok || reader.overrun() || total > limit_bytes) {
            return std::nullopt;
        }
    }
    return total;
}

}  // namespace fulcrum::runtime::gltf
