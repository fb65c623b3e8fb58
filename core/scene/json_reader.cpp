#include "core/scene/json_reader.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace reflectance {
namespace {

/// A number or a list of numbers; empty if it is neither.
std::vector<double> numbersOf(const ObjectReader::Json& json)
{
    if (json.is_number())
        return {json.get<double>()};
    const auto isNumber = [](const ObjectReader::Json& item) { return item.is_number(); };
    if (!json.is_array() || !std::all_of(json.begin(), json.end(), isNumber))
        return {};
    return json.get<std::vector<double>>();
}

bool allWithin(const std::vector<double>& numbers, double low, double high)
{
    return std::all_of(numbers.begin(), numbers.end(),
                       [=](double v) { return std::isfinite(v) && v >= low && v <= high; });
}

std::string rangeText(double low, double high)
{
    return std::isfinite(low) || std::isfinite(high) ? " within " + shortest(low) + " .. " + shortest(high) : "";
}

/// 1-based line of a byte; past the end, the last line.
long lineAt(std::string_view text, std::size_t byte)
{
    const auto position = static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    return 1 + std::count(text.begin(), text.begin() + position, '\n');
}

} // namespace

ObjectReader::ObjectReader(const Json& object, std::string where, std::optional<std::string>& problem)
    : object_(&object), where_(std::move(where)), problem_(&problem)
{
    if (!object.is_object())
        fail(where_ + " is not an object { }");
}

const ObjectReader::Json* ObjectReader::find(const char* key)
{
    known_.insert(key);
    if (!object_->is_object())
        return nullptr;
    const auto found = object_->find(key);
    return found == object_->end() ? nullptr : &*found;
}

void ObjectReader::read(const char* key, double& value, double low, double high)
{
    const Json* json = find(key);
    if (!json)
        return;
    if (!json->is_number() || !allWithin({json->get<double>()}, low, high))
        return fail(nameOf(key) + " must be a number" + rangeText(low, high));
    value = json->get<double>();
}

void ObjectReader::read(const char* key, int& value, int low, int high)
{
    const Json* json = find(key);
    if (!json)
        return;
    if (!json->is_number_integer() || json->get<long>() < low || json->get<long>() > high)
        return fail(nameOf(key) + " must be a whole number" + rangeText(low, high));
    value = json->get<int>();
}

void ObjectReader::read(const char* key, bool& value)
{
    const Json* json = find(key);
    if (!json)
        return;
    if (!json->is_boolean())
        return fail(nameOf(key) + " must be true or false");
    value = json->get<bool>();
}

void ObjectReader::read(const char* key, std::string& value)
{
    const Json* json = find(key);
    if (!json)
        return;
    if (!json->is_string())
        return fail(nameOf(key) + " must be a text in quotes");
    value = json->get<std::string>();
}

void ObjectReader::read(const char* key, Vec3d& value, double low)
{
    const Json* json = find(key);
    if (!json)
        return;
    const std::vector<double> numbers = numbersOf(*json);
    if (numbers.size() != 3 || !allWithin(numbers, low, std::numeric_limits<double>::max()))
        return fail(nameOf(key) + " must be three finite numbers [x, y, z]" + (low == 0.0 ? ", none negative" : ""));
    value = {numbers[0], numbers[1], numbers[2]};
}

void ObjectReader::read(const char* key, std::array<double, 9>& matrix)
{
    const Json* json = find(key);
    if (!json)
        return;
    const std::vector<double> numbers = numbersOf(*json);
    constexpr double most = std::numeric_limits<double>::max();
    if (numbers.size() != matrix.size() || !allWithin(numbers, -most, most))
        return fail(nameOf(key) + " must be nine finite numbers, row by row");
    std::copy(numbers.begin(), numbers.end(), matrix.begin());
}

void ObjectReader::eachNumberList(const char* key,
                                  const std::function<void(const std::string&, const std::vector<double>&)>& take)
{
    const Json* json = find(key);
    if (!json)
        return;
    if (!json->is_object())
        return fail(nameOf(key) + " is not an object { }");
    for (const auto& [name, item] : json->items()) {
        const std::vector<double> numbers = numbersOf(item);
        if (numbers.empty())
            return fail(nameOf(key) + "." + name + " must be a number or a list of numbers");
        take(name, numbers);
    }
}

void ObjectReader::readObject(const char* key, const std::function<void(ObjectReader)>& take)
{
    if (const Json* json = find(key))
        take(ObjectReader(*json, nameOf(key), *problem_));
}

std::string ObjectReader::chosenName(const char* key, const std::vector<std::string>& names)
{
    const Json* json = find(key);
    if (!json)
        return {};
    if (!json->is_string()) {
        fail(nameOf(key) + " must be a text in quotes; choose one of: " + joined(names));
        return {};
    }
    std::string chosen = json->get<std::string>();
    if (std::find(names.begin(), names.end(), chosen) == names.end())
        fail(nameOf(key) + " is '" + chosen + "'; choose one of: " + joined(names));
    return chosen;
}

void ObjectReader::fail(const std::string& sentence)
{
    if (!*problem_)
        *problem_ = sentence;
}

void ObjectReader::finish()
{
    if (!object_->is_object())
        return;
    for (const auto& [key, value] : object_->items())
        if (!known_.contains(key))
            fail(where_ + " has an unknown key '" + key + "'; did you mean '" +
                 nearestName(key, {known_.begin(), known_.end()}) + "'?");
}

void ObjectReader::readTexts(const char* key, std::vector<std::string>& texts)
{
    const Json* json = find(key);
    if (!json)
        return;
    if (!json->is_array() ||
        !std::all_of(json->begin(), json->end(), [](const Json& text) { return text.is_string(); }))
        return fail(nameOf(key) + " must be a list of texts");
    texts = json->get<std::vector<std::string>>();
}

void ObjectReader::readVersion(const std::string& schema, int newest)
{
    std::string found = schema;
    read("schema", found);
    if (found != schema)
        return fail("schema is '" + found + "', not '" + schema + "'; this is another kind of file");
    int version = newest;
    read("version", version, 1, std::numeric_limits<int>::max());
    if (version > newest)
        fail(where_ + " is of version " + std::to_string(version) +
             " and was written by a newer program; this one reads up to " + std::to_string(newest) + ", so update it");
}

Result<ObjectReader::Json> parsedJson(std::string_view text, const std::string& what, const std::string& file)
{
    ObjectReader::Json json;
    try {
        json = ObjectReader::Json::parse(text);
    } catch (const ObjectReader::Json::parse_error& error) {
        return Error{"not " + what + ": a comma, bracket or quote is wrong here", file, lineAt(text, error.byte)};
    } catch (const ObjectReader::Json::out_of_range& error) {
        // The message quotes the number; the exception does not tell its place.
        const auto pieces = split(error.what(), '\'');
        const std::string number(pieces.size() > 1 ? pieces[1] : "");
        return Error{"the number " + number + " is too large; give one up to 1e308", file,
                     lineAt(text, text.find(number))};
    }
    return json;
}

std::string jsonText(const ObjectReader::Json& json)
{
    return json.dump(2, ' ', false, ObjectReader::Json::error_handler_t::replace) + "\n";
}

} // namespace reflectance
