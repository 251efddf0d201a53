/// \file
/// The commands of a script that need no window.
#pragma once

#include "model/Script.hh"
#include "model/Session.hh"
#include "model/View.hh"

namespace whittle::viewer {

/// Does the command if it is about the session or the view; false if it is the window's.
/// \param aspect  of a view, for the camera.
/// \throw ScriptError  it cannot be done.
bool perform(const Command& command, Session& session, View& view, double aspect);

}  // namespace whittle::viewer
