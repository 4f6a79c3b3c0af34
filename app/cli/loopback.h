#pragma once

namespace nacre::app {

/// Makes libraries of this program listen only on this machine from now on: bind() to any address becomes the loopback
/// address. RenderDoc listens for its user interface on all addresses without asking. Earlier sockets, of a RenderDoc
/// that started this program, are unaffected.
void listenOnLoopbackAlone();
/// Ends that: `nacre serve` listens on its given address.
void listenAnywhere();

}  // namespace nacre::app
