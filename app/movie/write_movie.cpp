#include "app/movie/write_movie.h"

#include <algorithm>

#include "app/movie/movie_encoder.h"

namespace nacre::app {

std::uint64_t writeMovie(MovieFile& file, const MovieFrames& frames) {
    const std::uint64_t samples = std::min<std::uint64_t>(6, frames.count);  // for the palette
    if (file.wantsSamples())
        for (std::uint64_t i = 0; i < samples && frames.goesOn(MovieStage::palette, 0); ++i)
            file.sample(frames.draw(i * frames.count / samples));
    MovieEncoder encoder(file);
    std::uint64_t drawn = 0;
    for (; frames.goesOn(MovieStage::frames, drawn) && drawn < frames.count; ++drawn) encoder.add(frames.draw(drawn));
    if (drawn == 0) return 0;
    frames.goesOn(MovieStage::writing, drawn);
    encoder.finish();
    return drawn;
}

}  // namespace nacre::app
