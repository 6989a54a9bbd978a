// Stands in for libbarrett's header of the same name: the types of its diagram that runtime/arms/wam/barrett uses, written from its documents.
// Source: libbarrett, units.h, math/matrix.h: BARRETT_UNITS_TEMPLATE_TYPEDEFS; Vector<N>::type, made of one number for all, read by [].
#pragma once

#include <Eigen/Geometry>
#include <cstddef>

namespace barrett {
namespace math {

template <std::size_t N>
struct Vector {
    class type {
      public:
        explicit type(double all = 0.0) {
            for (double& v : values_) {
                v = all;
            }
        }
        double& operator[](std::size_t i) { return values_[i]; }
        const double& operator[](std::size_t i) const { return values_[i]; }

      private:
        double values_[N];
    };
};

}  // namespace math
}  // namespace barrett

#define BARRETT_UNITS_TEMPLATE_TYPEDEFS(dimension)             \
    typedef typename ::barrett::math::Vector<3>::type cp_type; \
    typedef typename ::barrett::math::Vector<3>::type cf_type; \
    typedef typename ::barrett::math::Vector<dimension>::type jt_type
