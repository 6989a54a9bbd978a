// What continuous collision is measured on, ours and others': pairs of triangles whose first contact a judge in more digits knows, and ways of one
// mesh to another.
#pragma once

#include "haptics/geometry/triangle_mesh.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/way_judge.h"

namespace fulcrum::bench {

/// The pivot is the origin. Pairs that overlap at the beginning are left out.
struct KnownPair {
    TrianglePair pair;
    double first = 2.0;  ///< the time of the first contact; 2 where there is none
    double way_m = 0.0;  ///< the longest way of any place
};

/// As many by chance as hard ones, all kinds alike.
[[nodiscard]] const std::vector<KnownPair>& get_known_pairs(const Run& run);

/// What a finder told of a pair; 2 for no contact.
using FindFirst = std::function<double(const KnownPair&)>;

/// Asks a finder about all pairs: error, time, and in the extras the share missed, the share told falsely and the latest, in um.
[[nodiscard]] CostPoint measure_pairs(const Run& run, const std::string& series, double knob,
                                      const FindFirst& find_first);

/// A bumpy ball, and ways of another like it towards it, from a hair's breadth away: steps of a hand, of a millimetre or two.
struct MeshWays {
    TriangleMesh mesh;
    std::vector<std::pair<Pose, Pose>> ways;
    std::vector<double> first;  ///< by our own sweep at the smallest tolerance; 2 for none
};
[[nodiscard]] const MeshWays& get_mesh_ways(int frequency);

/// The same of meshes; the finder is asked by the way's number.
[[nodiscard]] CostPoint measure_ways(const MeshWays& ways, const std::string& series, double knob,
                                     std::size_t n_ways,
                                     const std::function<double(std::size_t)>& find_first);

}  // namespace fulcrum::bench
