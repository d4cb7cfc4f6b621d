#include "tools/cut_jobs.h"

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <set>
#include <stdexcept>

#include "tools/mesh_files.h"
#include "tools/text.h"

namespace kerf::tools {

namespace {

/// What is wrong with a line; its number is added by who reads it.
struct BadJob : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

double number(const std::string& key, const Json& value)
{
    if (!value.is_number() || !std::isfinite(value.get<double>())) throw BadJob("'" + key + "' is no number");
    return value.get<double>();
}

glm::dvec3 three_numbers(const std::string& key, const Json& value)
{
    if (!value.is_array() || value.size() != 3) throw BadJob("'" + key + "' is no list of three numbers");
    return {number(key, value[0]), number(key, value[1]), number(key, value[2])};
}

/// Rounded as on the command line: digits copied from a file mean that vertex.
glm::dvec3 place(const std::string& key, const Json& value)
{
    const glm::dvec3 exact = three_numbers(key, value);
    const auto rounded_once = [](double coordinate) {
        const auto stored = static_cast<double>(static_cast<float>(coordinate));
        return std::isfinite(stored) ? stored : coordinate;
    };
    return {rounded_once(exact.x), rounded_once(exact.y), rounded_once(exact.z)};
}

bool yes_or_no(const std::string& key, const Json& value)
{
    if (!value.is_boolean()) throw BadJob("'" + key + "' is neither true nor false");
    return value.get<bool>();
}

Vec3d vector(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

Plane through(const Json& value)
{
    if (!value.is_array() || value.size() != 3) throw BadJob("'through' is no list of three points");
    std::array<Vec3d, 3> points;
    for (std::size_t i = 0; i < 3; ++i) points[i] = vector(place("through", value[i]));
    const std::optional<Plane> plane = Plane::through(points[0], points[1], points[2]);
    if (!plane) throw BadJob("the points of 'through' lie on one line");
    return *plane;
}

std::string name_of(const Json& value)
{
    if (!value.is_string() || value.get<std::string>().empty()) throw BadJob("'name' is no text");
    auto name = value.get<std::string>();
    if (name.find_first_of(std::string("/\0", 2)) != std::string::npos) throw BadJob("'name' has a / in it");
    return name;
}

void read_key(CutJob& job, const std::string& key, const Json& value)
{
    CutSettings& cut = job.cut;
    if (key == "name") {
        job.name = name_of(value);
    } else if (key == "plane") {
        if (!value.is_string()) throw BadJob("'plane' is no text such as \"z=0.5\"");
        try {
            cut.plane = parse_axis_plane("'plane'", value.get<std::string>());
        } catch (const CLI::ValidationError& error) {
            throw BadJob(error.what());
        }
    } else if (key == "normal") {
        cut.normal = three_numbers(key, value);
        if (!Plane::at(Point(0, 0, 0), Normal(*cut.normal))) throw BadJob("'normal' has no direction");
    } else if (key == "point") {
        cut.point = place(key, value);
    } else if (key == "through") {
        cut.plane = through(value);
    } else if (key == "gap") {
        cut.gap = number(key, value);
        if (cut.gap < 0.0) throw BadJob("'gap' is below 0");
    } else if (key == "cap") {
        cut.cap = yes_or_no(key, value);
    } else if (key == "components") {
        cut.components = yes_or_no(key, value);
    } else if (key == "only") {
        cut.only = OnlyNear{vector(place(key, value)), OnlyNear::Extent::region};
    } else if (key == "only_solid") {
        cut.only = OnlyNear{vector(place(key, value)), OnlyNear::Extent::solid};
    } else {
        throw BadJob("'" + key +
                     "' is none of name, plane, normal, point, through, gap, cap, components, only, only_solid");
    }
}

CutJob parse_job(const std::string& line, const CutSettings& defaults)
{
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object()) throw BadJob("no JSON object");
    CutJob job{"", defaults};
    for (const auto& [key, value] : json.items()) read_key(job, key, value);
    const auto count = json.count("plane") + json.count("normal") + json.count("through");
    if (count != 1) throw BadJob("it has to say one of 'plane', 'normal' and 'through'");
    if (json.contains("point") && !json.contains("normal")) throw BadJob("'point' goes with 'normal'");
    if (job.cut.only && job.cut.gap > 0.0) throw BadJob("'only' does not go with a gap");
    return job;
}

std::string padded(std::size_t value, std::size_t digits)
{
    std::string text = std::to_string(value);
    return text.insert(0, text.size() < digits ? digits - text.size() : 0, '0');
}

}  // namespace

std::vector<CutJob> read_jobs(const std::string& path, const CutSettings& defaults)
{
    std::ifstream file;
    if (path != "-") file.open(path);
    std::istream& lines = path == "-" ? std::cin : file;
    if (!lines) throw FileError(path + ": there is no such file that can be read");
    std::vector<CutJob> jobs;
    std::set<std::string> names;
    std::size_t number_of_line = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number_of_line;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        try {
            jobs.push_back(parse_job(line, defaults));
            if (!jobs.back().name.empty() && !names.insert(jobs.back().name).second)
                throw BadJob("another job has the name '" + jobs.back().name + "'");
        } catch (const BadJob& fault) {
            throw FileError(path + ": line " + std::to_string(number_of_line) + ": " + fault.what());
        }
    }
    if (lines.bad()) throw FileError(path + ": it can't be read");
    if (jobs.empty()) throw FileError(path + ": there is no job in it");
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(jobs.size()).size());
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        if (!jobs[i].name.empty()) continue;
        jobs[i].name = padded(i + 1, digits);
        if (!names.insert(jobs[i].name).second)
            throw FileError(path + ": job " + std::to_string(i + 1) +
                            " has no name, and another one has its number for one");
    }
    return jobs;
}

}  // namespace kerf::tools
