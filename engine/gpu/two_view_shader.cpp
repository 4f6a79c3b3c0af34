#include "engine/gpu/two_view_shader.h"

#include <set>

#include "engine/gpu/spirv.h"

namespace nacre::gpu {
namespace {

using namespace spirv;
constexpr std::uint32_t kMultiView = 4439, kViewIndex = 4440;                           // the capability, the built-in
constexpr std::uint32_t kFlat = 14, kBuiltIn = 11;                                      // decorations
constexpr std::uint32_t kFragment = 4, kInput = 1, kUniformConstant = 0, kArrayed = 4;  // kArrayed: an image's operand

bool isViewIndex(const Instruction& i) { return namesFunction(i, "viewIndex"); }

class TwoViews {
public:
    explicit TwoViews(Words words) : words_(words), next_(words[kBound]), index_(next_++) {
        function_ = require(words, kHeader, "a shader without viewIndex()", isViewIndex).operands[0];
        integer_ = require(words, kHeader, "a shader without integers", [](const Instruction& i) {
                       return i.operation == kOpTypeInt && i.operands[1] == 32 && i.operands[2] == 1;
                   }).operands[0];
    }

    std::vector<std::uint32_t> write() {
        out_.assign(words_.begin(), words_.begin() + kHeader);
        find(words_, kHeader, [&](const Instruction& i) {
            rewrite(i);
            return false;
        });
        out_[kBound] = next_;
        return std::move(out_);
    }

private:
    void rewrite(const Instruction& i) {
        switch (i.operation) {
            case kOpCapability:
                if (out_.size() == kHeader) append(out_, kOpCapability, {kMultiView});
                return copy(i);
            case kOpEntryPoint:
                isFragment_ = i.operands[0] == kFragment;
                copy(i);
                out_.push_back(index_);
                out_[out_.size() - 2 - i.operands.size()] += 1u << 16;
                return;
            case kOpName:
                if (i.operands.size() > 1 && text(i.operands, 1).ends_with("OfView")) layered_.insert(i.operands[0]);
                return copy(i);
            case kOpTypeVoid:
                return writeDecorations(), copy(i);  // the first type
            case kOpVariable:
                return layered_.contains(i.operands[1]) ? writeArray(i) : copy(i);
            case kOpFunction:
                if (!inFunctions_) writeIndex();
                inFunctions_ = true;
                isIndex_ = i.operands[1] == function_;
                return copy(i);
            case kOpReturnValue:
                if (!isIndex_) return copy(i);
                return append(out_, kOpReturnValue, {loadIndex()});
            case kOpLoad:
                if (!layered_.contains(i.operands[2])) return copy(i);
                layered_.insert(i.operands[1]);
                return append(out_, kOpLoad, {sampledArray_, i.operands[1], i.operands[2]});
            case kOpImage:
                if (!layered_.contains(i.operands[2])) return copy(i);
                layered_.insert(i.operands[1]);
                return append(out_, kOpImage, {array_, i.operands[1], i.operands[2]});
            case kOpImageFetch:
                if (layered_.contains(i.operands[2])) return fetchLayer(i);
                return copy(i);
            default:
                return copy(i);
        }
    }

    void copy(const Instruction& i) {
        const Words all = words_.subspan(i.at, i.end() - i.at);
        out_.insert(out_.end(), all.begin(), all.end());
    }

    void writeDecorations() {
        append(out_, kOpDecorate, {index_, kBuiltIn, kViewIndex});
        if (isFragment_) append(out_, kOpDecorate, {index_, kFlat});
    }

    void writeIndex() {
        const std::uint32_t pointer = next_++;
        append(out_, kOpTypePointer, {pointer, kInput, integer_});
        append(out_, kOpVariable, {pointer, index_, kInput});
        if (array_ == 0) return;
        const std::optional<Instruction> found = find(words_, kHeader, [&](const Instruction& i) {
            return i.operation == kOpTypeVector && i.operands[1] == integer_ && i.operands[2] == 3;
        });
        place_ = found ? found->operands[0] : next_++;
        if (!found) append(out_, kOpTypeVector, {place_, integer_, 3});
    }

    /// The operands of the type with an id.
    Words type(std::uint32_t id) const {
        return require(words_, kHeader, "a shader without a type",
                       [&](const Instruction& i) {
                           return i.operation >= kOpTypeVoid && i.operation <= kOpTypePointer && i.operands[0] == id;
                       })
            .operands;
    }

    void writeArray(const Instruction& variable) {
        const Words image = type(type(type(variable.operands[0])[2])[1]);
        if (array_ != 0) throw std::logic_error("a shader with two images of views");
        array_ = next_++;
        sampledArray_ = next_++;
        const std::uint32_t pointer = next_++;
        out_.push_back(static_cast<std::uint32_t>(image.size() + 1) << 16 | kOpTypeImage);
        out_.push_back(array_);
        out_.insert(out_.end(), image.begin() + 1, image.end());
        out_[out_.size() - image.size() + kArrayed] = 1;
        append(out_, kOpTypeSampledImage, {sampledArray_, array_});
        append(out_, kOpTypePointer, {pointer, kUniformConstant, sampledArray_});
        append(out_, kOpVariable, {pointer, variable.operands[1], kUniformConstant});
    }

    void fetchLayer(const Instruction& i) {
        const std::uint32_t index = loadIndex(), place = next_++;
        append(out_, kOpCompositeConstruct, {place_, place, i.operands[3], index});
        copy(i);
        out_[out_.size() - i.operands.size() + 3] = place;
    }

    std::uint32_t loadIndex() {
        const std::uint32_t loaded = next_++;
        append(out_, kOpLoad, {integer_, loaded, index_});
        return loaded;
    }

    Words words_;
    std::vector<std::uint32_t> out_;
    std::uint32_t next_, index_;  ///< the next free id; the built-in variable
    std::uint32_t function_ = 0, integer_ = 0;
    std::uint32_t array_ = 0, sampledArray_ = 0, place_ = 0;  ///< types: the image of views, its place
    std::set<std::uint32_t> layered_;                         ///< ids of images of views: variables, loaded, images
    bool isFragment_ = false, inFunctions_ = false, isIndex_ = false;
};

}  // namespace

std::span<const std::uint32_t> forViews(std::span<const std::uint32_t> words, std::uint32_t views) {
    static Derived derived;
    if (views == 1 || !find(words, kHeader, isViewIndex)) return words;
    return derived.get(words, [](Words plain) { return TwoViews(plain).write(); });
}

}  // namespace nacre::gpu
