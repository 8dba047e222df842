#pragma once

#include <cstddef>
#include <filesystem>

namespace tremolo::results {

/// A run with more frames would take minutes to describe.
inline constexpr std::size_t most_vtk_frames = 2000;

/// Adds the group /VTKHDF to the closed file of a run, by which ParaView (5.12 and later; 5.11 shows all
/// frames at once) and VTK (9.1: files of one frame) open it: an unstructured grid of version 2.0 of the
/// format, whose arrays are virtual datasets on the frames that are there. Each time has two parts: particles
/// as vertices, those of the soil and of elastic structures, and what shapes.hpp finds as lines; `part` tells
/// them apart, 0 of the soil, and as there.
/// Vectors have three components, stress six (xx, yy, zz, xy, yz, xz). A run without frames, or with more
/// than most_vtk_frames, is left as it is.
/// @throws std::runtime_error where the file cannot be read or written, or has the group already
void add_vtkhdf(const std::filesystem::path& run_file);

} // namespace tremolo::results
