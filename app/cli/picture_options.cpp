#include "app/cli/picture_options.h"

#include "app/cli/movie_options.h"
#include "app/movie/movie_file.h"

namespace nacre::app {
namespace {

constexpr Topics kShading = Topic::background | Topic::lighting | Topic::occlusion | Topic::effects;
constexpr Topics kDevice = Topic::device | Topic::path | Topic::frame | Topic::validation;
constexpr Topics kContent = kReading | kAppearance;
constexpr Topics kSeen = kContent | kShading | Topic::camera | Topic::aim | Topic::words;

std::string writtenName(const Option& option) {
    const std::string key(option.key);
    if (!option.positional) return (option.letter.empty() ? "--" : "-" + std::string(option.letter) + ",--") + key;
    std::string name = key;
    for (char& c : name) c = static_cast<char>(c - 'a' + 'A');
    return name;
}

}  // namespace

void addPicture(CommandSpec& command, PictureDescription& picture, Topics topics, std::vector<OptionValue>* given) {
    for (const Option& option : options()) {
        if (!has(topics, option.topic)) continue;
        OptionSpec& spec = command.add({writtenName(option), option.syntax,
                                        option.standard == "=" ? option.print(picture) : option.standard, option.help,
                                        [&option, &picture, given](const std::string& text) {
                                            setOption(option, text, picture);
                                            if (given) given->push_back({std::string(option.key), text});
                                        }});
        spec.required = option.required;
        spec.repeatable = option.kind == Option::Kind::list;
        spec.pair = option.kind == Option::Kind::pair;
        spec.bare = option.bare;
        if (!option.excludes.empty()) spec.excludes = "--" + std::string(option.excludes);
        spec.choices = option.choices;
    }
}

void addInputs(CommandSpec& command, std::vector<std::string>& paths, PictureDescription& picture) {
    addPicture(command, picture, Topic::input | Topic::reading);
    OptionSpec& input = command.options.front();
    input.help =
        input.help.substr(0, input.help.find(" Several form one picture")) + " Several are processed one by one";
    input.set = [&](const std::string& text) { paths.push_back(text); };
    input.required = true;
}

void addRender(CommandSpec& command, PictureDescription& picture) { addPicture(command, picture, kEveryTopic); }

void addMovie(CommandSpec& command, MovieOptions& options) {
    PictureDescription& picture = options.picture;
    command
        .value("-o,--output", "FILE|FOLDER/", "",
               "The movie: .mp4, .webm (both by ffmpeg), .gif, .png (animated); or a folder of PNG frames;\n"
               "- is an animated PNG to standard output",
               [&](const std::string& text) {
                   if (!isMovieName(text)) refuseEnding(text, movieEndings(), ", or a folder");
                   picture.output = text;
               })
        .required = true;
    addMotion(command, options);
    addPicture(
        command, picture,
        kSeen | Topic::view | Topic::look | Topic::detail | Topic::size | Topic::samples | Topic::levels | kDevice,
        &options.given);
}

void addWindow(CommandSpec& command, PictureDescription& first) {
    first.size = {1280, 800};
    addPicture(command, first, kSeen | Topic::view | Topic::look | Topic::size | Topic::debug | kDevice);
    command.value("--stats", "FILE", "none",
                  "Frames, times and memory as JSON when the window closes; - for standard output",
                  [&](const std::string& text) { first.stats = fileName(text); });
    command.flag("--capture", first.device.capture,
                 "Load RenderDoc, so that F12 captures a frame; it listens on this machine only");
}

void addLooks(CommandSpec& command, LooksOptions& options) {
    PictureDescription& picture = options.picture;
    picture.size = {384, 384};
    addPicture(command, picture,
               kContent | Topic::camera | Topic::aim | Topic::occlusion | Topic::size | Topic::samples | kDevice);
    OptionSpec output{"-o,--output", "FILE", "", option("output").help,
                      [&](const std::string& text) { option("output").parse(text, picture); }};
    command.add(output);
    command.value("--columns", "N", "4", "Looks per row of the sheet, 1 to 16",
                  [&](const std::string& text) { options.columns = static_cast<int>(parseInteger(text, 1, 16)); });
    command.flag("--json", options.json, "All looks as one JSON object; each works as --look FILE");
}

}  // namespace nacre::app
