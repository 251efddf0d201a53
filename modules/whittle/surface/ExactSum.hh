/// \file
/// Sums and products of doubles that are not rounded.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace whittle::detail {

/// A sum of doubles without rounding, kept as doubles of rising magnitude whose bits do not overlap (Priest 1991,
/// Shewchuk 1997). Exact as long as no term overflows and no product has bits below the least double.
///
/// Needs arithmetic as IEEE 754 has it: no -ffast-math, no x87.
/// \tparam kMost  how many terms may be added; a product is two.
template <std::size_t kMost>
class ExactSum {
 public:
  ExactSum() {}  // NOLINT(modernize-use-equals-default): the terms are not set, and there are none yet

  void add(double term) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const double sum = term + terms_[i], part = sum - term;
      const double rounded_off = (term - (sum - part)) + (terms_[i] - part);
      term = sum;
      if (rounded_off != 0) terms_[n++] = rounded_off;
    }
    if (term != 0) terms_[n++] = term;
    n_ = n;
  }

  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  /// Adds `sign` times a product of sums; `sign` is 1 or -1.
  template <std::size_t kMostA, std::size_t kMostB>
  void add_product(const ExactSum<kMostA>& a, const ExactSum<kMostB>& b, double sign = 1) {
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t k = 0; k < b.size(); ++k) add_product(sign * a[i], b[k]);
  }

  /// a - b
  static ExactSum difference(double a, double b) {
    ExactSum out;
    out.add(a);
    out.add(-b);
    return out;
  }

  int sign() const { return n_ == 0 ? 0 : terms_[n_ - 1] > 0 ? 1 : -1; }  ///< that of the greatest term
  std::size_t size() const { return n_; }
  double operator[](std::size_t i) const { return terms_[i]; }

 private:
  std::array<double, kMost> terms_;
  std::size_t n_ = 0;
};

}  // namespace whittle::detail
