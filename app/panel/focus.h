#pragma once

namespace nacre::app {

/// Gives the keyboard's focus to the item that was drawn last, and scrolls to it.
void focusLastItem();

}  // namespace nacre::app
