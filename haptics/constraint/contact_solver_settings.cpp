// The load-path half of contact_solver.h.
#include "haptics/base/range.h"
#include "haptics/constraint/contact_solver.h"
#include "haptics/constraint/dantzig_solver.h"
#include "haptics/constraint/iterative_solver.h"
#include "haptics/constraint/newton_solver.h"

#include <algorithm>
#include <string>

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

std::string_view to_string(ContactMethod method) noexcept {
    constexpr std::array<std::string_view, 3> kNames{"newton", "dantzig", "iterative"};
    return kNames[static_cast<std::size_t>(method)];
}

Expected<ContactMethod> find_contact_method(std::string_view name) {
    std::string names;
    for (const ContactMethod method : kContactMethods) {
        if (to_string(method) == name) {
            return method;
        }
        names += (names.empty() ? "" : ", ") + std::string(to_string(method));
    }
    return fail("there is no contact solver \"" + std::string(name) + "\"", {},
                "name one of " + names);
}

Expected<void> validate(const ContactSolverSettings& settings) {
    const Range ranges[] = {
        {"tolerance_m_per_s", settings.tolerance_m_per_s, 1.0e-12, 1.0},
        {"max_iterations", static_cast<double>(settings.max_iterations), 1.0, 10000.0},
        {"friction_rounds", static_cast<double>(settings.friction_rounds), 1.0, 100.0},
        {"most_exact_contacts", static_cast<double>(settings.most_exact_contacts), 1.0, 1.0e6},
        {"relaxation", settings.relaxation, 0.1, 1.9},
        {"stiffening", settings.stiffening, 1.0e-9, 1.0},
    };
    return check_ranges("the contact solver's setting", ranges);
}

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
