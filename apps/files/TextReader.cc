#include "files/TextReader.hh"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "files/Fault.hh"

namespace whittle::files {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// from_chars takes no plus sign, but files have it.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

template <typename Number>
std::from_chars_result read_number(std::string_view word, Number& value) {
  return std::from_chars(word.data(), word.data() + word.size(), value);
}

template <typename Integer>
Integer parse_whole(std::string_view word, const char* what) {
  const std::string_view digits = without_plus(word);
  Integer value = 0;
  const auto [end, error] = read_number(digits, value);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw Fault(std::string("expected ") + what + ", found " + in_quotes(word));
  return value;
}

}  // namespace

bool same_word(std::string_view a, std::string_view b) {
  return a == b || std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
           return std::tolower(x) == std::tolower(y);
         });
}

template <typename Real>
Real parse_real(std::string_view word) {
  const std::string_view digits = without_plus(word);
  Real value = 0;
  auto [end, error] = read_number(digits, value);
  if (error == std::errc::result_out_of_range) {
    // from_chars reports underflow and overflow alike. Cast from a wider type, the one becomes 0, the other
    // infinite.
    long double wide = 0;
    if (read_number(digits, wide).ec != std::errc()) throw Fault(in_quotes(word) + " is out of range");
    value = static_cast<Real>(wide);
  } else if (error != std::errc()) {
    end = nullptr;
  }
  if (end != digits.data() + digits.size()) throw Fault("expected a number, found " + in_quotes(word));
  return value;
}
template float parse_real<float>(std::string_view);
template double parse_real<double>(std::string_view);

std::int64_t parse_integer(std::string_view word) {
  return parse_whole<std::int64_t>(word, "an integer");
}
std::uint64_t parse_count(std::string_view word) {
  return parse_whole<std::uint64_t>(word, "a count");
}

TextReader::TextReader(std::string_view bytes, std::size_t& line, Syntax syntax)
    : bytes_(bytes), line_(line), syntax_(syntax) {
  line_ = 1;
  if (bytes_.substr(0, byte_order_mark.size()) == byte_order_mark) at_ = byte_order_mark.size();
}

bool TextReader::next_line() {
  if (!line_is_fresh_) leave_line();
  while (at_ < bytes_.size()) {
    skip_blanks();
    if (!at_line_end()) {
      line_is_fresh_ = false;
      return true;
    }
    leave_line();
  }
  return false;
}

std::string_view TextReader::word() {
  line_is_fresh_ = false;
  skip_blanks();
  const std::size_t begin = at_;
  while (!at_line_end() && !is_blank(bytes_[at_]) && line_join() == 0) ++at_;
  return bytes_.substr(begin, at_ - begin);
}

std::string_view TextReader::word_anywhere() {
  const std::string_view found = word();
  return found.empty() && next_line() ? word() : found;
}

template <typename Real>
Real TextReader::real() {
  return parse_real<Real>(required_word("a number"));
}
template float TextReader::real<float>();
template double TextReader::real<double>();

std::int64_t TextReader::integer() {
  return parse_integer(required_word("an integer"));
}
std::uint64_t TextReader::count() {
  return parse_count(required_word("a count"));
}

std::string_view TextReader::rest_of_line() {
  line_is_fresh_ = false;
  const std::size_t begin = at_;
  while (at_ < bytes_.size() && bytes_[at_] != '\n' && line_join() == 0) ++at_;
  std::string_view text = bytes_.substr(begin, at_ - begin);
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view TextReader::rest() {
  leave_line();
  return bytes_.substr(at_);
}

void TextReader::skip_blanks() {
  while (at_ < bytes_.size()) {
    if (is_blank(bytes_[at_])) {
      ++at_;
    } else if (const std::size_t length = line_join(); length > 0) {
      at_ += length;
      ++line_;
    } else {
      return;
    }
  }
}

/// The length of the backslash and line end at the current place, 0 if there are none.
std::size_t TextReader::line_join() const {
  if (!syntax_.continuation || bytes_[at_] != '\\') return 0;
  if (bytes_.substr(at_ + 1, 1) == "\n") return 2;
  if (bytes_.substr(at_ + 1, 2) == "\r\n") return 3;
  return 0;
}

bool TextReader::at_line_end() const {
  return at_ == bytes_.size() || bytes_[at_] == '\n' || bytes_[at_] == syntax_.comment;
}

void TextReader::leave_line() {
  // Word by word, because the line may be continued; what is left then is at most a comment, which is not.
  while (!word().empty()) continue;
  const std::size_t end = bytes_.find('\n', at_);
  at_ = end == std::string_view::npos ? bytes_.size() : end + 1;
  if (at_ < bytes_.size()) ++line_;
  line_is_fresh_ = true;
}

std::string_view TextReader::required_word(const char* what) {
  const std::string_view found = word();
  if (found.empty())
    throw Fault(std::string("expected ") + what + ", found the end of the " +
                (at_ == bytes_.size() ? "file" : "line"));
  return found;
}

}  // namespace whittle::files
