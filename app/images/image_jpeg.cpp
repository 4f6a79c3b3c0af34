#include <csetjmp>
// jpeglib.h needs both headers above.
#include <jpeglib.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "app/images/image_writers.h"
#include "app/images/srgb_profile.h"

namespace nacre::app {
namespace {

/// libjpeg's errors leave it by longjmp.
struct Failing {
    jpeg_error_mgr manager;  // first: libjpeg passes its address
    std::jmp_buf out;
    std::array<char, JMSG_LENGTH_MAX> why;
};

[[noreturn]] void leave(j_common_ptr jpeg) {
    auto* const failing = reinterpret_cast<Failing*>(jpeg->err);
    jpeg->err->format_message(jpeg, failing->why.data());
    std::longjmp(failing->out, 1);
}

/// Destination of libjpeg's bytes.
struct Target {
    jpeg_destination_mgr manager;  // first, likewise
    CheckedFile* file;
    std::array<JOCTET, 1 << 16> bytes;

    void empty() {
        manager.next_output_byte = bytes.data();
        manager.free_in_buffer = bytes.size();
    }
};

Target& toTarget(j_compress_ptr jpeg) { return *reinterpret_cast<Target*>(jpeg->dest); }

/// Writes libjpeg's chunks to the file, which records failures such as a full disk.
void connect(j_compress_ptr jpeg, Target& target) {
    target.manager.init_destination = [](j_compress_ptr j) { toTarget(j).empty(); };
    target.manager.empty_output_buffer = [](j_compress_ptr j) -> boolean {
        toTarget(j).file->write(toTarget(j).bytes.data(), toTarget(j).bytes.size());
        toTarget(j).empty();
        return TRUE;
    };
    target.manager.term_destination = [](j_compress_ptr j) {
        toTarget(j).file->write(toTarget(j).bytes.data(),
                                toTarget(j).bytes.size() - toTarget(j).manager.free_in_buffer);
    };
    jpeg->dest = &target.manager;
}

void begin(jpeg_compress_struct& jpeg, const ImageRequest& request) {
    constexpr int kQuality = 95;
    jpeg.image_width = request.width;
    jpeg.image_height = request.height;
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, kQuality, TRUE);
    for (int i = 0; i < 3; ++i) jpeg.comp_info[i].h_samp_factor = jpeg.comp_info[i].v_samp_factor = 1;
    if (request.dotsPerInch > 0) {
        jpeg.density_unit = 1;  // per inch
        jpeg.X_density = jpeg.Y_density = static_cast<UINT16>(std::lround(request.dotsPerInch));
    }
    jpeg_start_compress(&jpeg, TRUE);
}

/// The segment of ICC.1, annex B.4: the profile is short enough for one.
std::vector<JOCTET> profileSegment() {
    static constexpr char kName[] = "ICC_PROFILE";  // with its terminating zero
    std::vector<JOCTET> segment(kName, kName + sizeof kName);
    segment.insert(segment.end(), {1, 1});  // the first of one
    const std::vector<std::uint8_t> profile = srgbProfile();
    segment.insert(segment.end(), profile.begin(), profile.end());
    return segment;
}

}  // namespace

void writeJpeg(const ImageRequest& request, CheckedFile& file) {
    if (request.channels != 3 || request.samples != Samples::bytes)
        throw std::runtime_error("JPEG holds three channels of eight bits");
    const std::vector<JOCTET> profile = profileSegment();
    constexpr int kProfileMarker = JPEG_APP0 + 2;
    Target target{};
    target.file = &file;
    Failing failing{};
    jpeg_compress_struct jpeg{};
    jpeg.err = jpeg_std_error(&failing.manager);
    failing.manager.error_exit = leave;
    // No object with a destructor may be created between here and the last call of libjpeg.
    if (setjmp(failing.out) != 0) {
        jpeg_destroy_compress(&jpeg);
        throw std::runtime_error(failing.why.data());
    }
    jpeg_create_compress(&jpeg);
    connect(&jpeg, target);
    begin(jpeg, request);
    jpeg_write_marker(&jpeg, kProfileMarker, profile.data(), static_cast<unsigned>(profile.size()));
    try {
        while (jpeg.next_scanline < jpeg.image_height && file.failure() == 0) {
            const std::uint32_t first = jpeg.next_scanline;
            const std::uint32_t count = std::min(kRowsAtOnce, jpeg.image_height - first);
            const auto* pixels = static_cast<const JSAMPLE*>(request.rows(request.context, first, count));
            for (std::uint32_t row = 0; row < count; ++row) {
                JSAMPROW line =
                    const_cast<JSAMPROW>(pixels + std::size_t{row} * request.width * 3);  // libjpeg only reads it
                jpeg_write_scanlines(&jpeg, &line, 1);
            }
        }
    } catch (...) {  // from making the rows
        jpeg_destroy_compress(&jpeg);
        throw;
    }
    if (file.failure() == 0) jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
}

}  // namespace nacre::app
