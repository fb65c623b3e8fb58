#include "core/scene/sensor_file.h"

#include "core/sensor/fields.h"

namespace reflectance {
namespace {

using Json = ObjectReader::Json;
using FileNames = std::function<std::string(const std::string&)>;

struct FieldReader {
    ObjectReader* object;
    const FileNames* resolve;

    void number(const char* key, double& value, double low, double high) const { object->read(key, value, low, high); }
    void whole(const char* key, int& value, int low, int high) const { object->read(key, value, low, high); }
    void flag(const char* key, bool& value) const { object->read(key, value); }
    void vector(const char* key, Vec3d& value, double low) const { object->read(key, value, low); }
    void matrix(const char* key, std::array<double, 9>& value) const { object->read(key, value); }
    template <class T, std::size_t count>
    void choice(const char* key, const NamedValue<T> (&names)[count], T& value) const
    {
        object->readNamed(key, names, value);
    }
    void curve(const char* key, Response& response) const
    {
        const ResponseKind kind = response.kind;
        std::string file;
        object->read(key, file);
        if (!file.empty())
            if (const auto read = readCurveOf(response, (*resolve)(file)); !read)
                object->fail(read.error().sentence());
        response.kind = kind;
        if (kind == ResponseKind::Curve && !response.curve)
            object->fail("a response curve needs its file; name it as \"file\"");
    }
};

struct PartReader {
    ObjectReader* object;
    const FileNames* resolve;

    template <class Part, class Fields> void part(const char* name, Part& target, const Fields& fields)
    {
        object->readObject(name, [&](ObjectReader inner) {
            target.on = true;
            inner.read("on", target.on);
            FieldReader reader{&inner, resolve};
            fields(target, reader);
            inner.finish();
        });
    }
};

struct FieldWriter {
    Json* json;
    const FileNames* shorten;

    void number(const char* key, double value, double, double) const { (*json)[key] = value; }
    void whole(const char* key, int value, int, int) const { (*json)[key] = value; }
    void flag(const char* key, bool value) const { (*json)[key] = value; }
    void vector(const char* key, const Vec3d& v, double) const { (*json)[key] = Json::array({v.x, v.y, v.z}); }
    void matrix(const char* key, const std::array<double, 9>& value) const { (*json)[key] = value; }
    template <class T, std::size_t count>
    void choice(const char* key, const NamedValue<T> (&names)[count], T value) const
    {
        (*json)[key] = nameOf(names, value);
    }
    void curve(const char* key, const Response& response) const
    {
        if (!response.file.empty())
            (*json)[key] = (*shorten)(response.file);
    }
};

struct PartWriter {
    Json* json;
    const FileNames* shorten;

    template <class Part, class Fields> void part(const char* name, const Part& target, const Fields& fields)
    {
        if (target == Part())
            return;
        Json written{{"on", target.on}};
        FieldWriter writer{&written, shorten};
        fields(target, writer);
        (*json)[name] = written;
    }
};

} // namespace

void readSensor(ObjectReader object, Sensor& sensor, const FileNames& resolve)
{
    object.read("exposure", sensor.exposure, -16.0, 16.0);
    object.read("exposes", sensor.exposes);
    PartReader reader{&object, &resolve};
    visitParts(sensor, reader);
    object.readObject("view", [&](ObjectReader view) {
        view.readNamed("kind", sensorViewKinds, sensor.view.kind);
        view.read("marks", sensor.view.marks);
        view.finish();
    });
    object.finish();
}

Json writtenSensor(const Sensor& sensor, const FileNames& shorten)
{
    Json json{{"exposure", sensor.exposure}};
    if (!sensor.exposes)
        json["exposes"] = false;
    PartWriter writer{&json, &shorten};
    visitParts(sensor, writer);
    if (sensor.view != SensorView())
        json["view"] = {{"kind", nameOf(sensorViewKinds, sensor.view.kind)}, {"marks", sensor.view.marks}};
    return json;
}

} // namespace reflectance
