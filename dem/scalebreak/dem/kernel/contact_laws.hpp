// Included once per instruction set, inside that set's namespace (see kernel_*.cpp): the laws between the spheres of ContactLanes.

/// A normal law as packs, and what it is in the rows.
template <template <class> class Law>
struct Form {
  using Packed = Law<Pack>;
  using Source = Law<double>;
};

/// Which laws act, of all rows alike.
struct Acting {
  bool friction, rolling, rigid, liquid, root;
  explicit Acting(const ContactLaws& laws)
      : friction(laws.tangential.acts()),
        rolling(laws.rolling.acts()),
        rigid(laws.rolling.rigid()),
        liquid(laws.liquid.acts()),
        root(laws.needs_overlap_root()) {}
};

template <class LawForm, Turns turns>
struct PackedLaws {
  typename LawForm::Packed normal;
  TangentialOf<Pack> friction;
  RollingOf<Pack> rolling;
  LiquidOf<Pack> liquid;
  Pack radius;

  /// `pack` makes a law of packs, given its type and how it is found in a row.
  template <class MakeLaw>
  [[gnu::always_inline]] void make(const Acting& acting, MakeLaw law) {
    using Source = typename LawForm::Source;
    law(
        normal, [](const ContactLaws& laws) __attribute__((always_inline))->const Source& { return *std::get_if<Source>(&laws.normal); });
    if constexpr (turns != Turns::none)
      law(
          friction, [](const ContactLaws& laws) __attribute__((always_inline))->const Tangential& { return laws.tangential; });
    if constexpr (turns == Turns::all) {
      if (acting.rolling)
        law(
            rolling, [](const ContactLaws& laws) __attribute__((always_inline))->const Rolling& { return laws.rolling; });
      if (acting.liquid)
        law(
            liquid, [](const ContactLaws& laws) __attribute__((always_inline))->const Liquid& { return laws.liquid; });
    }
  }
  [[gnu::always_inline]] void make_of_all(const ForceTask& task, const Acting& acting) {
    make(
        acting, [&](auto& law, auto part) __attribute__((always_inline)) { law = law_of_all<std::decay_t<decltype(law)>>(task, part); });
    radius = Pack(task.rows[0].radius);
  }
  [[gnu::always_inline]] void make_normal_of_rows(const ForceTask& task, const ContactLanes& at) {
    using Source = typename LawForm::Source;
    normal = law_of_rows<typename LawForm::Packed>(
        task, at, [](const ContactLaws& row) -> const Source& { return *std::get_if<Source>(&row.normal); });
  }
  [[gnu::always_inline]] void make_of_rows(const ForceTask& task, const ContactLanes& at, const Acting& acting) {
    make(
        acting, [&](auto& law, auto part)
                    __attribute__((always_inline)) { law = law_of_rows<std::decay_t<decltype(law)>>(task, at, part); });
    radius = Pack([&](auto lane) { return task.rows[at.row[lane]].radius; });
  }
};

/// What a contact exerts: the force on its second sphere, and torques on both.
struct Exerted {
  Vectors force, torque1, torque2;
};

/// The overlap of the original pair, and the normal law's own coordinate there. Its roots depend on each other: what is made of several
/// packs at a time here is made side by side by the processor.
template <class LawForm>
[[gnu::always_inline]] inline void press(const ForceTask& task, const typename LawForm::Packed& law, ContactLanes& at) {
  using std::sqrt;
  constexpr bool adhesive = LawForm::Source::traits.adhesive();
  const Pack distance = sqrt(at.square);
  at.inverse = 1.0 / distance;
  at.overlap = task.length * (at.touch - distance);
  at.coordinate = law.coordinate(adhesive ? at.overlap : positive_part(at.overlap));
}

/// All laws of the contacts `at`, at the variables of the original pair; their histories go on.
template <class LawForm, Turns turns, bool wall>
[[gnu::always_inline]] inline Exerted exert(const ForceTask& task, const Acting& acting, const PackedLaws<LawForm, turns>& laws,
                                            const ContactLanes& at, const Motion& motion) {
  using std::sqrt;
  const Pack time(task.history_step * task.length), after(task.history_after * task.length);
  const Vectors normal = at.inverse * at.between;
  const Pack approach = normal.dot(motion.velocity), depth = at.overlap, x = at.coordinate;
  Pack along = laws.normal.force(x) + laws.normal.damping(x) * approach;
  ContactPointOf<Pack> point{.overlap = depth, .root = laws.normal.root_radius(x), .load = abs(laws.normal.load(x, along))};
  if constexpr (LawForm::Source::traits.coordinate == Coordinate::overlap_root) {
    point.overlap_root = x;
  } else if (acting.root) {
    point.overlap_root = sqrt(sqrt(laws.radius * positive_part(depth)));
  }
  if (at.partly) {
    along *= at.solid;
    point.load *= at.solid;
  }
  Exerted out;
  if constexpr (turns == Turns::none) {
    out.force = along * normal;
  } else {
    Vectors speed = motion.velocity - approach * normal, first, second, across;
    Pack arm1, arm2;
    if constexpr (turns == Turns::sliding) {
      speed = speed + (task.spin * task.radius_share) * motion.swirl.cross(normal);
    } else {
      // How the normal turns the spheres' surfaces, and at which arms.
      const Pack spin(task.spin), share(task.radius_share), lost(task.rows[0].arm == TorqueArm::contact ? wall ? 1.0 : 0.5 : 0.0);
      first = spin * motion.spin1.cross(normal), second = spin * motion.spin2.cross(normal);
      arm1 = share * motion.radius1 - lost * depth, arm2 = share * motion.radius2 - (wall ? Pack(0) : lost) * depth;
      speed = speed + arm1 * first + arm2 * second;
    }
    if (turns == Turns::sliding || acting.friction) {
      Vectors history = in_plane(histories(task.contacts.slide, at.begin), normal);
      across = step_slider(laws.friction.at(point), false, history, speed, time, after);
      put(task.contacts.slide, at.begin, history);
      if (at.partly) across = at.solid * across;
    }
    if constexpr (turns == Turns::sliding) {
      const Vectors per_arm = Pack(-task.torque * task.radius_share) * normal.cross(across);
      out.torque1 = motion.radius1 * per_arm, out.torque2 = motion.radius2 * per_arm;
    } else {
      Vectors turning;
      if (acting.rolling) {
        Vectors history = acting.rigid ? Vectors{} : in_plane(histories(task.contacts.roll, at.begin), normal);
        turning = step_slider(laws.rolling.at(point), acting.rigid, history, first - second, time, after);
        if (!acting.rigid) put(task.contacts.roll, at.begin, history);
        if (at.partly) turning = at.solid * turning;
      }
      if (acting.liquid) {
        const LiquidOf<Pack>& liquid = laws.liquid;
        const Pack separation = max(-depth, liquid.separation_min), acts = at.partly ? at.acts : Pack(1);
        along += acts * (liquid.normal_drag(separation) * approach - liquid.capillary_force(separation));
        if (liquid.viscous) {
          const Vectors centres = motion.velocity - approach * normal;
          const Pack radius1 = task.radius_share * motion.radius1, radius2 = task.radius_share * motion.radius2;
          across = across + acts * (liquid.tangential_drag(separation) * centres +
                                    liquid.rolling_drag(separation) * (radius1 * first + radius2 * second));
        }
      }
      const Pack torque(-task.torque);
      out.torque1 = torque * normal.cross(arm1 * across + turning);
      out.torque2 = torque * normal.cross(arm2 * across - turning);
    }
    out.force = along * normal + across;
  }
  out.force = Pack(task.force) * out.force;
  return out;
}
