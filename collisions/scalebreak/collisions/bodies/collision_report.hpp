#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scalebreak/collisions/bodies/scene_collision.hpp>

namespace scalebreak {

/// Writes how a collision went, in time, with plots and their scripts. Gives the plots that could not be drawn.
///
/// A head-on pair: trajectory.csv over the contact, events.csv, force_overlap. Another pair: trajectory.csv with forces, motion and
/// energy account, events.csv, force_overlap, tangential, energy. A scene of [[body]]: trajectory.csv (body by body), contacts.csv
/// (pair by pair), energy.csv, outlines.csv, events.csv, speeds, paths, energy.
[[nodiscard]] std::vector<std::string> write_collision_files(const Input& input, const SceneCollision& result,
                                                             const std::filesystem::path& folder);

/// The terms of an account with their names, in the order of its sum.
[[nodiscard]] std::vector<std::pair<std::string, double>> terms_of(const EnergyAccount& account);

}  // namespace scalebreak
