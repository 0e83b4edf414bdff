#include <ctime>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/rules/constant_restitution.hpp>
#include <scalebreak/start/filling.hpp>

using namespace scalebreak;
int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 20000;
  const double phi = argc > 2 ? std::atof(argv[2]) : 0.3, allowance = argc > 3 ? std::atof(argv[3]) : 0;
  Filling f;
  f.radius.assign(n, 0.5), f.mass.assign(n, 1), f.material.assign(n, 0);
  f.cell.size = Eigen::Vector3d::Constant(std::cbrt(double(n) * M_PI / 6 / phi));
  f.speed = std::sqrt(3.0);
  EventSpheres<CalendarQueue, SmoothRule> flow(fill(f), {.allowance = allowance}, {1.0});
  flow.advance_collisions(long(n) * 5);
  const long l0 = flow.totals().lists, s0 = flow.totals().stale; 
  const auto q0 = flow.queue_operations();
  const std::clock_t start = std::clock();
  const long c = argc > 4 ? std::atol(argv[4]) : 1000000;
  flow.advance_collisions(c);
  const double t = double(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf("phi %g allowance %g: %.3g collisions/s, lists/coll %.3f stale %.3f queue ops %.2f neighbours %.2f\n", phi, allowance, double(c) / t, double(flow.totals().lists - l0) / double(c),
              double(flow.totals().stale - s0) / double(c), double(flow.queue_operations() - q0) / double(c), flow.mean_neighbours());
}
