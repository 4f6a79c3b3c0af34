#include "app/viewer/commands.h"

namespace nacre::app {
namespace {

using C = ViewerCommand;

constexpr KeyEvent key(char32_t k) { return {k, {}}; }
constexpr KeyEvent key(SpecialKey k) { return {toKey(k), {}}; }
constexpr KeyEvent shift(SpecialKey k) { return {toKey(k), {true, false}}; }

constexpr KeyEvent control(char32_t k) { return {k, {false, true}}; }

constexpr Binding kBindings[] = {
    {C::rotateLeft, key(SpecialKey::left), "Left", "Rotate left"},
    {C::rotateRight, key(SpecialKey::right), "Right", "Rotate right"},
    {C::rotateUp, key(SpecialKey::up), "Up", "Rotate up"},
    {C::rotateDown, key(SpecialKey::down), "Down", "Rotate down"},
    {C::panLeft, shift(SpecialKey::left), "Shift Left", "Move left"},
    {C::panRight, shift(SpecialKey::right), "Shift Right", "Move right"},
    {C::panUp, shift(SpecialKey::up), "Shift Up", "Move up"},
    {C::panDown, shift(SpecialKey::down), "Shift Down", "Move down"},
    {C::zoomIn, key(U'+'), "+", "Zoom in"},
    {C::zoomIn, key(U'='), "=", "Zoom in"},
    {C::zoomOut, key(U'-'), "-", "Zoom out"},
    {C::rollLeft, key(U','), ",", "Roll to the left"},
    {C::rollRight, key(U'.'), ".", "Roll to the right"},
    {C::fit, key(U'f'), "F", "Show the whole molecule"},
    {C::reset, key(SpecialKey::home), "Home", "Reset view"},
    {C::orient, key(U'a'), "A", "Align to principal axes"},
    {C::lookAt, key(U't'), "T", "Turn the picked atoms, or the ligand, to the front"},
    {C::zoomTo, key(U'z'), "Z", "Zoom to the picked atoms, or the ligand"},
    {C::autoRotate, key(U' '), "Space", "Spin, or stop"},
    {C::rock, key(U'j'), "J", "Rock, or stop"},
    {C::nextModel, key(U']'), "]", "Next model or frame"},
    {C::previousModel, key(U'['), "[", "Previous model or frame"},
    {C::firstModel, key(U'{'), "{", "First model or frame"},
    {C::lastModel, key(U'}'), "}", "Last model or frame"},
    {C::playModels, key(U'g'), "G", "Play models or frames, or stop"},
    {C::slower, key(U'<'), "<", "Play slower"},
    {C::faster, key(U'>'), ">", "Play faster"},
    {C::spacefill, key(U'1'), "1", "Space-filling"},
    {C::ballAndStick, key(U'2'), "2", "Ball and stick"},
    {C::licorice, key(U'3'), "3", "Licorice"},
    {C::cartoon, key(U'4'), "4", "Cartoon"},
    {C::surface, key(U'5'), "5", "Surface"},
    {C::nextColor, key(U'c'), "C", "Next colouring"},
    {C::nextPreset, key(U'n'), "N", "Next preset"},
    {C::nextLook, key(U'k'), "K", "Next look"},
    {C::nextBackground, key(U'b'), "B", "Next background"},
    {C::water, key(U'w'), "W", "Show or hide water"},
    {C::hydrogens, key(U'h'), "H", "Show or hide hydrogens"},
    {C::perspective, key(U'v'), "V", "Perspective or orthographic"},
    {C::stereo, key(U's'), "S", "Stereo: off, anaglyph, side by side ..."},
    {C::lighting, key(U'l'), "L", "Lighting on or off"},
    {C::occlusion, key(U'o'), "O", "Ambient occlusion on or off"},
    {C::measure, key(U'u'), "U", "Measure distances, angles, torsions; then stop measuring"},
    {C::keepMeasurement, key(U'p'), "P", "Pin the measurement to the picture"},
    {C::legend, key(U'e'), "E", "Show or hide the legend"},
    {C::scaleBar, key(U'r'), "R", "Scale bar: none, in Å, in nm"},
    {C::clearPicks, key(SpecialKey::escape), "Esc", "Clear the selection; then leave measuring"},
    {C::savePicture, key(U'i'), "I", "Save image as PNG"},
    {C::saveView, {U's', {true, false}}, "Shift S", "Save this view, for nacre render --view"},
    {C::saveScene, {U's', {true, true}}, "Ctrl Shift S", "Save as a MolViewSpec scene"},
    {C::keepView, key(U'd'), "D", "Add keyframe"},
    {C::record, {U'r', {true, false}}, "Shift R", "Record movie"},
    {C::openFile, control(U'o'), "Ctrl O", "Open a file"},
    {C::saveAs, control(U's'), "Ctrl S", "Save image as ..."},
    {C::copyPicture, control(U'c'), "Ctrl C", "Copy the image"},
    {C::undo, control(U'z'), "Ctrl Z", "Undo"},
    {C::redo, {U'z', {true, true}}, "Ctrl Shift Z", "Redo"},
    {C::redo, control(U'y'), "Ctrl Y", "Redo"},
    {C::captureFrame, key(SpecialKey::f12), "F12", "Capture a frame for RenderDoc", false},
    {C::panel, key(U'm'), "M", "Show or hide the panel"},
    {C::fullScreen, key(SpecialKey::f11), "F11", "Full screen, or back"},
    {C::palette, control(U'k'), "Ctrl K", "Find a command or option"},
    {C::palette, key(U'/'), "/", "Find a command or option"},
    {C::help, key(U'?'), "?", "This help"},
    {C::help, key(SpecialKey::f1), "F1", "This help"},
    {C::quit, control(U'q'), "Ctrl Q", "Quit"},
};

constexpr PointerBinding kPointer[] = {
    {"drag", "one finger", "Rotate (1° per pixel)"},
    {"right drag, Shift drag", "two fingers", "Move"},
    {"wheel, scroll", "pinch", "Zoom about the pointer"},
    {"Ctrl wheel", nullptr, "Contour level of the first density map"},
    {"Ctrl drag", "twist", "Roll"},
    {"click", "tap, long press", "Identify an atom and select its residue, or measure"},
    {"right click", nullptr, "Actions for a residue, its chain, or the picture"},
    {"double click", "double tap", "Zoom to a residue; off the molecule, to all of it"},
    {nullptr, "three fingers", "To the left: undo; to the right: redo"},
};

}  // namespace

std::span<const Binding> keyBindings() { return kBindings; }
std::span<const PointerBinding> pointerBindings() { return kPointer; }

std::optional<ViewerCommand> findCommand(const KeyEvent& event) {
    const bool letter = event.key >= U'a' && event.key <= U'z';
    for (const Binding& b : kBindings) {
        // Characters such as '?' need Shift on some layouts only.
        const bool shiftCounts = letter || event.key >= toKey(SpecialKey::left);
        if (b.key.key == event.key && b.key.with.control == event.with.control &&
            (!shiftCounts || b.key.with.shift == event.with.shift))
            return b.command;
    }
    return std::nullopt;
}

}  // namespace nacre::app
