#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include <scalebreak/measure/contact_force.hpp>
#include <scalebreak/scene/flow_input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// Spheres as VTK's XML PolyData, for ParaView: centres as points (show them as spheres by `radius`), with id (from 1) and of velocity,
/// spin, radius, mass and material those that are among the fields as point data, in SI; numbers inline as base64.
[[nodiscard]] std::string spheres_vtp(const System& system, const ParticleFields& fields = all_particle_fields);

/// Contacts as VTK's XML PolyData: a line each, from the first centre along the branch, with the force on the first [N], its
/// magnitude, and whether they touch, as cell data.
[[nodiscard]] std::string contacts_vtp(const System& system, std::span<const ContactForce> contacts);

/// A series of such files for ParaView: times [s] and file names beside the .pvd.
[[nodiscard]] std::string pvd(std::span<const std::pair<double, std::string>> frames);

/// Bytes as base64 (RFC 4648).
[[nodiscard]] std::string base64(std::span<const unsigned char> bytes);

}  // namespace scalebreak
