/// \file
/// A report before it is a page: sections of paragraphs, tables, charts and pictures. It is written once and
/// printed as HTML and as Markdown.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace whittle::bench {

/// Plain text; `code` between back quotes is all the markup there is.
struct Paragraph {
  std::string text;
};

/// Something that the reader must not miss.
struct Callout {
  std::string text;
};

struct Table {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the header
  std::size_t text_columns = 1;                ///< set left; the columns after these are figures, set right
};

struct Chart {
  std::string name;  ///< of the file beside a Markdown report; unique in the document
  std::string caption;
  std::string svg;
};

struct Picture {
  std::string file;  ///< PNG, relative to the results
  std::string caption;
};

/// Pictures side by side: a contact sheet.
struct Gallery {
  std::string caption;
  std::vector<Picture> pictures;
  bool large = false;  ///< two to a row rather than many
};

using Block = std::variant<Paragraph, Callout, Table, Chart, Gallery>;

struct Section {
  std::string id;
  std::string title;
  std::vector<Block> blocks;
};

struct Document {
  std::string title;
  std::string summary;  ///< one line under the title
  std::vector<Section> sections;
};

}  // namespace whittle::bench
