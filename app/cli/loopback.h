#pragma once

namespace nacre::app {

/// From now on libraries of this program listen on this machine only: bind() to any address becomes the loopback
/// address. RenderDoc listens for its user interface on all addresses, without asking. Earlier sockets, of a RenderDoc
/// that started this program, stay as they are.
void listenOnLoopbackAlone();
/// Ends that: `nacre serve` listens on the address that it is given.
void listenAnywhere();

}  // namespace nacre::app
