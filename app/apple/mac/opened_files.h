#pragma once
// Files that the Finder opens with the app. GLFW, which owns the app delegate, does not report them.

#include <functional>
#include <string>
#include <vector>

namespace nacre::app {

/// Starts to listen. Call before glfwInit(), when the app has not finished launching: the file that started the
/// app is reported during launch.
/// @param opened called on the main thread as files arrive
void listenForOpenedFiles(std::function<void()> opened);

/// Paths that arrived since the last call.
std::vector<std::string> takeOpenedFiles();

}  // namespace nacre::app
