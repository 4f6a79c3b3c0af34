#include "engine/molecule/model_places.h"

#include <algorithm>
#include <cstdint>

#include "engine/molecule/byte_file.h"
#include "engine/molecule/molecule.h"

namespace nacre {

struct ModelPlaces::Store {
    struct Place {
        OtherModel held;        ///< unless the file has it
        std::uint64_t at = 0;   ///< in the file
        std::size_t atoms = 0;  ///< whose positions these are
        bool inFile = false;
    };
    std::vector<Place> places;
    std::size_t heldBytes = 0;
    std::shared_ptr<ByteFile> file;
    bool noFile = false;
};

std::size_t ModelPlaces::size() const { return store_ ? store_->places.size() : 0; }

OtherModel ModelPlaces::operator[](std::size_t i) const {
    const Store::Place& place = store_->places[i];
    if (!place.inFile) return place.held;
    OtherModel other;
    other.positions.resize(place.atoms);
    store_->file->read(place.at, other.positions.data(), place.atoms * sizeof(glm::vec3));
    return other;
}

bool ModelPlaces::allMove(std::size_t atoms) const {
    return !empty() && std::all_of(store_->places.begin(), store_->places.end(), [&](const Store::Place& place) {
        return !place.held.whole && place.atoms == atoms;
    });
}

std::size_t ModelPlaces::add(OtherModel other, std::size_t mostHeld) {
    if (!store_) store_ = std::make_shared<Store>();
    Store& store = *store_;
    Store::Place place;
    place.atoms = other.positions.size();
    const std::size_t bytes = place.atoms * sizeof(glm::vec3);
    const bool much = !other.whole && store.heldBytes + bytes > mostHeld && !store.noFile;
    if (much && !store.file) store.file = ByteFile::temporary();
    if (much && store.file) place.at = store.file->size();
    place.inFile = much && store.file && store.file->append(other.positions.data(), bytes);
    store.noFile = much && !place.inFile;  // no room: held after all, as far as its reader lets it
    if (!place.inFile) {
        store.heldBytes += bytes;
        place.held = std::move(other);
    }
    store.places.push_back(std::move(place));
    return store.places.back().inFile ? 0 : bytes;
}

}  // namespace nacre
