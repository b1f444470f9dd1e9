// Directions coupled by their radius: reference values, isotropy, work, and agreement with a single direction.
#include "component/bushes.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

using component::Coupling;
using component::SixDirections;
using component::SixDirectionsLaws;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const std::vector<Coupling> kRadial = {Coupling::cylindrical, Coupling::spherical};

// Returns a cubic curve F(r) of points. `size` is the radius of one of the points.
element::ElementDescription curve(double linear, double cubic, double size, int points) {
  std::vector<double> displacement;
  std::vector<double> force;
  for (int i = 0; i <= 2 * points; ++i) {
    const double r = size * i / points;
    displacement.push_back(r);
    force.push_back(linear * r + cubic * r * r * r);
  }
  return {"spring_table", {{"displacement", displacement}, {"force", force}, {"monotone", {1.0}}}};
}

Vector3d forceAt(const SixDirectionsLaws& laws, const Vector3d& d) {
  const SixDirections bush(laws);
  auto state = bush.makeState();
  return bush.initialise(state, poseAt(d, Vector3d::Zero())).wrench.force;
}

const Vector3d kReference(0.6e-3, -0.8e-3, 0.5e-3);

TEST(RadialCoupling, GivesTheForcesOfTheReference) {
  SixDirectionsLaws laws;
  laws.translation = Coupling::cylindrical;
  laws.elements[component::kX] = {curve(4e6, 2e12, 1e-3, 4)};
  laws.elements[component::kZ] = {spring(1e6)};
  EXPECT_LT((forceAt(laws, kReference) - Vector3d(3600.0, -4800.0, 500.0)).norm(), 1e-9);
  laws.elements[component::kY] = laws.elements[component::kX];
  EXPECT_LT((forceAt(laws, kReference) - Vector3d(3600.0, -4800.0, 500.0)).norm(), 1e-9);
  laws.translation = Coupling::spherical;
  laws.elements[component::kX] = {curve(4e6, 2e12, kReference.norm(), 4)};
  laws.elements[component::kY] = laws.elements[component::kZ] = {};
  EXPECT_LT((forceAt(laws, kReference) - Vector3d(3900.0, -5200.0, 3250.0)).norm(), 1e-9);
}

// The potential follows from the points of the two curves, up to the square of the distance between points.
TEST(RadialCoupling, GivesTheEllipticForcesOfTheReference) {
  SixDirectionsLaws laws;
  laws.translation = Coupling::cylindrical;
  laws.elements[component::kX] = {curve(4e6, 0.0, 1e-3, 1000)};
  laws.elements[component::kY] = {curve(1.6e6, 2e12, 1e-3, 1000)};
  laws.elements[component::kZ] = {spring(1e6)};
  EXPECT_LT((forceAt(laws, kReference) - Vector3d(2784.0, -2592.0, 500.0)).norm(), 1e-2);
  // Linear laws act along each direction independently, as they do without coupling.
  laws.elements[component::kY] = {curve(1.6e6, 0.0, 1e-3, 3)};
  EXPECT_LT((forceAt(laws, kReference) - Vector3d(2400.0, -1280.0, 500.0)).norm(), 1e-9);
}

// The law of the reference is split into springs and a radial stiffness. The latter has the whole cubic term, or only
// the part that the directions lack.
TEST(RadialCoupling, RectangularDirectionsShareARadialStiffness) {
  SixDirectionsLaws laws;
  laws.elements[component::kX] = {spring(4e6), entry("radial_stiffness cubic=2e12")};
  laws.elements[component::kY] = laws.elements[component::kX];
  laws.elements[component::kZ] = {spring(1e6)};
  EXPECT_LT((forceAt(laws, kReference) - Vector3d(3600.0, -4800.0, 500.0)).norm(), 1e-9);
  laws.translation = Coupling::cylindrical;
  EXPECT_LT((forceAt(laws, kReference) - Vector3d(3600.0, -4800.0, 500.0)).norm(), 1e-9);
  laws.translation = Coupling::rectangular;
  laws.elements[component::kX] = {spring(4e6), entry("progressive_stiffness cubic=2e12"),
                                  entry("radial_stiffness cubic=2e12 alone=0")};
  laws.elements[component::kY] = laws.elements[component::kX];
  EXPECT_LT((forceAt(laws, kReference) - Vector3d(3600.0, -4800.0, 500.0)).norm(), 1e-9);
  laws.elements[component::kRx] = laws.elements[component::kRy] = laws.elements[component::kRz] = {spring(250.0)};
  expectTangent(SixDirections(framed(laws)));
  laws.elements[component::kY].back().values["cubic"] = {1e12};  // other values with a potential
  const LoopWork work = closedLoop(SixDirections(laws), 20000);
  EXPECT_LT(std::abs(work.work), 1e-6 * work.turnover);
}

