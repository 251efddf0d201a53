/// \file
/// Numbers as most files have them, read fast.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <system_error>

namespace whittle::files {

/// Reads a decimal number and leaves `at` behind it; what it makes of the digits is what parse_real() does, bit for bit.
/// \param at   where it begins
/// \param end  of the text
/// \return false: it is none, or one that parse_real() is left to judge
/// \{
bool read_fast(const char*& at, const char* end, double& value);
bool read_fast(const char*& at, const char* end, float& value);
/// \}

namespace detail_of_numbers {

struct Decimal {
  std::uint64_t digits = 0;
  int exponent = 0;
  bool negative = false, short_enough = true;
};

inline bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}

/// \return false: not a number
inline bool scan(const char*& at, const char* end, Decimal& number) {
  if (at < end && *at == '-') {
    number.negative = true;
    ++at;
  }
  int count = 0;
  const auto take_digits = [&] {
    const char* const begin = at;
    for (; at < end && is_digit(*at); ++at) {
      number.digits = 10 * number.digits + static_cast<std::uint64_t>(*at - '0');
      count += number.digits > 0 ? 1 : 0;
    }
    return static_cast<int>(at - begin);
  };
  int any = take_digits();
  if (at < end && *at == '.') {
    ++at;
    const int behind = take_digits();
    number.exponent = -behind;
    any += behind;
  }
  if (any == 0) return false;
  number.short_enough = count <= 19;
  if (at < end && (*at == 'e' || *at == 'E')) {
    ++at;
    const bool down = at < end && *at == '-';
    if (at < end && (*at == '-' || *at == '+')) ++at;
    int exponent = 0, digits = 0;
    for (; at < end && is_digit(*at) && digits < 5; ++at, ++digits) exponent = 10 * exponent + (*at - '0');
    if (digits == 0 || digits == 5) return false;
    number.exponent += down ? -exponent : exponent;
  }
  return true;
}

/// The nearest double, where a product or a quotient of two exact numbers gives it.
inline bool is_exact(const Decimal& number, double& value) {
  static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                      1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  if (!number.short_enough || number.digits > std::uint64_t{1} << 53 || number.exponent < -22 ||
      number.exponent > 22)
    return false;
  value = static_cast<double>(number.digits);
  if (number.exponent < 0)
    value /= powers[-number.exponent];
  else
    value *= powers[number.exponent];
  if (number.negative) value = -value;
  return true;
}

template <typename Real>
bool read_slowly(const char* begin, const char* end, Real& value) {
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end && std::isfinite(value);
}

}  // namespace detail_of_numbers

inline bool read_fast(const char*& at, const char* end, double& value) {
  const char* const begin = at;
  detail_of_numbers::Decimal number;
  if (!detail_of_numbers::scan(at, end, number)) return false;
  return detail_of_numbers::is_exact(number, value) || detail_of_numbers::read_slowly(begin, at, value);
}

inline bool read_fast(const char*& at, const char* end, float& value) {
  const char* const begin = at;
  detail_of_numbers::Decimal number;
  if (!detail_of_numbers::scan(at, end, number)) return false;
  double wide = 0;
  if (detail_of_numbers::is_exact(number, wide)) {
    std::uint64_t bits;
    std::memcpy(&bits, &wide, sizeof(bits));
    // Rounded twice it may come out wrong only from half-way between two floats; and floats have other ends of their range.
    const bool half_way = (bits & 0x1fffffff) == 0x10000000;
    const double size = std::abs(wide);
    if (!half_way && (wide == 0 || (size > 1.2e-38 && size < 3.4e38))) {
      value = static_cast<float>(wide);
      return true;
    }
  }
  return detail_of_numbers::read_slowly(begin, at, value);
}

}  // namespace whittle::files
