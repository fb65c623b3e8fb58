#include "core/measured/tensor_file.h"

#include "core/measured/bytes.h"
#include "core/measured/lines.h"

namespace reflectance {
namespace {

constexpr std::size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8}; ///< bytes of a number, by type
constexpr std::size_t mostDimensions = 16;

class TensorParser {
public:
    TensorParser(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    [[nodiscard]] Result<TensorFile> parse()
    {
        const auto version = take<std::uint8_t>();
        (void)take<std::uint8_t>();
        const auto fields = take<std::uint32_t>();
        if (!bytes_.starts_with(tensorFileMagic) || !version || !fields)
            return fail("is cut short within its header; get the whole file");
        if (*version != 1)
            return fail("is a tensor file of version " + std::to_string(*version) + "; version 1 can be read");
        TensorFile found;
        for (std::uint32_t i = 0; i < *fields; ++i) // a false count ends with the file
            if (const auto taken = takeField(found); !taken)
                return taken.error();
        return found;
    }

private:
    [[nodiscard]] Error fail(const std::string& sentence) const { return {sentence, file_}; }

    template <class Number> [[nodiscard]] std::optional<Number> take()
    {
        const auto value = littleEndian<Number>(bytes_, at_);
        at_ += sizeof(Number);
        return value;
    }

    [[nodiscard]] Result<void> takeField(TensorFile& found)
    {
        const auto nameLength = take<std::uint16_t>();
        if (!nameLength || at_ > bytes_.size() || bytes_.size() - at_ < *nameLength)
            return fail("is cut short within its list of fields; get the whole file");
        const std::string name(bytes_.substr(at_, *nameLength));
        at_ += *nameLength;
        const auto dimensions = take<std::uint16_t>();
        const auto type = take<std::uint8_t>();
        const auto offset = take<std::uint64_t>();
        if (!dimensions || !type || !offset)
            return fail("is cut short within its list of fields; get the whole file");
        if (*type < 1 || *type > 11 || *dimensions > mostDimensions)
            return fail("its field " + quotedPiece(name) + " has an unknown type or shape");
        Tensor tensor;
        tensor.type = *type;
        std::uint64_t size = sizes[*type];
        for (std::size_t i = 0; i < *dimensions; ++i) {
            const auto extent = take<std::uint64_t>();
            if (!extent)
                return fail("is cut short within its list of fields; get the whole file");
            tensor.shape.push_back(static_cast<std::size_t>(*extent));
            if (*extent > 0 && size > bytes_.size() / *extent)
                return fail("its field " + quotedPiece(name) + " asks for more numbers than the file holds");
            size *= *extent;
        }
        if (*offset > bytes_.size() || size > bytes_.size() - *offset)
            return fail("its field " + quotedPiece(name) + " ends behind the file; get the whole file");
        tensor.bytes = bytes_.substr(static_cast<std::size_t>(*offset), static_cast<std::size_t>(size));
        found[name] = std::move(tensor);
        return {};
    }

    std::string_view bytes_;
    const std::string& file_;
    std::size_t at_ = tensorFileMagic.size();
};

} // namespace

std::size_t Tensor::count() const
{
    std::size_t product = 1;
    for (const std::size_t extent : shape)
        product *= extent;
    return product;
}

Result<TensorFile> parseTensorFile(std::string_view bytes, const std::string& file)
{
    return TensorParser(bytes, file).parse();
}

} // namespace reflectance
