#include "tests/bench/harness/registry.h"

#include <algorithm>
#include <utility>

namespace fulcrum::bench {
namespace {

// Registrations run before main, in any order: the lists are made when the first one asks.
std::vector<Bench>& benches() {
    static std::vector<Bench> list;
    return list;
}

std::vector<Peer>& peers() {
    static std::vector<Peer> list;
    return list;
}

}  // namespace

Registration::Registration(Bench bench) {
    auto& list = benches();
    const auto place =
        std::ranges::upper_bound(list, bench.name, {}, [](const Bench& b) { return b.name; });
    list.insert(place, std::move(bench));
}

PeerRegistration::PeerRegistration(Peer peer) {
    auto& list = peers();
    const auto place =
        std::ranges::upper_bound(list, peer.name, {}, [](const Peer& p) { return p.name; });
    list.insert(place, std::move(peer));
}

const std::vector<Bench>& all_benches() {
    return benches();
}

const std::vector<Peer>& all_peers() {
    return peers();
}

}  // namespace fulcrum::bench