TEST(RadialCoupling, ARadialStiffnessOfOneDirectionIsRefused) {
  for (const component::Direction direction : {component::kX, component::kY, component::kZ}) {
    SixDirectionsLaws laws;
    laws.elements[direction] = {spring(4e6), entry("radial_stiffness cubic=2e12")};
    const std::string message = messageOf<std::invalid_argument>([&] { SixDirections bush(laws); });
    const std::string at = direction == component::kX ? "y" : direction == component::kY ? "x" : "z";
    EXPECT_EQ(message.rfind(at + ": radial_stiffness", 0), 0U);
    EXPECT_NE(message.find("accepted: the element in both x and y"), std::string::npos);
  }
}

TEST(RadialCoupling, SlidersFollowTheReference) {
  SixDirectionsLaws laws;
  laws.translation = Coupling::cylindrical;
  laws.elements[component::kX] = {entry("iwan_table yield_displacement=1.2e-5 stiffness=5e6")};
  const SixDirections bush(laws);
  auto state = bush.makeState();
  bush.initialise(state, poseAt({1e-3, 0.0, 0.0}, Vector3d::Zero()));
  constexpr int kSteps = 200000;
  Vector3d force;
  for (int i = 1; i < 3 * kSteps; ++i) {
    const double angle = 2.0 * element::kPi * i / kSteps;
    force = bush.step(state, 1e-3, poseAt(1e-3 * Vector3d(std::cos(angle), std::sin(angle), 0.0), Vector3d::Zero()))
                .wrench.force;
  }
  EXPECT_LT((force - Vector3d(0.722827229, 59.995645849, 0.0)).norm(), 1e-7);
  double work = 0.0;
  Vector3d last(1e-3, 1e-4, 0.0);
  bush.initialise(state, poseAt(last, Vector3d::Zero()));
  force.setZero();
  for (int i = 1; i <= kSteps; ++i) {
    const double angle = 2.0 * element::kPi * i / kSteps;
    const Vector3d at(0.8e-3 * std::cos(angle) + 2e-4, 0.5e-3 * std::sin(angle) + 1e-4, 0.0);
    const Vector3d now = bush.step(state, 1e-3, poseAt(at, Vector3d::Zero())).wrench.force;
    work += 0.5 * (force + now).dot(at - last);
    force = now;
    last = at;
  }
  EXPECT_NEAR(work, 0.2479063478978678, 1e-9);
}

// Rotating the path and the laws rotates the wrench: d becomes T d, and R becomes T R T^T for a rotation T.
TEST(RadialCoupling, IsIsotropic) {
  for (const Coupling coupling : kRadial) {
    const SixDirections bush(coupledLaws(coupling));
    for (unsigned seed = 1; seed < 6; ++seed) {
      const Vector3d axis =
          coupling == Coupling::cylindrical ? Vector3d(0.0, 0.0, 1.1 * seed) : Vector3d(0.3, 1.0, -0.2 * seed);
      const Matrix3d turn = poseAt(Vector3d::Zero(), axis).linear();
      auto state = bush.makeState();
      auto turned_state = bush.makeState();
      double largest = 0.0;
      for (int i = 0; i <= 400; ++i) {
        const Isometry3d pose = bush.pose(loopAt(2.5e-3 * i, seed));
        Isometry3d other = Isometry3d::Identity();
        other.translation() = turn * pose.translation();
        other.linear() = turn * pose.linear() * turn.transpose();
        const auto wrench = (i == 0 ? bush.initialise(state, pose) : bush.step(state, 5e-3, pose)).wrench;
        const auto expected = turned(turn, wrench);
        const auto found =
            (i == 0 ? bush.initialise(turned_state, other) : bush.step(turned_state, 5e-3, other)).wrench;
        largest = std::max(largest, wrench.force.norm());
        ASSERT_LT((found.force - expected.force).norm(), 1e-10 * (1.0 + largest)) << i;
        ASSERT_LT((found.moment - expected.moment).norm(), 1e-10 * (1.0 + largest)) << i;
      }
    }
  }
}

