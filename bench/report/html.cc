#include <fstream>
#include <iterator>
#include <sstream>

#include "chart/Svg.hh"
#include "papers/Verdict.hh"
#include "report/Report.hh"
#include "report/base64.hh"
#include "report/style.hh"

namespace whittle::bench {
namespace {

using chart::escape;

/// Text with `code` set as such.
std::string marked(const std::string& text) {
  std::string out;
  bool code = false;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('`', begin), text.size());
    const std::string part = escape(text.substr(begin, end - begin));
    out += code ? "<code>" + part + "</code>" : part;
    code = !code;
    begin = end + 1;
  }
  return out;
}

std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string badge(const std::string& verdict) {
  const char* style = "";
  if (verdict == to_string(Word::holds)) style = " good";
  if (verdict == to_string(Word::fails) || verdict == to_string(Word::less)) style = " bad";
  if (verdict == to_string(Word::more)) style = " odd";
  return std::string("<span class=\"badge") + style + "\">" + escape(verdict) + "</span>";
}

class HtmlWriter {
 public:
  HtmlWriter(std::ostream& out, const std::filesystem::path& folder) : out_(out), folder_(folder) {}

  void operator()(const Paragraph& paragraph) { out_ << "<p>" << marked(paragraph.text) << "</p>\n"; }
  void operator()(const Callout& callout) {
    out_ << "<div class=\"note\">" << marked(callout.text) << "</div>\n";
  }

  void operator()(const Table& table) {
    out_ << "<figure>";
    caption(table.caption);
    out_ << "<div class=\"scroll\"><table>\n";
    bool headed = false;
    for (const auto& cell : table.header) headed |= !cell.empty();
    if (headed) {
      out_ << "<thead><tr>";
      for (std::size_t i = 0; i < table.header.size(); ++i)
        out_ << (i < table.text_columns ? "<th class=\"t\" scope=\"col\">" : "<th scope=\"col\">")
             << escape(table.header[i]) << "</th>";
      out_ << "</tr></thead>\n";
    }
    out_ << "<tbody>\n";
    for (const auto& row : table.rows) {
      out_ << "<tr>";
      for (std::size_t i = 0; i < row.size(); ++i) {
        const std::string& head = table.header[i];
        out_ << (i < table.text_columns ? "<td class=\"t\">" : "<td>")
             << (head == "Verdict" ? badge(row[i]) : marked(row[i])) << "</td>";
      }
      out_ << "</tr>\n";
    }
    out_ << "</tbody></table></div></figure>\n";
  }

  void operator()(const Chart& chart) {
    out_ << "<figure class=\"chart\" id=\"" << chart.name << "\">";
    caption(chart.caption);
    out_ << "<div class=\"scroll\">" << chart.svg << "</div></figure>\n";
  }

  void operator()(const Gallery& gallery) {
    out_ << "<figure>";
    caption(gallery.caption);
    out_ << "<div class=\"sheet" << (gallery.large ? " large" : "") << "\">\n";
    for (const Picture& picture : gallery.pictures) {
      const std::string bytes = read_bytes(folder_ / picture.file);
      out_ << "<div>";
      if (bytes.empty())
        out_ << "<div class=\"missing\">" << escape(picture.file) << " is not there</div>";
      else
        out_ << "<img alt=\"" << escape(picture.caption) << "\" src=\"data:image/png;base64," << base64(bytes)
             << "\">";
      out_ << "<span>" << escape(picture.caption) << "</span></div>\n";
    }
    out_ << "</div></figure>\n";
  }

 private:
  void caption(const std::string& text) {
    if (!text.empty()) out_ << "<figcaption>" << marked(text) << "</figcaption>\n";
  }

  std::ostream& out_;
  const std::filesystem::path& folder_;
};

}  // namespace

std::string html_text(const Document& document, const std::filesystem::path& folder) {
  std::ostringstream out;
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>"
      << escape(document.title) << "</title>\n<style>" << kStyle << "</style>\n</head>\n<body>\n<header><h1>"
      << escape(document.title) << "</h1>\n<p class=\"summary\">" << escape(document.summary)
      << "</p>\n<nav>";
  for (const Section& section : document.sections)
    out << "<a href=\"#" << section.id << "\">" << escape(section.title) << "</a>";
  out << "</nav></header>\n<main>\n";
  HtmlWriter writer(out, folder);
  for (const Section& section : document.sections) {
    out << "<section id=\"" << section.id << "\"><h2>" << escape(section.title) << "</h2>\n";
    for (const Block& block : section.blocks) std::visit(writer, block);
    out << "</section>\n";
  }
  out << "</main>\n<footer>Made by whittle-bench. The raw times are in results.json beside this "
         "page.</footer>\n"
         "</body>\n</html>\n";
  return out.str();
}

}  // namespace whittle::bench
