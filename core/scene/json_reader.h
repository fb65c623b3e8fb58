// Reads JSON objects key by key with checks; the first problem is kept as a sentence and keys nobody asked for are
// problems too. For scene files and studies.
#pragma once

#include "core/base/named_value.h"
#include "core/base/result.h"
#include "core/math/vec.h"

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace reflectance {

class ObjectReader {
public:
    using Json = nlohmann::ordered_json;
    static constexpr double inf = std::numeric_limits<double>::infinity();

    template <class T> using ReadOne = const std::type_identity_t<std::function<void(ObjectReader, T&)>>&;

    /// `where` names the object in sentences; `problem` receives the first one.
    ObjectReader(const Json& object, std::string where, std::optional<std::string>& problem);

    void read(const char* key, double& value, double low = -inf, double high = inf);
    void read(const char* key, int& value, int low, int high);
    void read(const char* key, bool& value);
    void read(const char* key, std::string& value);
    void readTexts(const char* key, std::vector<std::string>& texts);
    void read(const char* key, Vec3d& value, double low = -inf);
    void read(const char* key, std::array<double, 9>& matrix);
    void eachNumberList(const char* key,
                        const std::function<void(const std::string&, const std::vector<double>&)>& take);
    void readObject(const char* key, const std::function<void(ObjectReader)>& take);

    template <class T> void readList(const char* key, std::vector<T>& list, ReadOne<T> readOne);
    template <class T, std::size_t count>
    void readNamed(const char* key, const NamedValue<T> (&names)[count], T& value);

    /// Keys "schema" and "version": another schema or a newer version is a problem.
    void readVersion(const std::string& schema, int newest);

    /// What stands under the key as it is; nullptr where it is not there.
    [[nodiscard]] const Json* find(const char* key);

    void fail(const std::string& sentence); ///< keeps the first sentence only
    void finish();                          ///< complains of keys that nobody read

private:
    std::string nameOf(const char* key) const { return where_ + "." + key; }
    std::string chosenName(const char* key, const std::vector<std::string>& names);

    const Json* object_;
    std::string where_;
    std::optional<std::string>* problem_;
    std::set<std::string> known_;
};

/// A file's JSON; the Error names a syntax error's line. `what`: "a JSON scene".
[[nodiscard]] Result<ObjectReader::Json> parsedJson(std::string_view text, const std::string& what,
                                                    const std::string& file);

/// As the program writes it. Names of files need not be UTF-8; what is not is replaced.
[[nodiscard]] std::string jsonText(const ObjectReader::Json& json);

template <class T> void ObjectReader::readList(const char* key, std::vector<T>& list, ReadOne<T> readOne)
{
    const Json* json = find(key);
    if (!json)
        return;
    if (!json->is_array())
        return fail(nameOf(key) + " is not a list");
    list.clear();
    for (const Json& item : *json) {
        list.emplace_back();
        readOne(ObjectReader(item, nameOf(key) + "[" + std::to_string(list.size() - 1) + "]", *problem_), list.back());
    }
}

template <class T, std::size_t count>
void ObjectReader::readNamed(const char* key, const NamedValue<T> (&names)[count], T& value)
{
    const std::string chosen = chosenName(key, namesIn(names));
    for (const NamedValue<T>& named : names)
        if (named.name == chosen)
            value = named.value;
}

} // namespace reflectance