TEST(RadialCoupling, ElasticLawsDoNoWorkAndOthersTakeSome) {
  for (const Coupling coupling : kRadial) {
    SixDirectionsLaws elastic;
    elastic.translation = elastic.rotation = coupling;
    for (std::size_t i = 0; i < component::kDirections; ++i) {
      const double size = i < 3 ? 1e-3 : 0.2;
      const double k = (i < 3 ? 2e6 : 900.0) * (1.0 + 0.3 * static_cast<double>(i % 3));
      elastic.elements[i] = {spring(k), curve(k, k / size / size, size, 3 + static_cast<int>(i % 3)),
                             entry("bump_stop exponent=2", {{"stiffness", 3.0 * k},
                                                            {"gap", size * (0.5 + 0.2 * static_cast<double>(i % 3))},
                                                            {"reference_depth", size}})};
    }
    const LoopWork none = closedLoop(SixDirections(framed(elastic)), 20000);
    EXPECT_LT(std::abs(none.work), 1e-6 * none.turnover);
    for (unsigned seed = 1; seed < 8; ++seed) {
      const LoopWork some = closedLoop(SixDirections(framed(coupledLaws(coupling))), 4000, seed);
      EXPECT_GT(some.work, 0.01 * some.turnover) << seed;
    }
  }
}

// Along a radius, the component equals one with a single direction, even for a curve with branches and friction.
TEST(RadialCoupling, IsOneDirectionAlongARadius) {
  const component::Component one(fullElements(2e6, 1e-3));
  for (const Coupling coupling : kRadial) {
    const SixDirections bush(coupledLaws(coupling));
    const Vector3d axis = Vector3d(0.6, -0.8, coupling == Coupling::spherical ? 1.3 : 0.0).normalized();
    auto state = bush.makeState();
    auto expected = one.makeState();
    for (int i = 1; i < 3000; ++i) {
      // The steps cross several points of the curve, and zero.
      const double z = 3.4e-3 * std::sin(0.37 * i) * std::sin(0.011 * i) + 1e-4 * std::sin(1.3 * i);
      const double dt = 1e-3 * (1 + i % 3);
      const Vector3d force = bush.step(state, dt, poseAt(z * axis, Vector3d::Zero())).wrench.force;
      ASSERT_LT((force - one.step(expected, dt, z).total * axis).norm(), 1e-8) << i;
    }
  }
}

// On a curved path with branches along a curve, halving the step divides the error by four.
TEST(RadialCoupling, ConvergesWithTheStep) {
  SixDirectionsLaws laws = coupledLaws(Coupling::cylindrical);
  for (std::size_t i = 0; i < 3; ++i) {
    auto& elements = laws.elements[i];
    elements = {elements[3], elements[4]};
  }
  const SixDirections bush(laws);
  const auto forceAfter = [&](int steps) {
    auto state = bush.makeState();
    Vector3d force;
    for (int i = 0; i <= steps; ++i) {
      const double angle = 2.0 * i / steps;
      const Vector3d at(2.2e-3 * std::cos(angle), 1.4e-3 * std::sin(angle), 0.0);
      const Isometry3d pose = poseAt(at, Vector3d::Zero());
      force = (i == 0 ? bush.initialise(state, pose) : bush.step(state, 0.1 / steps, pose)).wrench.force;
    }
    return force;
  };
  const Vector3d fine = forceAfter(12800);
  const double coarse_error = (forceAfter(100) - fine).norm();
  EXPECT_LT((forceAfter(200) - fine).norm(), 0.35 * coarse_error);
  EXPECT_LT(coarse_error, 1e-3 * fine.norm());
}

