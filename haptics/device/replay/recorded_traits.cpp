#include "haptics/device/replay/recorded_traits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace fulcrum {
namespace {

struct Trait {
    const char* name;
    double DeviceTraits::*member;
};
constexpr std::array<Trait, 5> kTraits{
    {{"device.force N", &DeviceTraits::max_force_N},
     {"device.torque Nm", &DeviceTraits::max_torque_Nm},
     {"device.resolution m", &DeviceTraits::position_resolution_m},
     {"device.damping Ns/m", &DeviceTraits::damping_Ns_per_m},
     {"device.mass kg", &DeviceTraits::mass_kg}}};
constexpr const char* kName = "device.name";
constexpr const char* kRenders = "device.renders force";

}  // namespace

std::optional<std::string_view> find_fact(const RecordHeader& header, std::string_view name) {
    const auto fact = std::ranges::find(header.facts, name, &RecordFact::name);
    return fact == header.facts.end() ? std::nullopt : std::optional<std::string_view>(fact->value);
}

void list_traits(const DeviceTraits& traits, std::vector<RecordFact>& facts) {
    facts.push_back({kName, traits.name});
    facts.push_back({kRenders, traits.renders_force ? "yes" : "no"});
    for (const Trait& trait : kTraits) {
        std::array<char, 40> text{};
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), traits.*trait.member);
        facts.push_back({trait.name, {text.data(), end.ptr}});
    }
}

std::optional<DeviceTraits> find_traits(const RecordHeader& header) {
    DeviceTraits traits;
    const auto name = find_fact(header, kName);
    const auto renders = find_fact(header, kRenders);
    if (!name || (renders != "yes" && renders != "no")) {
        return std::nullopt;
    }
    traits.name = *name;
    traits.renders_force = renders == "yes";
    for (const Trait& trait : kTraits) {
        const auto text = find_fact(header, trait.name);
        double& value = traits.*trait.member;
        if (!text ||
            std::from_chars(text->data(), text->data() + text->size(), value).ec != std::errc{} ||
            !(value >= 0.0 && value <= std::numeric_limits<double>::max())) {
            return std::nullopt;
        }
    }
    return traits;
}

}  // namespace fulcrum
