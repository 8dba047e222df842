#include "motion/formats/formats.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace tremolo::motion {

namespace {

/// Owns one HDF5 identifier.
class Id {
public:
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  ~Id() {
    if (id_ >= 0)
      close_(id_);
  }
  hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& text) {
  throw RecordError(fmt::format("{}: {}", file.string(), text));
}

/// Texts longer than this are no word of ours.
constexpr std::size_t longest_text = 64;

std::optional<std::string> fixed_text(hid_t attribute, hid_t type) {
  const std::size_t size = H5Tget_size(type);
  if (size == 0 || size > longest_text)
    return std::nullopt;
  std::string text(size, '\0');
  if (H5Aread(attribute, type, text.data()) < 0)
    return std::nullopt;
  text.resize(std::min(text.size(), text.find('\0')));
  return text;
}

std::optional<std::string> variable_text(hid_t attribute, hid_t type) {
  char* read = nullptr;
  if (H5Aread(attribute, type, &read) < 0 || read == nullptr)
    return std::nullopt;
  std::string text(read, strnlen(read, longest_text));
  H5free_memory(read);
  return text;
}

bool is_scalar(hid_t attribute) {
  const Id space(H5Aget_space(attribute), H5Sclose);
  return space && H5Sget_simple_extent_npoints(space.get()) == 1;
}

/// A text attribute; nothing if there is none.
std::optional<std::string> text_of(hid_t dataset, const char* key, const std::filesystem::path& file) {
  if (H5Aexists(dataset, key) <= 0)
    return std::nullopt;
  const Id attribute(H5Aopen(dataset, key, H5P_DEFAULT), H5Aclose);
  std::optional<std::string> text;
  if (attribute && is_scalar(attribute.get())) {
    const Id type(H5Aget_type(attribute.get()), H5Tclose);
    if (type && H5Tget_class(type.get()) == H5T_STRING)
      text = H5Tis_variable_str(type.get()) > 0 ? variable_text(attribute.get(), type.get())
                                                : fixed_text(attribute.get(), type.get());
  }
  if (!text)
    refuse(file, fmt::format("attribute '{}' of 'motion' is not a short text", key));
  return text;
}

/// The enumerator that a text attribute names; nothing if there is no such attribute.
template <class Enum>
std::optional<Enum> word_of(hid_t dataset, const char* key, std::optional<Enum> (*named)(std::string_view),
                            const std::filesystem::path& file) {
  const auto text = text_of(dataset, key, file);
  if (!text)
    return std::nullopt;
  const auto found = named(*text);
  if (!found)
    refuse(file, fmt::format("attribute '{}' of 'motion' is '{}', which is not known", key, shown(*text)));
  return found;
}

double step_of(hid_t dataset, const std::filesystem::path& file) {
  if (H5Aexists(dataset, "dt") <= 0)
    refuse(file, "dataset 'motion' has no attribute 'dt', the time step in s");
  const Id attribute(H5Aopen(dataset, "dt", H5P_DEFAULT), H5Aclose);
  double dt = 0.0;
  if (!attribute || !is_scalar(attribute.get()) || H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &dt) < 0)
    refuse(file, "attribute 'dt' of 'motion' is not a number");
  if (!(dt > 0.0) || !std::isfinite(dt))
    refuse(file, fmt::format("dt = {} s, must be > 0", dt));
  return dt;
}

std::vector<double> samples_of(hid_t dataset, const std::filesystem::path& file) {
  const Id space(H5Dget_space(dataset), H5Sclose);
  if (!space || H5Sget_simple_extent_ndims(space.get()) != 1)
    refuse(file, "dataset 'motion' must have one dimension");
  hsize_t count = 0;
  H5Sget_simple_extent_dims(space.get(), &count, nullptr);
  if (count < 2 || static_cast<double>(count) > most_samples)
    refuse(file, fmt::format("{} samples, must be from 2 to {:g}", count, most_samples));
  const Id type(H5Dget_type(dataset), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER)
    refuse(file, "dataset 'motion' does not hold numbers");
  std::vector<double> samples(count);
  if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, samples.data()) < 0)
    refuse(file, "dataset 'motion' cannot be read: the file is damaged");
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (!std::isfinite(samples[i]))
      refuse(file, fmt::format("sample {} is {}, must be finite", i, samples[i]));
  return samples;
}

} // namespace

Record read_hdf5(const std::filesystem::path& file, const ReadAs& as) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Id opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!opened)
    refuse(file, "looks like HDF5 but cannot be opened: damaged, or in use");
  const Id dataset(H5Dopen2(opened.get(), "motion", H5P_DEFAULT), H5Dclose);
  if (!dataset)
    refuse(file, "has no dataset 'motion'");
  Record record;
  record.dt = step_of(dataset.get(), file);
  const auto unit = word_of(dataset.get(), "unit", scaled_unit, file);
  Stated stated{.quantity = word_of(dataset.get(), "quantity", quantity_named, file),
                .unit = unit,
                .kind = word_of(dataset.get(), "kind", kind_named, file)};
  if (unit && stated.quantity && quantity_of(unit->unit) != *stated.quantity)
    refuse(file, fmt::format("unit '{}' is not one of {}", name(*unit), name(*stated.quantity)));
  if (unit)
    stated.quantity = quantity_of(unit->unit);
  record.samples = samples_of(dataset.get(), file);
  record.origin.format = "HDF5";
  settle(record, {}, stated, as, false, file.string());
  return record;
}

} // namespace tremolo::motion
