#include "cli/LevelTargets.hh"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "cli/RecipeOptions.hh"
#include "recipe/Recipe.hh"

namespace whittle::cli {
namespace {

constexpr std::size_t kMostLevels = 31;  // behind the model

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text + ",");
  for (std::string word; std::getline(in, word, ',');) out.push_back(word);
  if (out.size() > kMostLevels) throw recipe::RecipeError("more than 32 levels");
  return out;
}

double share_of(std::string word) {
  const std::string error = share()(word);
  if (!error.empty()) throw recipe::RecipeError("--ratio: " + error);
  double value = 0;
  const char* end = word.data() + word.size();
  const auto [rest, code] = std::from_chars(word.data(), end, value);
  if (code != std::errc() || rest != end || !(value > 0 && value < 1))
    throw recipe::RecipeError("--ratio: '" + word + "' is not above 0 and below 1");
  return value;
}

std::size_t faces_in(const std::string& word) {
  std::size_t value = 0;
  const char* end = word.data() + word.size();
  const auto [rest, code] = std::from_chars(word.data(), end, value);
  if (code != std::errc() || rest != end || value == 0)
    throw recipe::RecipeError("--faces: '" + word + "' is no number of faces");
  return value;
}

template <typename Number>
void check_falling(const char* option, const std::vector<Number>& values) {
  for (std::size_t i = 1; i < values.size(); ++i)
    if (!(values[i] < values[i - 1]))
      throw recipe::RecipeError(std::string(option) +
                                ": each level must have fewer faces than the one before");
}

}  // namespace

std::size_t LevelTargets::faces_of(std::size_t level, std::size_t faces_of_model) const {
  if (!counts.empty()) return counts[level - 1];
  const double share =
      ratios.empty() ? std::pow(step.value_or(0.5), static_cast<double>(level)) : ratios[level - 1];
  return std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(faces_of_model)));
}

LevelTargets parse_levels(const std::string& ratios, const std::string& counts) {
  LevelTargets targets;
  if (!counts.empty()) {
    for (const std::string& word : split_at_commas(counts)) targets.counts.push_back(faces_in(word));
    check_falling("--faces", targets.counts);
    return targets;
  }
  for (const std::string& word : split_at_commas(ratios)) targets.ratios.push_back(share_of(word));
  check_falling("--ratio", targets.ratios);
  if (targets.ratios.size() > 1) return targets;
  targets.step = targets.ratios.front();
  targets.ratios.clear();
  if (*targets.step < 0.01 || *targets.step > 0.99)
    throw recipe::RecipeError("--ratio: the step from level to level must be from 0.01 to 0.99");
  return targets;
}

}  // namespace whittle::cli
