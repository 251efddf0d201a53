#include "model/View.hh"

namespace whittle::viewer {
namespace {

constexpr Layout kLayouts[] = {Layout::side_by_side, Layout::split, Layout::original, Layout::result};
constexpr Shading kShadings[] = {Shading::smooth, Shading::flat, Shading::wires, Shading::wires_over};

template <typename Choice, std::size_t n>
std::optional<Choice> named(const Choice (&choices)[n], const std::string& wanted) {
  for (const Choice choice : choices)
    if (word(choice) == wanted) return choice;
  return std::nullopt;
}

}  // namespace

bool View::operator==(const View& other) const {
  return layout == other.layout && shading == other.shading && heat == other.heat &&
         heat_top == other.heat_top && edges == other.edges && feature_angle == other.feature_angle &&
         plan == other.plan && split == other.split && orbit == other.orbit;
}

const char* word(Layout layout) {
  constexpr const char* kWords[] = {"side-by-side", "split", "original", "result"};
  return kWords[static_cast<std::size_t>(layout)];
}

const char* word(Shading shading) {
  constexpr const char* kWords[] = {"smooth", "flat", "wires", "wires-over"};
  return kWords[static_cast<std::size_t>(shading)];
}

std::optional<Layout> layout_named(const std::string& wanted) {
  return named(kLayouts, wanted);
}

std::optional<Shading> shading_named(const std::string& wanted) {
  return named(kShadings, wanted);
}

}  // namespace whittle::viewer
