#pragma once

namespace nacre::app {

/// From here on, what this program's libraries listen on is this machine alone: bind() to any address becomes one to
/// the loopback. RenderDoc, once it is loaded, listens for its user interface on all addresses, without asking for a
/// word. What was bound before, by a RenderDoc that started this program, stays as it is.
void listenOnLoopbackAlone();
/// Takes that back: what `nacre serve` is asked to listen on is meant.
void listenAnywhere();

}  // namespace nacre::app
