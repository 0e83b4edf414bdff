#include <scalebreak/dem/dem.hpp>

#include <scalebreak/dem/engine.hpp>

namespace scalebreak {

Dem::Dem(const System& start, const DemSetup& setup) : engine_(std::make_unique<Engine>(start, setup)) {}
Dem::Dem(std::string_view saved, const DemSetup& setup) : engine_(std::make_unique<Engine>(saved, setup)) {}
Dem::~Dem() = default;
Dem::Dem(Dem&&) noexcept = default;
Dem& Dem::operator=(Dem&&) noexcept = default;

void Dem::advance(long steps) { engine_->advance(steps); }
void Dem::keep_sums(bool keep) { engine_->keep_sums_ = keep; }
double Dem::time() const { return engine_->time(); }
long Dem::steps() const { return engine_->steps_; }
std::size_t Dem::count() const { return engine_->spheres_.count(); }
const DemTotals& Dem::totals() const { return engine_->totals_; }
System Dem::system() const { return engine_->system(); }
std::vector<ContactForce> Dem::contact_forces() const { return engine_->contact_forces(); }
double Dem::elastic_energy() const { return engine_->elastic_energy(); }
std::size_t Dem::bytes() const { return engine_->bytes(); }
const char* Dem::kernel_name() const { return engine_->kernel_.name; }
std::string Dem::save() const { return engine_->save(); }

}  // namespace scalebreak
