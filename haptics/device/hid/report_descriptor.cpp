#include "haptics/device/hid/report_descriptor.h"

#include <optional>

namespace fulcrum::hid {
// What the parser below is made of; it has a name because the parser, a friend, has one.
namespace parsing {

constexpr std::uint8_t kLongItem = 0xFE;
constexpr std::uint32_t kMostReportCount = 8 * 4096;

struct Item {
    std::uint8_t tag = 0;
    std::uint8_t type = 0;
    std::uint8_t n_bytes = 0;
    std::uint32_t value = 0;

    [[nodiscard]] std::int64_t as_signed() const noexcept {
        switch (n_bytes) {
            case 1:
                return static_cast<std::int8_t>(value);
            case 2:
                return static_cast<std::int16_t>(value);
            default:
                return static_cast<std::int32_t>(value);
        }
    }
};

// HID 1.11, 6.2.2.7.
struct Globals {
    std::uint16_t usage_page = 0;
    std::int64_t logical_min = 0;
    Item logical_max{};  // signed or not: that is known when the minimum is
    std::int64_t physical_min = 0;
    Item physical_max{};
    std::int8_t unit_exponent = 0;
    std::uint32_t unit = 0;
    std::uint32_t report_size = 0;
    std::uint32_t report_count = 0;
    std::uint8_t report_id = 0;
};

// A maximum beside a minimum below zero is signed, else it is not: devices write 0xFF for 255.
inline std::int64_t maximum(std::int64_t minimum, const Item& item) noexcept {
    return minimum < 0 ? item.as_signed() : static_cast<std::int64_t>(item.value);
}

// A usage as it was written: with its page where it has four bytes.
struct LocalUsages {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    bool has_page = false;
};

}  // namespace parsing

using namespace parsing;

// Reads item after item; what an item does stands in one function each.
class DescriptorParser {
  public:
    explicit DescriptorParser(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    Expected<ReportDescriptor> run() {
        if (bytes_.empty() || bytes_.size() > kMostDescriptorBytes) {
            return refuse("it has " + std::to_string(bytes_.size()) + " bytes, not 1 to " +
                          std::to_string(kMostDescriptorBytes));
        }
        while (at_ < bytes_.size()) {
            item_at_ = at_;
            if (auto done = step(); !done) {
                return tl::unexpected(done.error());
            }
        }
        if (depth_ != 0) {
            return refuse("a collection is not closed");
        }
        return std::move(made_);
    }

  private:
    [[nodiscard]] tl::unexpected<Error> refuse(const std::string& why) const {
        return fail("the report descriptor is wrong: " + why, "byte " + std::to_string(item_at_),
                    "update the device's firmware, or use another device");
    }

    Expected<void> step() {
        const std::uint8_t prefix = bytes_[at_++];
        if (prefix == kLongItem) {
            // bDataSize, bLongItemTag, data: none is defined, so all are passed over.
            if (bytes_.size() - at_ < 2 || bytes_.size() - at_ - 2 < bytes_[at_]) {
                return refuse("a long item is cut off");
            }
            at_ += 2U + bytes_[at_];
            return {};
        }
        Item item;
        item.n_bytes = (prefix & 3U) == 3U ? 4 : prefix & 3U;
        item.type = prefix >> 2U & 3U;
        item.tag = prefix >> 4U;
        if (bytes_.size() - at_ < item.n_bytes) {
            return refuse("an item is cut off");
        }
        for (std::uint8_t i = 0; i < item.n_bytes; ++i) {
            item.value |= std::uint32_t{bytes_[at_++]} << (8U * i);
        }
        switch (item.type) {
            case 0:
                return do_main(item);
            case 1:
                return do_global(item);
            case 2:
                return do_local(item);
            default:
                return {};  // reserved
        }
    }

    Expected<void> do_main(const Item& item) {
        Expected<void> done;
        switch (item.tag) {
            case 0x8:
                done = add_fields(ReportType::input, item.value);
                break;
            case 0x9:
                done = add_fields(ReportType::output, item.value);
                break;
            case 0xB:
                done = add_fields(ReportType::feature, item.value);
                break;
            case 0xA:
                done = open_collection(static_cast<std::uint8_t>(item.value));
                break;
            case 0xC:
                done = close_collection();
                break;
            default:
                break;
        }
        usages_.clear();
        minimum_.reset();
        in_delimiter_ = false;
        delimited_ = 0;
        return done;
    }

    Expected<void> open_collection(std::uint8_t kind) {
        if (depth_ == kMostDepth) {
            return refuse("collections lie more than " + std::to_string(kMostDepth) + " deep");
        }
        const std::int16_t parent = depth_ == 0 ? kNoCollection : open_[depth_ - 1];
        open_[depth_++] = static_cast<std::int16_t>(made_.collections_.size());
        made_.collections_.push_back({usage_at(0), kind, parent});
        return {};
    }

    Expected<void> close_collection() {
        if (depth_ == 0) {
            return refuse("a collection ends that has not begun");
        }
        --depth_;
        return {};
    }

    Expected<void> do_global(const Item& item) {
        switch (item.tag) {
            case 0x0:
                global_.usage_page = static_cast<std::uint16_t>(item.value);
                return {};
            case 0x1:
                global_.logical_min = item.as_signed();
                return {};
            case 0x2:
                global_.logical_max = item;
                return {};
            case 0x3:
                global_.physical_min = item.as_signed();
                return {};
            case 0x4:
                global_.physical_max = item;
                return {};
            case 0x5: {
                // A nibble in two's complement; some devices write it as a signed byte.
                const std::uint32_t nibble = item.value & 0xFU;
                global_.unit_exponent = static_cast<std::int8_t>(
                    nibble > 7U ? static_cast<int>(nibble) - 16 : static_cast<int>(nibble));
                return {};
            }
            case 0x6:
                global_.unit = item.value;
                return {};
            case 0x7:
                global_.report_size = item.value;
                return {};
            case 0x8:
                if (item.value == 0 || item.value > 0xFF) {
                    return refuse("a report has the number " + std::to_string(item.value));
                }
                global_.report_id = static_cast<std::uint8_t>(item.value);
                made_.numbers_reports_ = true;
                return {};
            case 0x9:
                global_.report_count = item.value;
                return {};
            case 0xA:
                if (n_kept_ == kMostDepth) {
                    return refuse("Push more than " + std::to_string(kMostDepth) + " times");
                }
                kept_[n_kept_++] = global_;
                return {};
            case 0xB:
                if (n_kept_ == 0) {
                    return refuse("Pop without Push");
                }
                global_ = kept_[--n_kept_];
                return {};
            default:
                return {};
        }
    }

    Expected<void> do_local(const Item& item) {
        switch (item.tag) {
            case 0x0:
                return add_usages({item.value, item.value, item.n_bytes == 4});
            case 0x1:
                minimum_ = item;
                return {};
            case 0x2: {
                if (!minimum_) {
                    return refuse("Usage Maximum without Usage Minimum");
                }
                // With a page on either side, both are of that page.
                const bool has_page = minimum_->n_bytes == 4 || item.n_bytes == 4;
                const std::uint32_t page =
                    (minimum_->n_bytes == 4 ? minimum_->value : item.value) & 0xFFFF0000U;
                const auto whole = [&](const Item& end) {
                    return has_page && end.n_bytes != 4 ? page | end.value : end.value;
                };
                const LocalUsages range{whole(*minimum_), whole(item), has_page};
                minimum_.reset();
                if (range.first > range.last || range.first >> 16U != range.last >> 16U) {
                    return refuse("usages run backwards or over two pages");
                }
                return add_usages(range);
            }
            case 0xA:
                // Between delimiters stand names of the same control, the preferred one first.
                in_delimiter_ = item.value == 1;
                delimited_ = 0;
                return {};
            default:
                return {};  // strings and designators
        }
    }

    Expected<void> add_usages(const LocalUsages& range) {
        if (in_delimiter_ && delimited_++ > 0) {
            return {};
        }
        if (usages_.size() == kMostUsageRanges) {
            return refuse("more than " + std::to_string(kMostUsageRanges) + " usages at once");
        }
        usages_.push_back(range);
        return {};
    }

    [[nodiscard]] UsageRange complete(const LocalUsages& range) const noexcept {
        const Usage page = range.has_page ? 0 : Usage{global_.usage_page} << 16U;
        return {page | range.first, page | range.last};
    }

    // Usage of the control `index` of a main item: the last one holds for all that remain.
    [[nodiscard]] Usage usage_at(std::uint32_t index) const noexcept {
        Usage last = 0;
        for (const LocalUsages& local : usages_) {
            const UsageRange range = complete(local);
            const std::uint32_t n = range.last - range.first + 1;
            if (index < n) {
                return range.first + index;
            }
            index -= n;
            last = range.last;
        }
        return last;
    }

    Expected<void> add_fields(ReportType type, std::uint32_t flags) {
        constexpr std::uint32_t kConstant = 1;
        constexpr std::uint32_t kVariable = 2;
        constexpr std::uint32_t kRelative = 4;
        const std::uint32_t size = global_.report_size;
        const std::uint32_t count = global_.report_count;
        std::uint32_t& bits = made_.bits_[static_cast<std::size_t>(type)][global_.report_id];
        if (size > kMostReportBits || count > kMostReportCount ||
            std::uint64_t{size} * count > kMostReportBits - bits) {
            return refuse("a report is longer than " + std::to_string(kMostReportBits / 8) +
                          " bytes");
        }
        const std::uint32_t offset = bits;
        bits += size * count;
        if ((flags & kConstant) != 0 || size == 0 || size > 32 || usages_.empty()) {
            return {};
        }
        const std::int64_t logical_max = maximum(global_.logical_min, global_.logical_max);
        if (logical_max < global_.logical_min) {
            return refuse("the logical maximum " + std::to_string(logical_max) +
                          " lies below the minimum " + std::to_string(global_.logical_min));
        }
        if (made_.fields_.size() + count > kMostFields) {
            return refuse("it describes more than " + std::to_string(kMostFields) + " numbers");
        }
        ReportField field;
        field.type = type;
        field.report_id = global_.report_id;
        field.bit_size = static_cast<std::uint8_t>(size);
        field.is_array = (flags & kVariable) == 0;
        field.is_relative = (flags & kRelative) != 0;
        field.logical_min = global_.logical_min;
        field.logical_max = logical_max;
        field.physical_min = global_.physical_min;
        field.physical_max = maximum(global_.physical_min, global_.physical_max);
        field.unit_exponent = global_.unit_exponent;
        field.unit = global_.unit;
        field.collection = depth_ == 0 ? kNoCollection : open_[depth_ - 1];
        if (field.is_array) {
            if (auto kept = keep_ranges(field); !kept) {
                return kept;
            }
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            field.bit_offset = offset + i * size;
            field.usage = usage_at(field.is_array ? 0 : i);
            made_.fields_.push_back(field);
        }
        return {};
    }

    Expected<void> keep_ranges(ReportField& field) {
        if (made_.ranges_.size() + usages_.size() > kMostFields) {
            return refuse("it names more than " + std::to_string(kMostFields) + " usages");
        }
        field.first_range = static_cast<std::uint16_t>(made_.ranges_.size());
        field.n_ranges = static_cast<std::uint16_t>(usages_.size());
        for (const LocalUsages& local : usages_) {
            made_.ranges_.push_back(complete(local));
        }
        return {};
    }

    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
    std::size_t item_at_ = 0;  // where the item that is read begins
    ReportDescriptor made_;

    Globals global_{};
    std::array<Globals, kMostDepth> kept_{};
    std::size_t n_kept_ = 0;

    std::vector<LocalUsages> usages_;
    std::optional<Item> minimum_;
    bool in_delimiter_ = false;
    int delimited_ = 0;

    std::array<std::int16_t, kMostDepth> open_{};
    std::size_t depth_ = 0;
};

Expected<ReportDescriptor> ReportDescriptor::parse(std::span<const std::uint8_t> bytes) {
    return DescriptorParser(bytes).run();
}

}  // namespace fulcrum::hid
