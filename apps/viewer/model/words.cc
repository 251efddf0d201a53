#include "model/words.hh"

namespace whittle::viewer {
namespace {

constexpr char kBlanks[] = " \t\r\n";
constexpr char kPlain[] =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
    "@%+=:,./_-";

/// Appends what stands in quotes from `at` on; leaves `at` behind the closing one.
void take_quoted(const std::string& text, std::size_t& at, std::string& word) {
  const char mark = text[at++];
  while (at < text.size() && text[at] != mark) {
    if (mark == '"' && text[at] == '\\' && at + 1 < text.size()) ++at;
    word += text[at++];
  }
  if (at == text.size()) throw WordsError(std::string("a quote ") + mark + " is not closed");
  ++at;
}

std::string take_word(const std::string& text, std::size_t& at) {
  std::string word;
  while (at < text.size() && std::string(kBlanks).find(text[at]) == std::string::npos) {
    if (text[at] == '\'' || text[at] == '"') {
      take_quoted(text, at, word);
    } else if (text[at] == '\\' && at + 1 < text.size()) {
      ++at;
      if (text[at] != '\n') word += text[at];
      ++at;
    } else {
      word += text[at++];
    }
  }
  return word;
}

}  // namespace

std::vector<std::string> split_words(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0;;) {
    at = text.find_first_not_of(kBlanks, at);
    if (at == std::string::npos) return words;
    if (text[at] == '#') {
      at = text.find('\n', at);
    } else if (text.compare(at, 2, "\\\n") == 0) {
      at += 2;
    } else {
      words.push_back(take_word(text, at));
    }
  }
}

std::string quote(const std::string& word) {
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace whittle::viewer
