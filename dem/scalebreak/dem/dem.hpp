#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/measure/contact_force.hpp>
#include <scalebreak/scaling/mapped_laws.hpp>
#include <scalebreak/scene/flow_input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// What a soft-sphere engine is given beside the spheres, SI. Materials are those of the ORIGINAL system; the spheres handed over are
/// the scaled ones, their radii `size_factor` times the original's, and the engine applies the law to every contact.
struct DemSetup {
  ContactKind contact;
  SurfaceKind surface;
  Material material, second;
  Wall wall;
  ScalingLaw law = scaling_laws().front();
  double factor = 1;
  Eigen::Vector3d gravity{0, 0, 0};  ///< acceleration [m/s²]
  bool wall_no_slip = false;         ///< a sphere that touches a wall has no spin (Washino et al. 2024, section 5)
  double pressure = 0;               ///< normal stress P_zz that the height of the cell follows (height.hpp) [Pa]; 0: it is kept
  double step = 0;                   ///< [s]
  Integrator integrator = Integrator::verlet;
  int threads = 1;
  const char* kernel = nullptr;  ///< instruction set, see dem/kernel; null: the best of this processor
};

/// Running totals since the start, as Sample wants them.
struct DemTotals {
  double contact_starts = 0;                                 ///< of a sphere at a wall ½
  double contact_time = 0;                                   ///< [s]; of a sphere at a wall ½
  double wall_work = 0;                                      ///< done on the spheres by moving walls, or by the height as it changes [J]
  Eigen::Matrix3d contact_moment = Eigen::Matrix3d::Zero();  ///< −∫Σ force branchᵀ dt [N m s]
  double pairs_tested = 0;                                   ///< near pairs, summed over steps
  double lists_made = 0, grids_made = 0;                     ///< times that the near pairs, and that all neighbours were found anew
};

/// The soft-sphere engine: velocity Verlet with the laws of lib on neighbour lists.
///
/// Bits: the same for the same number of threads and the same instruction set; also across save() and a Dem made of it.
class Dem {
 public:
  /// Throws InputError where the spheres and the cell do not go together (a periodic edge too short, no step, a pressure without
  /// periodic faces).
  Dem(const System& start, const DemSetup& setup);
  /// Goes on where another left off; the setup must be the one that it had.
  Dem(std::string_view saved, const DemSetup& setup);
  ~Dem();
  Dem(Dem&&) noexcept;
  Dem& operator=(Dem&&) noexcept;

  /// Throws WorkError, one sentence, where the run became unstable: a sphere that moves by a tenth of its radius in a step, or is nowhere,
  /// or a height that leaves no room between a sphere and its images.
  void advance(long steps);

  /// Whether the sum over contacts (contact_moment) is kept at every step; true at the start. It costs some per cent.
  void keep_sums(bool keep);

  [[nodiscard]] double time() const;
  [[nodiscard]] long steps() const;
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] const DemTotals& totals() const;
  /// The state at this time, in the order of identity, velocities brought up to it; under a pressure they are without the affine motion
  /// of the height.
  [[nodiscard]] System system() const;
  [[nodiscard]] std::vector<ContactForce> contact_forces() const;
  /// Of all springs: normal, tangential and rolling; of a liquid's capillary force [J].
  [[nodiscard]] double elastic_energy() const;
  [[nodiscard]] std::size_t bytes() const;  ///< of memory
  [[nodiscard]] const char* kernel_name() const;

  /// Everything, bit for bit.
  [[nodiscard]] std::string save() const;

 private:
  class Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace scalebreak
