#include "core/sensor/fields.h"

#include "core/base/number_list.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace reflectance {
namespace {

std::string range(double low, double high)
{
    return "a number in " + general(low, 10) + " .. " + general(high, 10);
}

std::optional<std::vector<double>> numbersIn(std::string_view text, std::size_t count)
{
    auto numbers = numberList(text);
    return numbers && numbers->size() == count ? numbers : std::nullopt;
}

/// Sets one field from text. `wanted` empty: the first.
struct FieldSetter {
    std::string_view wanted;
    std::string_view value;
    bool found = false;
    std::string expected; ///< what the value should have been; empty where it was set
    std::string problem;  ///< of a file
    std::vector<std::string> keys;

    bool meets(std::string_view key)
    {
        keys.emplace_back(key);
        const bool meets = !found && (wanted.empty() || wanted == key);
        found = found || meets;
        return meets;
    }
    void number(std::string_view key, double& target, double low, double high)
    {
        if (!meets(key))
            return;
        if (const auto number = parseNumber(value); number && *number >= low && *number <= high)
            target = *number;
        else
            expected = range(low, high);
    }
    void whole(std::string_view key, int& target, int low, int high)
    {
        if (!meets(key))
            return;
        if (const auto number = parseInteger(value); number && *number >= low && *number <= high)
            target = static_cast<int>(*number);
        else
            expected = "a whole number in " + std::to_string(low) + " .. " + std::to_string(high);
    }
    void flag(std::string_view key, bool& target)
    {
        if (!meets(key))
            return;
        if (value == "on" || value == "off")
            target = value == "on";
        else
            expected = "on or off";
    }
    template <class T, std::size_t count>
    void choice(std::string_view key, const NamedValue<T> (&names)[count], T& target)
    {
        if (!meets(key))
            return;
        const auto named =
            std::find_if(std::begin(names), std::end(names), [&](const auto& n) { return n.name == value; });
        if (named != std::end(names))
            target = named->value;
        else
            expected = "one of " + joined(namesIn(names));
    }
    void vector(std::string_view key, Vec3d& target, double low)
    {
        if (!meets(key))
            return;
        const auto numbers = numbersIn(value, 3);
        if (numbers && std::all_of(numbers->begin(), numbers->end(), [low](double v) { return v >= low; }))
            target = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
        else
            expected = std::string("three numbers, as in 1,0.9,0.8") + (low == 0.0 ? ", none negative" : "");
    }
    void matrix(std::string_view key, std::array<double, 9>& target)
    {
        if (!meets(key))
            return;
        if (const auto numbers = numbersIn(value, 9))
            std::copy(numbers->begin(), numbers->end(), target.begin());
        else
            expected = "nine numbers row by row, separated by commas";
    }
    void curve(std::string_view key, Response& target)
    {
        if (!meets(key))
            return;
        if (const auto read = readCurveOf(target, std::string(value)); !read)
            problem = read.error().sentence();
    }
};

/// Finds a part by its name and hands its fields the assignments.
struct PartSetter {
    std::string_view name;
    std::string_view rest; ///< VALUE[:KEY=VALUE...]
    bool found = false;
    std::optional<std::string> problem;
    std::vector<std::string> names;

    template <class Part, class Fields> void part(std::string_view partName, Part& target, const Fields& fields)
    {
        names.emplace_back(partName);
        if (partName != name)
            return;
        found = true;
        target.on = true;
        bool first = true;
        while (!problem && (first || !rest.empty())) {
            const std::string_view piece = taken();
            if (first && (piece == "on" || piece == "off"))
                target.on = piece == "on";
            else
                setField(piece, first, target, fields);
            first = false;
        }
    }

    /// The text up to the next colon; a file's name goes on to the end.
    std::string_view taken()
    {
        const std::size_t end = rest.starts_with("file=") ? rest.size() : std::min(rest.find(':'), rest.size());
        const std::string_view piece = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        return piece;
    }

    template <class Part, class Fields>
    void setField(std::string_view piece, bool first, Part& target, const Fields& fields)
    {
        const std::size_t equals = piece.find('=');
        FieldSetter setter;
        if (equals == std::string_view::npos) {
            if (!first) {
                problem = "'" + std::string(piece) + "' is no KEY=VALUE";
                return;
            }
            setter.value = piece;
        } else {
            setter.wanted = piece.substr(0, equals);
            setter.value = piece.substr(equals + 1);
        }
        fields(target, setter);
        if (!setter.problem.empty())
            problem = setter.problem;
        else if (!setter.found || (equals == 0))
            problem = "'" + std::string(setter.wanted) + "' is no key of " + std::string(name) + "; it has " +
                      joined(setter.keys);
        else if (!setter.expected.empty())
            problem = "'" + std::string(setter.value) + "' is not " + setter.expected;
    }
};

Result<void> setExposure(std::string_view value, Sensor& sensor)
{
    if (value == "on" || value == "off") {
        sensor.exposes = value == "on";
        return {};
    }
    const auto number = parseNumber(value);
    if (!number || !(std::fabs(*number) <= 16.0))
        return Error{"'" + std::string(value) + "' is not " + range(-16.0, 16.0)};
    sensor.exposure = *number;
    sensor.exposes = true;
    return {};
}

/// Switches every part off but the one named.
struct Switch {
    std::string_view spared;

    template <class Part, class Fields> void part(std::string_view name, Part& target, const Fields&)
    {
        target.on = target.on && name == spared;
    }
};

/// Lists the keys of every part.
struct GrammarWriter {
    std::string text;

    template <class Part, class Fields> void part(std::string_view name, Part& target, const Fields& fields)
    {
        FieldSetter lister;
        lister.found = true; // sets nothing
        fields(target, lister);
        text += "; " + std::string(name) + " (" + joined(lister.keys) + ")";
    }
};

} // namespace

Result<void> setOnSensor(std::string_view assignment, Sensor& sensor)
{
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos)
        return Error{"write PART=VALUE[:KEY=VALUE...], as in noise=8:seed=3 or well=off"};
    PartSetter setter{assignment.substr(0, equals), assignment.substr(equals + 1), false, {}, {}};
    if (setter.name == "exposure")
        return setExposure(setter.rest, sensor);
    if (assignment == "all=off") {
        Switch off;
        visitParts(sensor, off);
        sensor.exposes = false;
        return {};
    }
    Sensor changed = sensor;
    visitParts(changed, setter);
    if (!setter.found) {
        setter.names.emplace_back("exposure");
        return Error{"the sensor has no part '" + std::string(setter.name) + "'; did you mean '" +
                     nearestName(setter.name, setter.names) + "'?"};
    }
    if (setter.problem)
        return Error{*setter.problem};
    if (changed.response.on && changed.response.kind == ResponseKind::Curve && !changed.response.curve)
        return Error{"a response curve needs its file; write response=curve:file=CURVE.csv"};
    sensor = changed;
    return {};
}

Sensor onlyPart(const Sensor& sensor, std::string_view part)
{
    Sensor alone = sensor;
    Switch off{part};
    visitParts(alone, off);
    alone.encoding.on = sensor.encoding.on;
    return alone;
}

Result<void> readCurveOf(Response& response, const std::string& file)
{
    auto curve = readResponseCurve(file);
    if (!curve)
        return curve.error();
    response.file = file;
    response.curve = std::make_shared<const ResponseCurve>(*std::move(curve));
    response.kind = ResponseKind::Curve;
    return {};
}

std::string sensorGrammar()
{
    Sensor sensor;
    GrammarWriter writer{"exposure (EV)"};
    visitParts(sensor, writer);
    return writer.text;
}

} // namespace reflectance
