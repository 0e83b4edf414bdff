#include <scalebreak/particle_files/read_particles.hpp>

#include <filesystem>

#include <scalebreak/base/error.hpp>
#include <scalebreak/particle_files/extended_xyz.hpp>
#include <scalebreak/particle_files/lammps_data.hpp>
#include <scalebreak/particle_files/particle_csv.hpp>

namespace scalebreak {

System read_particles(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  if (ending == ".csv") return read_particles_csv(file);
  if (ending == ".xyz" || ending == ".extxyz") return read_extended_xyz(file);
  if (ending == ".data" || ending == ".lmp") return read_lammps_data(file);
  throw InputError(file + ": found an unknown ending; allowed: .csv, .xyz, .extxyz, .data, .lmp");
}

}  // namespace scalebreak
