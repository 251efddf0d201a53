/// \file
/// The views as a picture off the screen, drawn anew only when it would look different.
#pragma once

#include <cstddef>
#include <optional>

#include "model/Painting.hh"
#include "model/Session.hh"
#include "render/Framebuffer.hh"
#include "window/Scene.hh"

namespace whittle::viewer {

/// A picture is drawn in pieces, with the window's own frames between them, and shown when it is complete;
/// until then the last one stays. Where pictures take longer than there is time, a sketch comes first, so
/// that a turning model is seen to turn. A change gives up the picture that is being drawn. A sketch is drawn
/// to its end, or quick changes would never let one be seen.
class Views {
 public:
  /// \param samples  for each pixel.
  explicit Views(int samples) : samples_(samples) {}

  /// What is to be seen from now on.
  void look_at(const Sight& sight) { wanted_ = sight; }

  /// Draws what is still to be drawn of that, for about so many milliseconds.
  /// \return whether there is another picture to show.
  /// \throw RenderError  it is too large.
  bool paint(double milliseconds, Scene& scene, const Session& session, const Painting::Clock& clock);

  /// Whether the picture that is wanted is complete.
  bool complete() const { return stage_ == Stage::painted && (wanted_ == sight_ || wanted_.empty()); }

  /// Copies the newest complete picture into the window, and leaves its framebuffer bound.
  /// \param height  of the window.
  void show(const Rect& area, int height) const;

  int samples() const { return samples_; }
  std::size_t sketches() const { return sketches_; }  ///< completed so far
  std::size_t pictures() const { return pictures_; }

 private:
  enum class Stage { sketching, sketched, painting, painted };

  void begin(Detail detail, Scene& scene, const Session& session);
  void show_what_there_is();

  int samples_;
  Stage stage_ = Stage::painted;
  Sight wanted_, sight_;         ///< sight_ is that of the painting
  std::size_t models_ = 0;       ///< which model is painted, as the scene counts them
  std::size_t seen_models_ = 0;  ///< and which one is shown
  Painting painting_;
  std::optional<render::Framebuffer> canvas_;  ///< where the painting goes
  std::optional<render::Framebuffer> shown_;   ///< the picture that is shown, one sample a pixel
  bool slow_ = false;                          ///< pictures take longer than there is time
  std::size_t sketches_ = 0, pictures_ = 0;
};

constexpr int kPictureSamples = 4;  ///< for each pixel of a picture that is written

/// Draws a picture at once and whole into a framebuffer of this height, with one sample a pixel.
/// \throw RenderError  it is too large.
void paint_whole(Scene& scene, const Session& session, const Sight& sight, const Rect& area,
                 const render::Framebuffer& framebuffer);

}  // namespace whittle::viewer
