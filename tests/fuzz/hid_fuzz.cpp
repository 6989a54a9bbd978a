// Any bytes at all as a HID device: its report descriptor, its reports, what it answers. Understood or refused, never a crash, and
// no report goes out that is longer than the descriptor says.
//
// The input: two bytes of length, the descriptor, then reports, each behind a byte of length; the last are what it answers.
#include "haptics/device/hid/force_effects.h"
#include "haptics/device/hid/hid_ability.h"
#include "haptics/device/hid/report_bits.h"
#include "haptics/device/hid/space_mouse.h"
#include "tests/fuzz/promise.h"

namespace {

using namespace fulcrum::hid;
using Input = std::span<const std::uint8_t>;

Input take(Input& rest, std::size_t n) {
    const Input taken = rest.first(std::min(n, rest.size()));
    rest = rest.subspan(taken.size());
    return taken;
}

Input take_report(Input& rest) {
    const Input length = take(rest, 1);
    return length.empty() ? length : take(rest, length[0]);
}

void check_descriptor(const ReportDescriptor& descriptor) {
    require(descriptor.fields().size() <= kMostFields);
    const auto n_collections = static_cast<std::int16_t>(descriptor.collections().size());
    for (std::int16_t i = 0; i < n_collections; ++i) {
        require(descriptor.collections()[static_cast<std::size_t>(i)].parent < i);
    }
    for (const ReportField& field : descriptor.fields()) {
        const std::size_t n_bytes = descriptor.report_bytes(field.type, field.report_id);
        const std::size_t n_data = n_bytes - (descriptor.numbers_reports() ? 1 : 0);
        require(n_bytes > 0 && field.bit_offset + field.bit_size <= 8 * n_data);
        require(field.bit_size >= 1 && field.bit_size <= 32);
        require(field.logical_min <= field.logical_max && field.collection < n_collections);
        require(!field.is_array || descriptor.value_of(field, field.usage) <= field.logical_max);
        require(std::abs(to_unit(field, field.logical_max)) <= 1.0);
        const std::int64_t share = from_share(field, 0.3);
        require(share >= field.logical_min && share <= field.logical_max);
        const std::int64_t physical = from_physical(field, 90.0);
        require(physical >= field.logical_min && physical <= field.logical_max);
        (void)descriptor.application_of(field);
    }
}

// Takes what it is sent, answers what the input says.
class FuzzedLink final : public HidLink {
  public:
    FuzzedLink(const ReportDescriptor& descriptor, Input answers)
        : descriptor_(descriptor), answers_(answers) {}
    int read(std::span<std::uint8_t> /*report*/, int /*timeout_ms*/) override { return -1; }
    bool write(Input report) override { return is_long(ReportType::output, report); }
    bool send_feature(Input report) override { return is_long(ReportType::feature, report); }
    int get_feature(std::span<std::uint8_t> report) override {
        const Input answer = take_report(answers_);
        std::copy_n(answer.begin(), std::min(answer.size(), report.size()), report.begin());
        return static_cast<int>(std::min(answer.size(), report.size()));
    }

  private:
    [[nodiscard]] bool is_long(ReportType type, Input report) const {
        require(!report.empty() && report.size() == descriptor_.report_bytes(type, report[0]));
        return true;
    }

    const ReportDescriptor& descriptor_;
    Input answers_;
};

void push(const HidAbility& ability, Input answers) {
    FuzzedLink link(ability.descriptor, answers);
    ForceEffects effects(ability.descriptor, *ability.force, {.load_pause_s = 0.0});
    if (effects.begin(link)) {
        require(effects.set(link, 0.5, -2.0));
        require(effects.renew(link));
    }
    effects.end(link);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input rest(data, size);
    const Input length = take(rest, 2);
    const std::size_t n = length.size() == 2 ? length[0] + 256U * length[1] : 0;
    HidNode node;
    // Every other one claims to be a SpaceMouse.
    node.vendor = 0x046d;
    node.product = n % 2 == 0 ? 0xc626 : 1;
    const Input descriptor = take(rest, n);
    node.descriptor.assign(descriptor.begin(), descriptor.end());
    const HidAbility ability = find_ability(node);
    check_descriptor(ability.descriptor);
    require(ability.missing.find('\n') == std::string::npos);

    CapState cap;
    StickState stick;
    Input reports = rest;
    while (!reports.empty()) {
        const Input report = take_report(reports);
        if (ability.cap) {
            (void)ability.cap->take_report(report, cap);
            require(cap.push_D.cwiseAbs().maxCoeff() <= 1.0 &&
                    cap.turn_D.cwiseAbs().maxCoeff() <= 1.0);
        }
        if (ability.stick) {
            (void)ability.stick->take_report(report, stick);
            require(stick.place.cwiseAbs().maxCoeff() <= 1.0);
        }
    }
    if (ability.force) {
        push(ability, rest);
    }
    return 0;
}
