/// \file
/// Scalars and vectors of every kind, component by component.
#pragma once

#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace whittle::detail {

/// How many components a value of an attribute has, and of what type; a scalar has one.
template <typename Value, bool = std::is_arithmetic_v<Value>>
struct ComponentsT {
  using Scalar = Value;
  static constexpr std::size_t size = 1;
};
template <typename Value>
struct ComponentsT<Value, false> {
  using Scalar = typename OpenMesh::vector_traits<Value>::value_type;
  static constexpr std::size_t size = OpenMesh::vector_traits<Value>::size_;
};

/// The index is unsigned and short, so that it widens to that of any vector type without a change of sign.
template <typename Value>
auto& component(Value& value, std::uint32_t i) {
  if constexpr (std::is_arithmetic_v<std::remove_const_t<Value>>)
    return value;
  else
    return value[i];
}

/// The sum of three values times their shares; rounded to the nearest where the type is integral, as in
/// colours of bytes.
template <typename Value>
Value interpolated(const std::array<const Value*, 3>& values, const std::array<double, 3>& shares) {
  using Scalar = typename ComponentsT<Value>::Scalar;
  Value out = *values[0];
  for (std::uint32_t i = 0; i < ComponentsT<Value>::size; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += shares[k] * static_cast<double>(component(*values[k], i));
    component(out, i) = static_cast<Scalar>(std::is_integral_v<Scalar> ? std::round(sum) : sum);
  }
  return out;
}

}  // namespace whittle::detail
