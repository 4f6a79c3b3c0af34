#pragma once
// The options of a picture's description, one row each. These rows are the source of: command line, help, manual page,
// completions, batch jobs, Python's arguments, saved views, looks, undo, redrawing, and docs/reference.md. The rows are
// in rows_*.cpp, by subject.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/description.h"

namespace nacre::app {

/// The subject of an option. A command accepts its topics; `nacre help` explains some of them.
enum class Topic : std::uint64_t {
    view = 1 << 0,        ///< saved views
    look = 1 << 1,        ///< several options by one name
    thumbnail = 1 << 2,   ///< several options by one name
    input = 1 << 3,       ///< INPUT
    reading = 1 << 4,     ///< how INPUT is read
    trajectory = 1 << 5,  ///< positions of its atoms
    fit = 1 << 6,         ///< several inputs
    style = 1 << 7,
    color = 1 << 8,
    rules = 1 << 9,
    mesh = 1 << 10,   ///< cartoons and surfaces
    atoms = 1 << 11,  ///< which are drawn
    files = 1 << 12,
    camera = 1 << 13,
    aim = 1 << 14,
    background = 1 << 15,
    lighting = 1 << 16,
    occlusion = 1 << 17,
    effects = 1 << 18,
    words = 1 << 19,
    detail = 1 << 20,  ///< of occlusion
    size = 1 << 21,
    samples = 1 << 22,
    levels = 1 << 23,  ///< of meshes
    paper = 1 << 24,
    debug = 1 << 25,
    device = 1 << 26,
    path = 1 << 27,   ///< how a device draws
    frame = 1 << 28,  ///< likewise, without effect on the picture
    validation = 1 << 29,
    interactions = 1 << 30,
    map = std::uint64_t{1} << 32,       ///< density maps
    geometry = std::uint64_t{1} << 33,  ///< in addition to the molecule
    saved = 1u << 31,                   ///< in saved views only
};
using Topics = std::uint64_t;
constexpr Topics operator|(Topic a, Topic b) { return static_cast<Topics>(a) | static_cast<Topics>(b); }
constexpr Topics operator|(Topics a, Topic b) { return a | static_cast<Topics>(b); }
constexpr bool has(Topics topics, Topic topic) { return (topics & static_cast<Topics>(topic)) != 0; }
constexpr Topics kReading = Topic::input | Topic::reading | Topic::trajectory | Topic::fit;
constexpr Topics kAppearance = Topic::style | Topic::color | Topic::rules | Topic::mesh | Topic::atoms |
                               Topic::interactions | Topic::map | Topic::geometry;
constexpr Topics kEveryTopic = ~static_cast<Topics>(Topic::saved);

/// The part of the work that must be repeated when an option changes.
enum class Facet : unsigned {
    input = 1 << 0,       ///< the molecule is read
    frame = 1 << 7,       ///< a model or frame is chosen, and frames are processed
    scene = 1 << 1,       ///< spheres, sticks and meshes are made
    view = 1 << 2,        ///< the camera
    shading = 1 << 3,     ///< how pixels are shaded
    occlusion = 1 << 8,   ///< baked ambient occlusion
    annotation = 1 << 4,  ///< text in the picture
    file = 1 << 5,        ///< output files
    device = 1 << 6,      ///< the device
    map = 1 << 9          ///< objects drawn in addition to the molecule: contours of density maps, primitives
};
using Facets = unsigned;
constexpr Facets operator|(Facet a, Facet b) { return static_cast<Facets>(a) | static_cast<Facets>(b); }
constexpr Facets operator|(Facets a, Facet b) { return a | static_cast<Facets>(b); }
constexpr bool has(Facets facets, Facet facet) { return (facets & static_cast<Facets>(facet)) != 0; }

struct Option {
    /// The number of its values, and their form in JSON.
    enum class Kind {
        value,    ///< one text; JSON: a text or number
        flag,     ///< none, or "on" and "off"; JSON: a boolean
        list,     ///< one per use; JSON: a list of texts
        pair,     ///< two per use, separated by a line end; JSON: a list of pairs
        numbers,  ///< several, separated by commas; JSON: a list of numbers
        rules,    ///< show, hide and color-by in their common order; JSON: a list of objects
        inputs    ///< further inputs; JSON: a list of objects
    };
    enum class Number { none, whole, real };
    /// When a saved view includes it.
    enum class Save { never, differing, always, withTrajectory };

    std::string_view key = {};  ///< "contours": --contours, "contours" in JSON, contours= in Python
    std::string syntax = {};    ///< of the value, for the help; empty: a flag
    std::string standard = {};  ///< default, for the help; "=": from print()
    std::string help = {};      ///< '\n' is a possible line break
    Topic topic = Topic::saved;
    Facet facet = Facet::file;
    struct Access {
        /// Reads a value; adds one to a list, or clears the list for "". @throws std::invalid_argument with text that
        /// continues "--key: ", or Error
        std::function<void(std::string_view text, PictureDescription&)> parse = nullptr;
        /// The text that parse() reads; lists have one line per value. Null: the option sets others.
        std::function<std::string(const PictureDescription&)> print = nullptr;
    } value = {};

    Kind kind = Kind::value;
    Save save = Save::never;
    Number number = Number::none;    ///< type in saved views, if it is a number
    bool look = false;               ///< part of a look
    std::string_view savedAs = {};   ///< key in saved views; empty: `key`
    std::string_view needs = {};     ///< an option without which this one has no effect
    std::string_view excludes = {};  ///< an option that cannot be combined with this one
    std::string_view bare = {};      ///< value of the option's name alone
    std::string_view letter = {};    ///< "-o"
    bool positional = false;         ///< INPUT
    bool required = false;
    std::vector<std::string> choices = {};  ///< some of its values, for completion

    /// Its control in the panel, if any.
    struct Control {
        struct Choice {
            const char* label;
            std::string value;
            const char* meaning = "";  ///< a sentence about pictures with it
            const char* heading = "";  ///< of its legend; empty: the value
        };
        const char* label = nullptr;
        double low = 0, high = 0;          ///< of a slider
        const char* shown = nullptr;       ///< printf format of the value
        std::vector<Choice> choices = {};  ///< of a list; for a switch two: off, and on
    } control = {};

    std::string_view savedKey() const { return savedAs.empty() ? key : savedAs; }
};

/// In the order of help and saved views.
std::span<const Option> options();
/// Null if there is none. @param topics  to search
const Option* findOption(std::string_view key, Topics topics = kEveryTopic);
/// An option that must exist.
const Option& option(std::string_view key);

/// Sets a value and records that it was given. @throws as Option::parse
void setOption(const Option& option, std::string_view text, PictureDescription& description);

/// Index of its value among the choices of its control; their number for any other value.
std::size_t chosen(const Option& option, const PictureDescription& description);
/// Sets the next choice; the first if the current value is no choice. @returns its index
std::size_t stepOption(const Option& option, PictureDescription& description);

/// The parts of the work that differ between two descriptions.
Facets difference(const PictureDescription& a, const PictureDescription& b);

}  // namespace nacre::app
