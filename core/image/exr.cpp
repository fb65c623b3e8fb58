// OpenEXR, in memory on both sides: files are read and written by core/base/file.h.
#include "core/image/formats.h"

#include "core/base/text.h"
#include "core/image/dimensions.h"

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <cstring>
#include <stdexcept>
#include <vector>

namespace reflectance {
namespace {

class MemoryIn : public Imf::IStream {
public:
    explicit MemoryIn(std::string_view bytes) : Imf::IStream("memory"), bytes_(bytes) {}

    bool read(char to[], int count) override
    {
        const auto wanted = static_cast<std::size_t>(count);
        if (count < 0 || at_ > bytes_.size() || wanted > bytes_.size() - at_)
            throw std::runtime_error("it ends too early");
        std::memcpy(to, bytes_.data() + at_, wanted);
        at_ += wanted;
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t position) override { at_ = position; }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

class MemoryOut : public Imf::OStream {
public:
    MemoryOut() : Imf::OStream("memory") {}

    void write(const char from[], int count) override
    {
        const auto size = static_cast<std::size_t>(count);
        bytes.resize(std::max(bytes.size(), at_ + size));
        bytes.replace(at_, size, from, size);
        at_ += size;
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t position) override { at_ = position; }

    std::string bytes;

private:
    std::size_t at_ = 0;
};

/// The three channels to show, from "R G B" or a lone "Y"; empty if there are none.
std::vector<std::string> colourChannels(const Imf::ChannelList& channels)
{
    const auto whole = [&channels](const char* name) {
        const Imf::Channel* channel = channels.findChannel(name);
        return channel && channel->xSampling == 1 && channel->ySampling == 1;
    };
    if (whole("R") && whole("G") && whole("B"))
        return {"R", "G", "B"};
    if (whole("Y") && !channels.findChannel("RY"))
        return {"Y"};
    return {};
}

std::string namesOf(const Imf::ChannelList& channels)
{
    std::vector<std::string> names;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel)
        names.emplace_back(channel.name());
    return joined(names);
}

void copyFirstChannel(Image& image)
{
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
        image.rgb[i + 1] = image.rgb[i + 2] = image.rgb[i];
}

Image readPixels(Imf::InputFile& file, const std::vector<std::string>& names)
{
    const Imath::Box2i window = file.header().dataWindow();
    Image image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
    const std::size_t row = sizeof(float) * static_cast<std::size_t>(image.width);
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < names.size(); ++c)
        buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, image.rgb.data() + c, window, 3 * sizeof(float), 3 * row));
    if (file.header().channels().findChannel("A"))
        buffer.insert("A", Imf::Slice::Make(Imf::FLOAT, image.coverage.data(), window, sizeof(float), row));
    else
        image.coverage.clear();
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    if (names.size() == 1)
        copyFirstChannel(image);
    return image;
}

Notes readNotes(std::string_view bytes)
{
    MemoryIn stream(bytes);
    const Imf::InputFile file(stream);
    Notes notes;
    for (auto attribute = file.header().begin(); attribute != file.header().end(); ++attribute)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
            notes.push_back({attribute.name(), text->value()});
    return notes;
}

Result<Image> readImage(std::string_view bytes, const std::string& path)
{
    Imf::Header::setMaxImageSize(largestSide, largestSide);
    MemoryIn stream(bytes);
    Imf::InputFile file(stream);
    const Imath::Box2i window = file.header().dataWindow();
    // An all-black picture of 8192 x 2048 pixels in DWAB, the densest, holds 5095 per byte; wider ones somewhat more.
    if (const auto size = checkDimensions(long{window.max.x} - window.min.x + 1, long{window.max.y} - window.min.y + 1,
                                          bytes.size(), 16384, path);
        !size)
        return size.error();
    const auto names = colourChannels(file.header().channels());
    if (names.empty())
        return Error{"has no channels R, G, B and no lone Y, but " + namesOf(file.header().channels()), path};
    return readPixels(file, names);
}

} // namespace

Result<Image> decodedExr(std::string_view bytes, const std::string& path)
{
    try {
        return readImage(bytes, path);
    } catch (const std::exception& problem) {
        return Error{"is a damaged OpenEXR file (" + std::string(problem.what()) + ")", path};
    }
}

Result<Notes> notesOfExr(std::string_view bytes, const std::string& path)
{
    try {
        return readNotes(bytes);
    } catch (const std::exception& problem) {
        return Error{"is a damaged OpenEXR file (" + std::string(problem.what()) + ")", path};
    }
}

std::string encodedExr(const Image& image, const Notes& notes)
{
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities()); // the library's default is Rec. 709
    for (const Note& note : notes)
        header.insert(note.key, Imf::StringAttribute(note.text));
    Imf::FrameBuffer buffer;
    const std::size_t row = sizeof(float) * static_cast<std::size_t>(image.width);
    // The library's slices are not const; writing leaves them alone.
    const auto add = [&](const char* name, const float* values, std::size_t stride) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        auto* base = const_cast<char*>(reinterpret_cast<const char*>(values)); // NOLINT(*-const-cast)
        buffer.insert(name, Imf::Slice(Imf::FLOAT, base, stride * sizeof(float), stride * row));
    };
    add("R", image.rgb.data(), 3);
    add("G", image.rgb.data() + 1, 3);
    add("B", image.rgb.data() + 2, 3);
    if (!image.coverage.empty())
        add("A", image.coverage.data(), 1);
    MemoryOut stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(buffer);
        file.writePixels(image.height);
    }
    return std::move(stream.bytes);
}

} // namespace reflectance
