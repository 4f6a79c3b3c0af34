#pragma once
// The pictures of a movie, drawn by renderers that are kept between frames.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "app/cli/movie_options.h"
#include "app/cli/progress.h"
#include "app/drawing/drawing.h"
#include "engine/molecule/model_file.h"
#include "engine/molecule/trajectory/motion.h"
#include "engine/results.h"

namespace nacre::app {

/// The source of a movie's pictures.
class MovieSource {
public:
    virtual ~MovieSource() = default;
    virtual std::uint64_t frames() const = 0;
    /// A frame, 0..frames() - 1, in any order. @throws Error
    virtual Picture draw(std::uint64_t frame) = 0;
    /// The model, record, frame of a trajectory or snapshot that a frame shows, from 1; none if all show the same.
    virtual std::optional<int> shownModel(std::uint64_t frame) const = 0;
    /// Called with the finished share while occlusion is baked.
    std::function<void(double)> onBake;
};

/// A cross-fade. @param share  of the second
Picture mixed(Picture a, const Picture& b, float share);

/// Whether any background, of the options or of a key view, is not opaque. @throws Error
bool isTransparent(const MovieOptions& options);

class MovieScenes : public MovieSource {
public:
    /// Reads the molecule. @param options, progress  outlive this @throws Error
    MovieScenes(const MovieOptions& options, Progress& progress);
    ~MovieScenes() override;

    std::uint64_t frames() const override { return frames_; }
    /// In sequence, words follow their atoms.
    Picture draw(std::uint64_t frame) override;
    std::optional<int> shownModel(std::uint64_t frame) const override;

private:
    /// An appearance: key views that differ only in their cameras share it.
    struct Look {
        PictureDescription options;
        Drawing drawing;
        std::unique_ptr<Canvas> canvas;
        int model = 0;                                  ///< prepared for this model; 0: none yet
        std::map<Style, std::optional<Bounds>> frames;  ///< shared camera of the models
        bool framed = false;                            ///< the current model has a shared camera
        std::shared_ptr<WordMemory> wordMemory = std::make_shared<WordMemory>();
    };
    struct Key {
        std::size_t look = 0;
        View view;  ///< its own, unmodified
        Clip clip;
    };

    void addLook(const PictureDescription& options);
    void layModels(const InputOptions& input);
    void layMorph(const InputOptions& input);
    void addKeys();
    Look& ready(std::size_t look, int model);
    void takeRange(const std::string& path);
    std::optional<Bounds> findFrame(Look& look) const;
    void setMovingOcclusion(OcclusionSettings& occlusion) const;
    void letGo(std::size_t a, std::size_t b);
    void forgetWords();
    Picture drawKeys(double place, int model);
    void moveTo(Look& look, int frame);
    void sweepTo(Look& look, double time);
    bool severalModels() const { return options_.models != MovieModels::one; }
    int modelAt(std::uint64_t frame) const;

    const MovieOptions& options_;
    Progress& progress_;
    Molecule molecule_;                ///< the last model read
    int molecules_ = 0;                ///< its number
    std::unique_ptr<ModelFile> file_;  ///< of the models
    std::unique_ptr<Motion> motion_;   ///< of a trajectory whose frames are the models
    std::vector<Look> looks_;
    std::vector<Key> keys_;
    std::optional<CameraPath> path_;
    bool saidTorn_ = false;
    std::uint64_t frames_ = 1;
    std::uint64_t models_ = 1;  ///< number of models shown
    std::uint64_t next_ = 0;    ///< the frame at which words can continue
    std::size_t stretch_ = 0;   ///< part of the path, for words
    Clip firstClip_;
    View first_;           ///< of the first model
    glm::dvec3 center_{};  ///< of the first model
};

}  // namespace nacre::app
