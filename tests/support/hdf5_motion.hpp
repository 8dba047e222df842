#pragma once

#include <hdf5.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::testing {

/// A motion in HDF5 as a user writes it with h5py.
struct Hdf5Motion {
  std::vector<double> samples;
  std::optional<double> dt;
  std::map<std::string, std::string> texts;
  std::string name = "motion";
  bool variable_length = true; ///< texts as h5py writes str; otherwise as numpy writes bytes
};

inline void write_hdf5(const std::filesystem::path& path, const Hdf5Motion& motion) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t count = motion.samples.size();
  const hid_t line = H5Screate_simple(1, &count, nullptr);
  const hid_t scalar = H5Screate(H5S_SCALAR);
  const hid_t data =
      H5Dcreate2(file, motion.name.c_str(), H5T_NATIVE_DOUBLE, line, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, motion.samples.data());
  if (motion.dt) {
    const hid_t dt = H5Acreate2(data, "dt", H5T_NATIVE_DOUBLE, scalar, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(dt, H5T_NATIVE_DOUBLE, &*motion.dt);
    H5Aclose(dt);
  }
  for (const auto& [key, text] : motion.texts) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, motion.variable_length ? H5T_VARIABLE : text.size());
    const hid_t attribute = H5Acreate2(data, key.c_str(), type, scalar, H5P_DEFAULT, H5P_DEFAULT);
    const char* pointer = text.c_str();
    H5Awrite(attribute, type, motion.variable_length ? static_cast<const void*>(&pointer) : pointer);
    H5Aclose(attribute);
    H5Tclose(type);
  }
  H5Dclose(data);
  H5Sclose(scalar);
  H5Sclose(line);
  H5Fclose(file);
}

} // namespace tremolo::testing
