#pragma once
// Files that the Finder opens with the app. GLFW, whose app delegate the app has, does not tell of them.

#include <functional>
#include <string>
#include <vector>

namespace nacre::app {

/// Starts to listen. Call before the app has finished launching, that is before glfwInit(): a file that the app was
/// started with is told while it launches.
/// @param opened called on the main thread as files come
void listenForOpenedFiles(std::function<void()> opened);

/// Paths that came since the last call.
std::vector<std::string> takeOpenedFiles();

}  // namespace nacre::app
