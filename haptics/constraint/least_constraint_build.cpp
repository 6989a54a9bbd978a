// What least_constraint.h allocates.
#include "haptics/constraint/least_constraint.h"

namespace fulcrum {

LeastConstraintSolver::LeastConstraintSolver(std::size_t max_contacts)
    : rows_(max_contacts), least_(max_contacts), length_(max_contacts) {}

}  // namespace fulcrum
