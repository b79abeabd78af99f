// Fits of friction without waves and with one to three, each wave from the candidates of a scan.
#pragma once

#include <vector>

#include "inference/descent.h"
#include "inference/force_model.h"
#include "inference/wavelength_scan.h"

namespace flexslip {

FitPoint fit_mean(const ForceModel& model, bool drift, const HeldValues& held);

// One wave more than the base, from each candidate of a scan, the best polished; best first, each wavelength once.
// Empty if there is no candidate.
std::vector<FitPoint> fit_next_wave(const ForceModel& model, const FitPoint& base, const WavelengthScan& scan,
                                    std::size_t most_candidates, const HeldValues& held);

// What is free in a layout where some values are held.
Freedom freedom_within(const ForceModel& model, const ModelLayout& layout, const HeldValues& values);

// One wave of a given wavelength [L] by linear least squares on the profile.
Eigen::VectorXd wave_of_profile(const ForceModel& model, const FitPoint& point, double wavelength);

// What a solution leaves of the profile.
std::vector<ProfilePoint> without_waves(const ForceModel& model, const FitPoint& point);

}  // namespace flexslip
