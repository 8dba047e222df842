// What ParaView will see of a run. /VTKHDF must show the frames as the format says (checked wherever h5py
// is), and to VTK's own reader, which in Debian knows files of one frame. The XDMF must describe the arrays
// of the HDF5 file as they are (checked wherever h5py is), and VTK's own XDMF reader must return times,
// positions and fields (checked where python3 has that reader: ParaView's does; Debian builds python3-vtk9
// without it).

#include "../../unit/results/sample_run.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <string>

using namespace sample_run;

namespace {

constexpr int module_absent = 77;

int run_script(const std::string& interpreter, const std::string& script, const std::filesystem::path& xdmf) {
  const std::string path = tremolo::source_dir() + "/tests/system/results/" + script;
  const int state = std::system((interpreter + " " + path + " " + xdmf.string()).c_str());
  return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
}

void write_run(const std::filesystem::path& file, std::size_t frames) {
  tremolo::results::RunWriter run(file, description);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    write_frame(run, frame);
  }
  run.finish();
}

class Xdmf : public testing::Test {
protected:
  Xdmf() { write_run(folder_ / "run.h5", 3); }
  std::filesystem::path xdmf() const { return folder_ / "run.xdmf"; }

private:
  Folder folder_;
};

TEST_F(Xdmf, DescribesTheArraysOfTheRun) {
  const int state = run_script("/usr/bin/python3", "check_xdmf.py", xdmf());
  if (state == module_absent) {
    GTEST_SKIP() << "/usr/bin/python3 has no h5py (Debian package python3-h5py)";
  }
  EXPECT_EQ(state, 0);
}

TEST_F(Xdmf, IsReadByVtk) {
  int state = module_absent;
  for (const std::string interpreter : {"/usr/bin/python3", "python3", "pvpython"}) {
    if (std::system(("command -v " + interpreter + " > /dev/null").c_str()) == 0 && state == module_absent) {
      state = run_script(interpreter, "read_xdmf.py", xdmf());
    }
  }
  if (state == module_absent) {
    GTEST_SKIP() << "no python3 here has vtkmodules.vtkIOXdmf2, VTK's XDMF reader";
  }
  EXPECT_EQ(state, 0);
}

class VtkHdf : public testing::TestWithParam<std::size_t> {};

TEST_P(VtkHdf, ShowsTheFrames) {
  const Folder folder;
  write_run(folder / "run.h5", GetParam());
  const int state = run_script("/usr/bin/python3", "check_vtkhdf.py", folder / "run.h5");
  if (state == module_absent) {
    GTEST_SKIP() << "/usr/bin/python3 has no h5py (Debian package python3-h5py)";
  }
  EXPECT_EQ(state, 0);
}

INSTANTIATE_TEST_SUITE_P(Frames, VtkHdf, testing::Values(1, 7));

} // namespace
