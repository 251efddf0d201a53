#include <sstream>

#include "report/Report.hh"

namespace whittle::bench {
namespace {

/// What would be read as Markdown is escaped, back quotes stay.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "&lt;";
      continue;
    }
    if (c == '|' || c == '[' || c == ']' || c == '*' || c == '_' || c == '\\') safe += '\\';
    safe += c == '\n' ? ' ' : c;
  }
  return safe;
}

class MarkdownWriter {
 public:
  explicit MarkdownWriter(std::ostream& out) : out_(out) {}

  void operator()(const Paragraph& paragraph) { out_ << escaped(paragraph.text) << "\n\n"; }
  void operator()(const Callout& callout) { out_ << "> **Note:** " << escaped(callout.text) << "\n\n"; }

  void operator()(const Table& table) {
    if (!table.caption.empty()) out_ << "*" << escaped(table.caption) << "*\n\n";
    line(table.header);
    for (std::size_t i = 0; i < table.header.size(); ++i) out_ << (i < table.text_columns ? "|---" : "|--:");
    out_ << "|\n";
    for (const auto& row : table.rows) line(row);
    out_ << "\n";
  }

  void operator()(const Chart& chart) {
    out_ << "![" << escaped(chart.caption) << "](charts/" << chart.name << ".svg)\n\n*"
         << escaped(chart.caption) << "*\n\n";
  }

  void operator()(const Gallery& gallery) {
    const std::size_t columns = gallery.large ? 2 : 4;
    out_ << "*" << escaped(gallery.caption) << "*\n\n";
    for (std::size_t i = 0; i < gallery.pictures.size(); i += columns) {
      std::vector<std::string> images(columns), captions(columns);
      for (std::size_t k = 0; k < columns && i + k < gallery.pictures.size(); ++k) {
        const Picture& picture = gallery.pictures[i + k];
        captions[k] = escaped(picture.caption);
        images[k] = "![" + captions[k] + "](" + picture.file + ")";
      }
      raw_line(captions);
      for (std::size_t k = 0; k < columns; ++k) out_ << "|---";
      out_ << "|\n";
      raw_line(images);
      out_ << "\n";
    }
  }

 private:
  void line(std::vector<std::string> cells) {
    for (auto& cell : cells) cell = escaped(cell);
    raw_line(cells);
  }
  void raw_line(const std::vector<std::string>& cells) {
    for (const auto& cell : cells) out_ << "| " << cell << " ";
    out_ << "|\n";
  }

  std::ostream& out_;
};

}  // namespace

std::string markdown_text(const Document& document) {
  std::ostringstream out;
  out << "# " << escaped(document.title) << "\n\n" << escaped(document.summary) << "\n\n";
  MarkdownWriter writer(out);
  for (const Section& section : document.sections) {
    out << "## " << escaped(section.title) << "\n\n";
    for (const Block& block : section.blocks) std::visit(writer, block);
  }
  std::string text = out.str();
  text.pop_back();  // one line break at the end is enough
  return text;
}

}  // namespace whittle::bench
