/// \file
/// Builds a JSON document from parser events, without the values that are not wanted.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace whittle::files {

/// A receiver for nlohmann's `sax_parse`. The parser that takes a callback looks through the whole list again
/// at the end of each object in it, which takes time with the square of its length.
/// \tparam Wanted  called with the depth, 1 in the outermost object, and each key; false: its value is left
///                 out and looked into no further.
template <typename Wanted>
class GltfParser {
 public:
  using Json = nlohmann::json;
  using number_integer_t = Json::number_integer_t;
  using number_unsigned_t = Json::number_unsigned_t;
  using number_float_t = Json::number_float_t;
  using string_t = Json::string_t;
  using binary_t = Json::binary_t;

  explicit GltfParser(Wanted wanted) : wanted_(std::move(wanted)) {}

  Json take() { return std::move(root_); }

  bool null() { return scalar(nullptr); }
  bool boolean(bool value) { return scalar(value); }
  bool number_integer(number_integer_t value) { return scalar(value); }
  bool number_unsigned(number_unsigned_t value) { return scalar(value); }
  bool number_float(number_float_t value, const string_t&) { return scalar(value); }
  bool string(string_t& value) { return scalar(std::move(value)); }
  bool binary(binary_t&) { return false; }  // not in text

  bool start_object(std::size_t) { return open(Json::object()); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_array() { return close(); }

  bool key(string_t& key) {
    if (skipped_ > 0) return true;
    skips_next_ = !wanted_(static_cast<int>(open_.size()), key);
    if (!skips_next_) value_ = &(*open_.back())[std::move(key)];
    return true;
  }

  template <typename Error>
  bool parse_error(std::size_t, const std::string&, const Error&) {
    return false;
  }

 private:
  /// Where the value that begins goes.
  Json& place(Json&& value) {
    if (open_.empty()) return root_ = std::move(value);
    if (!open_.back()->is_array()) return *value_ = std::move(value);
    open_.back()->push_back(std::move(value));
    return open_.back()->back();
  }

  template <typename Value>
  bool scalar(Value&& value) {
    if (skipped_ == 0 && !std::exchange(skips_next_, false)) place(Json(std::forward<Value>(value)));
    return true;
  }

  bool open(Json&& empty) {
    if (skipped_ > 0 || std::exchange(skips_next_, false))
      ++skipped_;
    else
      open_.push_back(&place(std::move(empty)));
    return true;
  }

  bool close() {
    if (skipped_ > 0)
      --skipped_;
    else
      open_.pop_back();
    return true;
  }

  Wanted wanted_;
  Json root_;
  std::vector<Json*> open_;  // lists and objects that have begun
  Json* value_ = nullptr;    // of the last key
  bool skips_next_ = false;  // the value of the last key is left out
  std::size_t skipped_ = 0;  // lists and objects that have begun within one that is left out
};

}  // namespace whittle::files
