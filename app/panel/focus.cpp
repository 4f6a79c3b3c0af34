#include "app/panel/focus.h"

#include <imgui.h>
#include <imgui_internal.h>  // Dear ImGui's own Tab goes to fields alone

namespace nacre::app {

void focusLastItem() {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    if (g.LastItemData.ID == 0) return;
    ImGui::ClearActiveID();  // a field that was typed into
    ImGui::SetFocusID(g.LastItemData.ID, g.CurrentWindow);
#if IMGUI_VERSION_NUM < 19140
    g.NavDisableHighlight = false;
    g.NavDisableMouseHover = true;
#else
    g.NavCursorVisible = true;
    g.NavHighlightItemUnderNav = true;
#endif
    ImGui::ScrollToItem();
}

}  // namespace nacre::app
