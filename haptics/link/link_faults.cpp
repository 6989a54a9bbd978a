#include "haptics/link/link_faults.h"

#include "haptics/base/range.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kReorder_s = 0.004;
constexpr std::uint64_t kMostBits = 8;
constexpr int kMostTaken = 4;

}  // namespace

Expected<void> validate(const LinkFaults& f) {
    const Range ranges[] = {
        {"loss", f.loss, 0.0, 1.0},       {"burst", static_cast<double>(f.burst), 1.0, 1000.0},
        {"delay_s", f.delay_s, 0.0, 1.0}, {"jitter_s", f.jitter_s, 0.0, 1.0},
        {"reorder", f.reorder, 0.0, 1.0}, {"duplicate", f.duplicate, 0.0, 1.0},
        {"corrupt", f.corrupt, 0.0, 1.0},
    };
    return check_ranges("the link's fault", ranges);
}

FaultyDatagrams::FaultyDatagrams(const LinkFaults& faults, Datagrams& inner)
    : faults_(faults), inner_(inner), chance_(faults.seed) {
    out_.waiting.resize(kMostWaiting);
    in_.waiting.resize(kMostWaiting);
}

FaultyDatagrams::~FaultyDatagrams() = default;

// A burst of exactly `burst`, then a gap of one and a geometric number of packets, so that on average
// burst / (burst + gap) = loss.
bool FaultyDatagrams::loses(Way& way) noexcept {
    if (!(faults_.loss > 0.0)) {
        return false;
    }
    if (faults_.loss >= 1.0) {
        return true;
    }
    if (way.burst_left > 0) {
        --way.burst_left;
        return true;
    }
    if (!way.has_gap) {
        const double gap = faults_.burst * (1.0 - faults_.loss) / faults_.loss;
        const double more = std::max(gap - 1.0, 0.0);
        // Geometric with mean `more`, by inversion: floor(ln u / ln q), q = more / (1 + more).
        const double drawn =
            more > 0.0
                ? std::floor(std::log(1.0 - chance_.draw_chance()) / std::log(more / (1.0 + more)))
                : 0.0;
        way.until_burst = 1 + static_cast<std::uint64_t>(std::min(drawn, 1.0e12));
        way.has_gap = true;
    }
    if (way.until_burst > 0) {
        --way.until_burst;
        return false;
    }
    way.has_gap = false;
    way.burst_left = faults_.burst - 1;
    return true;
}

void FaultyDatagrams::enter(Way& way, double now_s, const PeerAddress& peer,
                            std::span<const std::byte> packet) noexcept {
    if (loses(way)) {
        ++counts_.lost;
        return;
    }
    const int copies = happens(faults_.duplicate) ? 2 : 1;
    counts_.doubled += copies == 2 ? 1 : 0;
    for (int i = 0; i < copies; ++i) {
        double due_s = now_s + faults_.delay_s + faults_.jitter_s * chance_.draw_chance();
        due_s += happens(faults_.reorder) ? kReorder_s * chance_.draw_chance() : 0.0;
        counts_.delayed += due_s > now_s ? 1 : 0;
        counts_.overtaken += due_s < way.latest_due_s ? 1 : 0;
        way.latest_due_s = std::max(way.latest_due_s, due_s);
        wait(way, due_s, peer, packet, happens(faults_.corrupt));
    }
}

void FaultyDatagrams::wait(Way& way, double due_s, const PeerAddress& peer,
                           std::span<const std::byte> packet, bool damages) noexcept {
    if (way.n == way.waiting.size() || packet.size() > kMostBytes || packet.empty()) {
        ++counts_.dropped;
        return;
    }
    Waiting& place = way.waiting[way.n++];
    place.due_s = due_s;
    place.number = ++way.number;
    place.peer = peer;
    place.size = packet.size();
    std::copy(packet.begin(), packet.end(), place.bytes.begin());
    if (damages) {
        ++counts_.damaged;
        const auto bits = 1 + static_cast<std::uint64_t>(chance_.draw_chance() * kMostBits);
        for (std::uint64_t i = 0; i < bits; ++i) {
            const auto bit = static_cast<std::size_t>(chance_.draw_chance() * 8.0 *
                                                      static_cast<double>(place.size));
            place.bytes[bit / 8] ^= std::byte{1} << (bit % 8);
        }
    }
    ++counts_.passed;
}

// The one that is due first, in the order of coming where two are due together; null when none is due.
FaultyDatagrams::Waiting* FaultyDatagrams::find_due(Way& way, double now_s) noexcept {
    const auto begin = way.waiting.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(way.n);
    const auto first = std::min_element(begin, end, [](const Waiting& a, const Waiting& b) {
        return a.due_s < b.due_s || (a.due_s == b.due_s && a.number < b.number);
    });
    return first != end && first->due_s <= now_s ? &*first : nullptr;
}

void FaultyDatagrams::remove(Way& way, Waiting& gone) noexcept {
    --way.n;
    if (&gone != &way.waiting[way.n]) {
        gone = way.waiting[way.n];
    }
}

void FaultyDatagrams::pass_on(double now_s) noexcept {
    while (Waiting* const due = find_due(out_, now_s)) {
        inner_.send(now_s, due->peer, std::span(due->bytes).first(due->size));
        remove(out_, *due);
    }
}

bool FaultyDatagrams::send(double now_s, const PeerAddress& to,
                           std::span<const std::byte> packet) noexcept {
    enter(out_, now_s, to, packet);
    pass_on(now_s);
    return true;
}

std::size_t FaultyDatagrams::receive(double now_s, std::span<std::byte> packet,
                                     PeerAddress& from) noexcept {
    pass_on(now_s);
    PeerAddress peer;
    // A few for each that is asked for: who asks bounds the rest.
    for (int i = 0; i < kMostTaken; ++i) {
        const std::size_t size = inner_.receive(now_s, bytes_, peer);
        if (size == 0) {
            break;
        }
        enter(in_, now_s, peer, std::span(bytes_).first(std::min(size, bytes_.size())));
    }
    Waiting* const due = find_due(in_, now_s);
    if (due == nullptr) {
        return 0;
    }
    const std::size_t size = due->size;
    std::copy_n(due->bytes.begin(), std::min(size, packet.size()), packet.begin());
    from = due->peer;
    remove(in_, *due);
    return size;
}

}  // namespace fulcrum
