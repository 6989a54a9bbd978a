// A method that solves contact problems, by its name: what it is told, what it tells. contact_solver.h chooses among them.
//
// Thread: that of the solver.
#pragma once

#include "haptics/base/error.h"
#include "haptics/constraint/contact_problem.h"
#include "haptics/constraint/friction_shape.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace fulcrum {

enum class ContactMethod : std::uint8_t { newton, dantzig, iterative };
inline constexpr std::array<ContactMethod, 3> kContactMethods{
    ContactMethod::newton, ContactMethod::dantzig, ContactMethod::iterative};

/// Fixed at load.
struct ContactSolverSettings {
    ContactMethod method = ContactMethod::newton;
    FrictionShape friction_shape = FrictionShape::cone;  ///< dantzig: always the pyramid
    /// The residual (complementarity.h) at which the answer is taken, of a problem whose velocities are 1 m/s or less, and
    /// in proportion above; 1e-12 to 1.
    double tolerance_m_per_s = 1.0e-8;
    /// Linear systems solved, or rounds through all contacts, at most; 1 to 10000.
    int max_iterations = 60;
    int friction_rounds = 4;  ///< solves at most where contacts begin to slide, 1 to 100
    double relaxation = 1.0;  ///< iterative: how far each contact goes to its answer, 0.1 to 1.9
    int most_exact_contacts = 256;  ///< 1 to 1000000
    double stiffening =
        1.0e-5;  ///< newton: compliance of a contact within a step, of its weight; 1e-9 to 1
};

struct SolveReport {
    double residual_m_per_s = 0.0;  ///< of the answer
    int n_iterations = 0;           ///< linear solves or rounds; 0: last step's impulses were right
    int n_pivots = 0;               ///< dantzig: rows that changed their set
    int n_regularised = 0;          ///< pivots that were zero, sets that had no answer
    int n_bounded = 0;              ///< solves of too many contacts, by rounds alone
    int n_pivoted = 0;              ///< newton: solves whose answer is that of pivoting
    bool converged = true;          ///< within the tolerance
};

/// "newton", "dantzig", "iterative".
[[nodiscard]] std::string_view to_string(ContactMethod method) noexcept;
/// The method of that name; an error that lists the names where there is none.
[[nodiscard]] Expected<ContactMethod> find_contact_method(std::string_view name);
/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const ContactSolverSettings& settings);

/// What a method is to the solver: it sets impulses and velocities for given coefficients of friction.
class ContactMethodSolver {
  public:
    ContactMethodSolver() = default;
    ContactMethodSolver(const ContactMethodSolver&) = delete;
    ContactMethodSolver& operator=(const ContactMethodSolver&) = delete;
    virtual ~ContactMethodSolver() = default;
    /// `friction`: the coefficient of each contact. `tolerance`: in m/s, of this problem.
    virtual SolveReport solve(ContactProblem& problem, std::span<const double> friction,
                              double tolerance) noexcept = 0;
};

}  // namespace fulcrum
