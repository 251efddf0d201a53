/// \file
/// The tags of an XML document that is in memory.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace whittle::files {

/// Goes from tag to tag. Text between them, comments and instructions are passed over; names are without the prefix of
/// their namespace. Of a document type nothing is read, so nothing in it can multiply.
class XmlReader {
 public:
  /// \param text  which must outlive this
  explicit XmlReader(std::string_view text) : text_(text) {}

  /// Goes to the next tag that opens an element or closes one; false at the end. \throw Fault  damaged
  bool next();

  std::string_view name() const { return name_; }
  bool opens() const { return opens_; }
  bool closes() const { return closes_; }  ///< an element without content does both

  /// As it stands in the document, empty where there is none.
  std::string_view attribute(std::string_view name) const;
  bool has(std::string_view name) const;

 private:
  void skip_behind(std::string_view end);
  void read_tag();
  std::string_view read_name();
  void skip_blanks();

  std::string_view text_;
  std::size_t at_ = 0;
  std::string_view name_;
  std::vector<std::pair<std::string_view, std::string_view>> attributes_;
  bool opens_ = false, closes_ = false;
};

}  // namespace whittle::files
