// The load-path half of contact_solver.h.
#include "haptics/constraint/contact_solver.h"
#include "haptics/constraint/dantzig_solver.h"
#include "haptics/constraint/iterative_solver.h"
#include "haptics/constraint/newton_solver.h"

#include <algorithm>
#include <cstdint>

namespace fulcrum {
namespace {

std::unique_ptr<ContactMethodSolver> make_method(const ContactSolverSettings& settings,
                                                 const ContactCapacity& capacity) {
    if (settings.method == ContactMethod::iterative) {
        return std::make_unique<IterativeSolver>(settings, capacity);
    }
    if (settings.method == ContactMethod::dantzig) {
        return std::make_unique<DantzigSolver>(settings, capacity);
    }
    return std::make_unique<NewtonSolver>(settings, capacity);
}

// Room for rows of whatever kind.
std::unique_ptr<ContactMethodSolver> make_pivots(const ContactSolverSettings& settings,
                                                 const ContactCapacity& capacity) {
    const std::int64_t most = 3 * std::int64_t{std::max(capacity.contacts, 0)} + capacity.rows;
    return std::make_unique<DantzigSolver>(
        settings,
        ContactCapacity{.bodies = capacity.bodies,
                        .contacts = 0,
                        .rows = static_cast<int>(std::min<std::int64_t>(most, kMostPivotRows))});
}

}  // namespace

ContactSolver::ContactSolver(const ContactSolverSettings& settings, const ContactCapacity& capacity)
    : settings_(settings),
      capacity_(capacity),
      method_(make_method(settings, capacity)),
      motion_(capacity.bodies),
      kept_contacts_(static_cast<std::size_t>(std::max(capacity.contacts, 0)), Vector3::Zero()),
      kept_rows_(static_cast<std::size_t>(std::max(capacity.rows, 0))),
      friction_(kept_contacts_.size()) {
    if (settings.method == ContactMethod::iterative) {
        return;
    }
    if (settings.method == ContactMethod::newton) {
        pivots_ = make_pivots(settings, capacity);
    }
    constexpr int kRounds = 30;
    ContactSolverSettings rounds = settings;
    rounds.method = ContactMethod::iterative;
    rounds.max_iterations = kRounds;
    rounds_ = make_method(rounds, capacity);
    if (settings.method == ContactMethod::newton &&
        capacity.contacts > settings.most_exact_contacts) {
        rounds.max_iterations = kBoundedRounds;
        bounded_ = make_method(rounds, capacity);
    }
}

}  // namespace fulcrum
