#include <complex>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include <lib/fillings.hpp>
#include <scalebreak/cell/cell_grid.hpp>
#include <scalebreak/start/filling.hpp>

namespace scalebreak {
namespace {

using tests::filling_of;

/// From every centre to those nearer than a distance, each pair once.
std::vector<Eigen::Vector3d> bonds(const System& system, double distance) {
  std::vector<Eigen::Vector3d> all;
  const std::vector<double> none(system.count(), 0.0);
  CellGrid(system.cell, system.position, none, distance).for_each_pair([&](auto, auto, const Eigen::Vector3d& bond) {
    all.push_back(bond);
  });
  return all;
}

/// Steinhardt's order parameter Q6 of all bonds together: 0.57 of fcc, 0.48 of hcp, 1/√bonds where they are independent.
double bond_order(const std::vector<Eigen::Vector3d>& bonds) {
  double sum = 0;
  for (int m = 0; m <= 6; ++m) {
    std::complex<double> mean = 0;
    for (const Eigen::Vector3d& bond : bonds) {
      const double polar = std::acos(bond.z() / bond.norm()), azimuth = std::atan2(bond.y(), bond.x());
      mean += std::sph_legendre(6, static_cast<unsigned>(m), polar) * std::polar(1.0, m * azimuth) / static_cast<double>(bonds.size());
    }
    sum += (m == 0 ? 1 : 2) * std::norm(mean);
  }
  return std::sqrt(4 * std::numbers::pi / 13 * sum);
}

/// Pair correlation of unit spheres from contact to a small way beyond.
double contact_correlation(const System& system, double beyond) {
  const auto count = static_cast<double>(system.count());
  const double shell = 4 * std::numbers::pi / 3 * (std::pow(1 + beyond, 3) - 1);
  return 2 * static_cast<double>(bonds(system, 1 + beyond).size()) / count / (count / system.cell.volume() * shell);
}

/// Of a fluid of hard spheres, at contact (Carnahan & Starling 1969).
double fluid_contact_correlation(double fraction) { return (1 - fraction / 2) / std::pow(1 - fraction, 3); }

System face_centred(int cells) {
  System system;
  system.cell.size.setConstant(cells * std::sqrt(2.0));
  for (int k = 0; k < 8 * cells * cells * cells; ++k) {
    const Eigen::Vector3i at(k % (2 * cells), k / (2 * cells) % (2 * cells), k / (4 * cells * cells));
    if (at.sum() % 2 == 0) system.position.push_back(at.cast<double>() / std::sqrt(2.0));
  }
  return system;
}

TEST(FillingStructure, TheMeasureOfOrderKnowsACrystal) { EXPECT_NEAR(bond_order(bonds(face_centred(5), 1.2)), 0.5745, 1e-4); }

TEST(FillingStructure, BondsPointAnywhere) {
  for (const double fraction : {0.3, 0.5, 0.6}) {
    const auto all = bonds(fill(filling_of(4000, fraction)), 1.4);
    EXPECT_LT(bond_order(all), 3 / std::sqrt(static_cast<double>(all.size()))) << fraction;
  }
}

TEST(FillingStructure, ContactsAreAsManyAsInAFluid) {
  for (const double fraction : {0.1, 0.3, 0.5}) {
    const System system = fill(filling_of(8000, fraction));
    const double beyond = 0.02, found = contact_correlation(system, beyond);
    // The correlation falls beyond contact, at 0.5 by a tenth over this shell's half; so many pairs have this statistical error.
    const double pairs = static_cast<double>(bonds(system, 1 + beyond).size());
    EXPECT_NEAR(found / fluid_contact_correlation(fraction), 1, 0.1 + 3 / std::sqrt(pairs)) << fraction;
  }
}

TEST(FillingStructure, FabricIsIsotropic) {
  for (const double fraction : {0.5, 0.6}) {
    const auto all = bonds(fill(filling_of(8000, fraction)), 1.05);
    Eigen::Matrix3d fabric = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& bond : all) fabric += bond.normalized() * bond.normalized().transpose() / static_cast<double>(all.size());
    // Of independent bonds <(n·z)⁴> − 1/9 = 4/45 is the variance of a component on the diagonal.
    const double error = std::sqrt(4.0 / 45 / static_cast<double>(all.size()));
    EXPECT_LT((fabric - Eigen::Matrix3d::Identity() / 3).cwiseAbs().maxCoeff(), 4 * error) << fraction;
  }
}

/// Centres in slices, as a share of the even one.
Eigen::ArrayXd profile(const System& system, int axis, int slices) {
  Eigen::ArrayXd counts = Eigen::ArrayXd::Zero(slices);
  for (const Eigen::Vector3d& position : system.position)
    counts[std::min(slices - 1, static_cast<int>(position[axis] / system.cell.size[axis] * slices))] += 1;
  return counts * slices / static_cast<double>(system.count());
}

TEST(FillingStructure, HasNoLayersNorVoids) {
  for (const double fraction : {0.05, 0.5, 0.6}) {
    const System system = fill(filling_of(8000, fraction));
    for (int axis = 0; axis < 3; ++axis) {
      // 400 centres a slice, which fluctuate at most as independent ones do.
      EXPECT_LT((profile(system, axis, 20) - 1).abs().maxCoeff(), 3.5 * 0.05) << fraction << " axis " << axis;
    }
  }
}

TEST(FillingStructure, SizesAreMixed) {
  const System system = fill(filling_of(8000, 0.5, {0.5, 1.0}));
  Eigen::ArrayXd large = Eigen::ArrayXd::Zero(8);
  for (std::size_t i = 1; i < system.count(); i += 2)
    large[static_cast<int>(system.position[i].z() / system.cell.size.z() * 8)] += 8.0 / 4000;
  EXPECT_LT((large - 1).abs().maxCoeff(), 3.5 * std::sqrt(8.0 / 4000));
}

}  // namespace
}  // namespace scalebreak