std::string refusal(const SixDirectionsLaws& laws) {
  return messageOf<std::invalid_argument>([&] { SixDirections bush(laws); });
}

TEST(RadialCoupling, RefusesWhatHasNoFormByTheRadius) {
  const std::vector<std::string> accepted = {
      "spring",  "spring_table",        "bump_stop", "maxwell", "maxwell_along_curve",
      "dashpot", "dashpot_along_curve", "springpot", "iwan",    "iwan_table"};
  for (const element::ElementType& type : element::elementTypes()) {
    if (std::find(accepted.begin(), accepted.end(), type.name) != accepted.end() || type.name == "friction") {
      continue;
    }
    SixDirectionsLaws laws;
    laws.translation = Coupling::cylindrical;
    laws.elements[component::kY] = {{type.name, {}}};
    for (const element::ParameterInfo& parameter : type.parameters) {
      if (!parameter.default_value) {
        laws.elements[component::kY][0].values[parameter.name] = {1.0};
      }
    }
    const std::string message = refusal(laws);
    // Some laws refuse the value 1 of a parameter before the coupling is checked.
    EXPECT_EQ(message.rfind("x: ", 0) == 0 || message.rfind("y: ", 0) == 0, true) << type.name << ": " << message;
    EXPECT_NE(message.find(type.name), std::string::npos) << message;
  }
}

TEST(RadialCoupling, NamesTheIwanOfBergsNumbers) {
  SixDirectionsLaws laws;
  laws.translation = Coupling::spherical;
  laws.elements[component::kZ] = {friction(5000.0, 2.2e-3)};
  const std::string message = refusal(laws);
  EXPECT_NE(message.find("{type: iwan, maximum_force: 5000, displacement: 0.0022}"), std::string::npos) << message;
  // The message states the ratio of the forces of settled loops.
  const auto peak = [](const element::ElementDescription& friction) {
    const component::Component component({friction});
    auto state = component.makeState();
    double last = 0.0;
    for (int i = 1; i <= 40250; ++i) {  // ends at a maximum of the displacement
      last = component.step(state, 1e-3, 2.2e-3 * std::sin(2.0 * element::kPi * i / 1000.0)).total;
    }
    return last;
  };
  const double ratio =
      peak(entry("iwan maximum_force=5000 displacement=2.2e-3")) / peak(laws.elements[component::kZ][0]);
  const std::string words = " has ";
  EXPECT_NEAR(std::stod(message.substr(message.rfind(words) + words.size())), ratio, 5e-3);
}

TEST(RadialCoupling, RefusesLawsThatDoNotGoTogether) {
  Entries other_friction = fullElements(2e6, 1e-3);
  other_friction.back().values["maximum_force"] = {1.0};
  const struct {
    Entries x;
    Entries y;
    std::string words;
  } rows[] = {{fullElements(2e6, 1e-3), other_friction, "y: its friction differs from the friction of x"},
              {{spring(1.0)}, {entry("spring_table displacement=-1e-3,0,1e-3 force=-1,0,2")}, "odd"},
              {{spring(1.0)}, {entry("spring_table displacement=0,1e-3 force=1,2 monotone=0")}, "at 0"},
              {{spring(1.0)},
               {entry("maxwell_along_curve displacement=0,1e-3 stiffness=1,2 break_frequency=1")},
               "y: maxwell_along_curve.stiffness"},
              {{spring(1.0)}, {entry("bump_stop stiffness=1 gap=1 side=-1")}, "y: bump_stop.side"}};
  SixDirectionsLaws laws;
  laws.translation = Coupling::cylindrical;
  for (const auto& row : rows) {
    laws.elements[component::kX] = row.x;
    laws.elements[component::kY] = row.y;
    EXPECT_NE(refusal(laws).find(row.words), std::string::npos) << refusal(laws);
  }
  laws.translation = Coupling::spherical;
  laws.elements[component::kY] = {};
  laws.elements[component::kZ] = {spring(1.0)};
  EXPECT_NE(refusal(laws).find("y: "), std::string::npos) << refusal(laws);
}

}  // namespace
}  // namespace rubber_suspension
