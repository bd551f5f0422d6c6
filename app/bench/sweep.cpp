// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/sweep.h"

#include <sys/utsname.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <thread>
#include <utility>

#include "app/bench/parameters_node.h"
#include "core/energy/densities.h"
#include "core/error.h"
#include "core/scene/json_object.h"
#include "core/scene/json_value.h"
#include "core/scene/parameter_value.h"

namespace foldless {
namespace {

/// JSON has no word for what is not finite.
JsonNode any_number(double value) {
  if (std::isfinite(value)) return node_of(value);
  return node_of(std::isnan(value) ? "none" : "infinite");
}

double read_any_number(const JsonValue& value) {
  if (value.node().as<double>()) return value.number();
  if (value.text() == "infinite") return std::numeric_limits<double>::infinity();
  if (value.text() == "none") return std::numeric_limits<double>::quiet_NaN();
  value.refuse("is " + value.shown() + ", but it must be a number");
}

template <typename Number>
struct NumberField {
  const char* name;
  Number& (*in)(BenchRow& row);
};

constexpr std::array kWholeFields{
    NumberField<int>{"vertices", [](BenchRow& row) -> int& { return row.vertices; }},
    NumberField<int>{"faces", [](BenchRow& row) -> int& { return row.faces; }},
    NumberField<int>{"factorizations",
                     [](BenchRow& row) -> int& { return row.last.factorizations; }},
    NumberField<int>{"updates", [](BenchRow& row) -> int& { return row.last.updates; }},
    NumberField<int>{"flips", [](BenchRow& row) -> int& { return row.last.flips; }},
    NumberField<int>{"splits", [](BenchRow& row) -> int& { return row.last.splits; }},
    NumberField<int>{"vertices_added", [](BenchRow& row) -> int& { return row.vertices_added; }},
    NumberField<int>{"overlapping_boundary_vertices",
                     [](BenchRow& row) -> int& { return row.overlapping_boundary_vertices; }},
};

constexpr std::array kRealFields{
    NumberField<double>{"seconds", [](BenchRow& row) -> double& { return row.seconds; }},
    NumberField<double>{"conformal_distortion_max",
                        [](BenchRow& row) -> double& { return row.max_conformal_distortion; }},
    NumberField<double>{"conformal_distortion_mean",
                        [](BenchRow& row) -> double& { return row.mean_conformal_distortion; }},
    NumberField<double>{"E_d", [](BenchRow& row) -> double& { return row.distortion_energy; }},
    NumberField<double>{"handle_error_squared",
                        [](BenchRow& row) -> double& { return row.handle_error_squared; }},
    NumberField<double>{"diagonal", [](BenchRow& row) -> double& { return row.diagonal; }},
};

Parameters read_parameters(const JsonValue& value, const std::string& method) {
  Parameters parameters;
  parameters.method = method;
  for (const ParameterKey& key : parameter_keys())
    key.set(parameters, parameter_value(key, value.at(key.name)));
  return parameters;
}

/// What tells a sweep from others, and a run from others of its sweep.
constexpr std::array kOfSweep{"version", "suite", "seed", "time_limit", "repeat", "jobs"};
constexpr std::array kOfRun{"job", "scene", "energy", "method", "parameters"};

BenchRow row_in(const JsonValue& record) {
  BenchRow row;
  row.job = static_cast<std::size_t>(record.at("job").integer());
  row.scene = record.at("scene").text();
  row.difficulty = record.at("difficulty").text();
  row.energy = record.at("energy").text();
  row.method = record.at("method").text();
  row.parameters = read_parameters(record.at("parameters"), row.method);
  row.is_satisfied = record.at("satisfied").boolean();
  row.is_valid = record.at("valid").boolean();
  row.outcome = record.at("outcome").text();
  row.note = record.at("note").text();
  for (const auto& field : kWholeFields) field.in(row) = record.at(field.name).integer();
  for (const auto& field : kRealFields) field.in(row) = read_any_number(record.at(field.name));
  return row;
}

}  // namespace

std::string words_of_machine() {
  utsname names{};
  uname(&names);
  std::string words = std::string(names.machine) + ", " +
                      std::to_string(std::thread::hardware_concurrency()) + " processors";
  std::ifstream processors("/proc/cpuinfo");
  for (std::string line; std::getline(processors, line);)
    if (line.starts_with("model name")) return words + ", " + line.substr(line.find(':') + 2);
  return words;
}

std::string line_of(BenchRow row, const Sweep& sweep, std::size_t jobs) {
  JsonNode::Object record = object_of(
      JsonMember("version", node_of(sweep.version)), JsonMember("machine", node_of(sweep.machine)),
      JsonMember("suite", node_of(sweep.suite)),
      JsonMember("seed", node_of(std::to_string(sweep.seed))),
      JsonMember("time_limit", node_of(sweep.time_limit)),
      JsonMember("repeat", node_of(sweep.repeat)),
      JsonMember("jobs", node_of(static_cast<double>(jobs))),
      JsonMember("job", node_of(static_cast<double>(row.job))),
      JsonMember("scene", node_of(row.scene)), JsonMember("difficulty", node_of(row.difficulty)),
      JsonMember("energy", node_of(row.energy)), JsonMember("method", node_of(row.method)),
      JsonMember("parameters", parameters_node(row.parameters, *find_density(row.energy))),
      JsonMember("satisfied", {row.is_satisfied}), JsonMember("valid", {row.is_valid}),
      JsonMember("outcome", node_of(row.outcome)), JsonMember("note", node_of(row.note)));
  for (const auto& field : kWholeFields) record.emplace_back(field.name, node_of(field.in(row)));
  for (const auto& field : kRealFields) record.emplace_back(field.name, any_number(field.in(row)));
  return json_line({std::move(record)});
}

SweepRecord read_record(const std::string& line, const std::string& file, int number) {
  try {
    const JsonNode node = parse_json(line, file);
    const JsonValue value(node, file);
    SweepRecord record{row_in(value), "", ""};
    for (const char* key : kOfSweep) record.sweep += json_line(value.at(key).node()) + '\n';
    record.run = record.sweep;
    for (const char* key : kOfRun) record.run += json_line(value.at(key).node()) + '\n';
    record.jobs = static_cast<std::size_t>(value.at("jobs").integer());
    return record;
  } catch (const Error&) {
    throw Error(file + ':' + std::to_string(number) +
                ": is no record that bench --append wrote; take the line out");
  }
}

SweepRecord record_of(const BenchJob& job, std::size_t number, const Sweep& sweep,
                      std::size_t jobs) {
  BenchRow row;
  row.job = number;
  row.scene = job.scene->name;
  row.energy = job.scene->scene.energy->name;
  row.method = job.parameters.method;
  row.parameters = job.parameters;
  return read_record(line_of(std::move(row), sweep, jobs), "a job", 0);
}

}  // namespace foldless
