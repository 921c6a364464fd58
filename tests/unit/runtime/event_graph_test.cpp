#include "runtime/event_graph.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>
#include <map>
#include <random>

#include "test_scene.h"

namespace plugc::test {
namespace {

/// A scene of events alone.
class EventScene : public SceneBuilder {
 public:
  void node(PackedEventKind kind, std::vector<std::uint32_t> inputs, std::vector<std::uint32_t> outputs) {
    auto added = std::make_unique<PackedEventNodeT>();
    added->kind = kind;
    added->inputs = std::move(inputs);
    added->outputs = std::move(outputs);
    scene().event_nodes.push_back(std::move(added));
  }

  void route(std::uint32_t from, std::uint32_t to) {
    const auto ends = [](const PackedRoute& route) { return std::pair(route.from(), route.to()); };
    auto& routes = scene().routes;
    const auto place = std::ranges::lower_bound(routes, std::pair(from, to), {}, ends);
    if (place == routes.end() || ends(*place) != std::pair(from, to)) routes.insert(place, PackedRoute(from, to));
  }

  PackedScriptT& script(std::vector<std::uint32_t> inputs, std::vector<std::uint32_t> outputs) {
    node(PackedEventKind::script, std::move(inputs), std::move(outputs));
    PackedEventNodeT& added = *scene().event_nodes.back();
    added.script = std::make_unique<PackedScriptT>();
    added.script->origin = std::make_unique<PackedLineOrigin>(0, 1);
    package.sources = {"scene.x3dv"};
    return *added.script;
  }

  /// A TimeSensor: its slots that are no default, by name.
  struct Clock {
    std::uint32_t enabled = kNoSlot, loop = kNoSlot, interval = kNoSlot, start = kNoSlot, stop = kNoSlot;
    std::uint32_t active = kNoSlot, fraction = kNoSlot, elapsed = kNoSlot, time = kNoSlot, cycle = kNoSlot;
  };
  void clock(const Clock& c) {
    node(PackedEventKind::time_sensor, {c.enabled, c.loop, c.interval, c.start, c.stop, kNoSlot, kNoSlot},
         {c.active, kNoSlot, c.fraction, c.elapsed, c.time, c.cycle});
  }

  /// Everything up to these times, one after the other.
  void play(const std::vector<double>& times) {
    loaded_ = std::make_unique<LoadedPackage>(pack());
    packed_ = loaded_->package->scenes()->Get(0);
    slots_ = Slots(*packed_);
    graph_ = make_event_graph(*packed_);
    play_on(times);
  }
  void play_on(const std::vector<double>& times) {
    for (const double time : times) advance_events(graph_, *packed_, slots_, time);
  }
  void send(std::uint32_t slot, const std::vector<double>& values) {
    EXPECT_TRUE(send_from_outside(graph_, slots_, slot, values));
  }

  double value(std::uint32_t slot) const { return slots_.number(slot, std::nan("")); }
  const EventGraph& graph() const { return graph_; }

 private:
  std::unique_ptr<LoadedPackage> loaded_;
  const PackedScene* packed_ = nullptr;
  Slots slots_;
  EventGraph graph_;
};

/// A clock of a second that loops, an interpolator from 0 to 10, and where its value arrives.
struct Slide {
  EventScene scene;
  std::uint32_t arrived;

  Slide() {
    const std::uint32_t sent = scene.number(0), fraction = scene.number(0), value = scene.number(0);
    arrived = scene.number(7);
    scene.clock({.loop = scene.number(1), .fraction = sent});
    scene.node(PackedEventKind::interpolate,
               {fraction, scene.slot(PackedValueType::float_, {0, 1}), scene.slot(PackedValueType::float_, {0, 10})}, {value});
    scene.route(sent, fraction);
    scene.route(value, arrived);
  }
};

TEST(EventGraph, CarriesTimeToWhatIsDrawn) {
  Slide slide;
  slide.scene.play({0});
  EXPECT_EQ(slide.scene.value(slide.arrived), 7) << "no clock ticks at the moment of loading";
  slide.scene.play_on({1e-9});
  EXPECT_NEAR(slide.scene.value(slide.arrived), 0, 1e-6);
  slide.scene.play_on({0.25});
  EXPECT_EQ(slide.scene.value(slide.arrived), 2.5);
  slide.scene.play_on({12.75});
  EXPECT_EQ(slide.scene.value(slide.arrived), 7.5);
}

TEST(EventGraph, GoesBackByStartingAnew) {
  Slide slide;
  slide.scene.play({0.75, 0.25});
  EXPECT_EQ(slide.scene.value(slide.arrived), 2.5);
}

TEST(EventGraph, TakesAnyNumberForATime) {
  Slide slide;
  slide.scene.play({-5});
  EXPECT_EQ(slide.scene.value(slide.arrived), 7);
  slide.scene.play({std::nan("")});
  EXPECT_EQ(slide.scene.value(slide.arrived), 7);
  slide.scene.play({1e300});
  EXPECT_GE(slide.scene.value(slide.arrived), 0);
}

/// One clock's end starts the next one's.
struct Chain {
  EventScene scene;
  std::uint32_t elapsed;

  Chain() {
    const std::uint32_t active = scene.number(0), ends = scene.number(0), ended = scene.number(0), begins = scene.number(0);
    const std::uint32_t time = scene.number(0), start = scene.number(0);
    elapsed = scene.number(-1);
    scene.clock({.interval = scene.number(0.3), .start = scene.number(1), .active = active});
    scene.node(PackedEventKind::boolean_filter, {ends}, {kNoSlot, ended, kNoSlot});
    scene.node(PackedEventKind::time_trigger, {begins}, {time});
    scene.clock({.interval = scene.number(5), .start = start, .elapsed = elapsed});
    scene.route(active, ends);
    scene.route(ended, begins);
    scene.route(time, start);
  }
};

TEST(EventGraph, ClocksStartOneAnotherAtTheirOwnTimesWhateverTheFrames) {
  for (const std::vector<double>& frames : {std::vector<double>{4}, {0, 1, 2, 3, 4}, {0.9, 1.25, 1.31, 4}}) {
    Chain chain;
    chain.scene.play(frames);
    EXPECT_NEAR(chain.scene.value(chain.elapsed), 2.7, 1e-9);
  }
}

TEST(EventGraph, RoutesInACircleComeToRest) {
  EventScene scene;
  const std::uint32_t time = scene.number(0), a = scene.number(0), b = scene.number(0), c = scene.number(0);
  scene.clock({.loop = scene.number(1), .time = time});
  scene.route(time, a);
  scene.route(a, b);
  scene.route(b, c);
  scene.route(c, a);
  scene.route(c, c);
  scene.play({3});
  EXPECT_EQ(scene.value(a), 3);
  EXPECT_EQ(scene.value(c), 3);
}

TEST(EventGraph, NodesInACircleSendOnceAtATime) {
  EventScene scene;
  const std::uint32_t active = scene.number(0), in = scene.number(0), toggle = scene.number(0), negated = scene.number(0);
  const std::uint32_t back = scene.number(0);
  scene.clock({.loop = scene.number(1), .active = active});
  scene.node(PackedEventKind::boolean_toggle, {in, toggle}, {toggle});
  scene.node(PackedEventKind::boolean_filter, {back}, {kNoSlot, kNoSlot, negated});
  scene.route(active, in);
  scene.route(toggle, back);
  scene.route(negated, in);  // FALSE: the toggle would not turn, but it may not be asked for ever either
  scene.play({0.5});
  EXPECT_EQ(scene.value(toggle), 1);
  EXPECT_EQ(scene.value(negated), 0);
}

TEST(EventGraph, AClockThatRestartsItselfDoesNotHang) {
  EventScene scene;
  const std::uint32_t active = scene.number(0), ends = scene.number(0), ended = scene.number(0), begins = scene.number(0);
  const std::uint32_t time = scene.number(0), start = scene.number(1), elapsed = scene.number(0);
  scene.clock({.interval = scene.number(1e-9), .start = start, .active = active, .elapsed = elapsed});
  scene.node(PackedEventKind::boolean_filter, {ends}, {kNoSlot, ended, kNoSlot});
  scene.node(PackedEventKind::time_trigger, {begins}, {time});
  scene.route(active, ends);
  scene.route(ended, begins);
  scene.route(time, start);
  scene.play({1e6});
  EXPECT_GE(scene.value(time), 1);
}

TEST(EventGraph, TogglesAndSequencesRemember) {
  EventScene scene;
  const std::uint32_t next = scene.number(0), value = scene.number(0), in = scene.number(0), toggle = scene.number(0);
  scene.node(PackedEventKind::sequence,
             {kNoSlot, next, kNoSlot, scene.slot(PackedValueType::float_, {0, 0.5}), scene.slot(PackedValueType::int_, {4, 9})},
             {value});
  scene.node(PackedEventKind::boolean_toggle, {in, toggle}, {toggle});
  scene.route(next, in);
  scene.play({0});
  const auto press = [&](double time) {
    scene.send(next, {1});
    scene.play_on({time});
    scene.send(next, {0});
    scene.play_on({time});
  };
  press(1);
  EXPECT_EQ(scene.value(value), 4);
  EXPECT_EQ(scene.value(toggle), 1);
  press(2);
  EXPECT_EQ(scene.value(value), 9);
  EXPECT_EQ(scene.value(toggle), 0);
  press(3);
  EXPECT_EQ(scene.value(value), 4);
}

TEST(EventGraph, ASequenceSendsOnceForEachKey) {
  EventScene scene;
  const std::uint32_t sent = scene.number(0), fraction = scene.number(0), value = scene.number(-1);
  const std::uint32_t in = scene.number(0), toggle = scene.number(0);
  scene.clock({.loop = scene.number(1), .fraction = sent});
  scene.node(
      PackedEventKind::sequence,
      {fraction, kNoSlot, kNoSlot, scene.slot(PackedValueType::float_, {0, 0.5}), scene.slot(PackedValueType::bool_, {1, 1})},
      {value});
  scene.node(PackedEventKind::boolean_toggle, {in, toggle}, {toggle});
  scene.route(sent, fraction);
  scene.route(value, in);
  scene.play({0, 0.1, 0.2});
  EXPECT_EQ(scene.value(toggle), 1);
  scene.play_on({0.6, 0.7});
  EXPECT_EQ(scene.value(toggle), 0);
}

TEST(EventGraph, TriggersSendWhatTheyStandFor) {
  EventScene scene;
  const std::uint32_t active = scene.number(0), in = scene.number(0), number = scene.number(0);
  const std::uint32_t time = scene.number(0), moment = scene.number(0), flag = scene.number(0);
  scene.clock({.start = scene.number(2), .active = active, .time = time});
  scene.node(PackedEventKind::integer_trigger, {in, scene.slot(PackedValueType::int_, {6})}, {number});
  scene.node(PackedEventKind::boolean_trigger, {moment}, {flag});
  scene.route(active, in);
  scene.route(time, moment);
  scene.play({1});
  EXPECT_EQ(scene.value(number), 0);
  scene.play_on({2});
  EXPECT_EQ(scene.value(number), 6);
  EXPECT_EQ(scene.value(flag), 1);
}

/// Adds 1 to what it sends at each event, and moves 999,000 numbers.
void add_slow_counter(EventScene& scene, std::uint32_t in, std::uint32_t out) {
  using Op = PackedScriptOp;
  PackedScriptT& script = scene.script({in, kNoSlot}, {kNoSlot, out});
  script.values.assign(999'002, 1.0);
  script.values[0] = 0;
  script.variables = {{0, 1, 1}, {1, 1, -1}, {2, 999'000, -1}};
  script.steps = {{0, 1, Op::load}, {1, 1, Op::load}, {0, 1, Op::add}, {0, 1, Op::store},
                  {0, 1, Op::drop}, {2, 2, Op::load}, {0, 2, Op::drop}};
  script.functions.emplace_back(0, kNoSlot, kNoSlot, 0, 7);
}

TEST(EventGraph, BoundsTheWorkOfScriptsBetweenTwoFrames) {
  EventScene scene;
  const std::uint32_t cycle = scene.number(0), slow = scene.number(0), sent = scene.number(0), quick = scene.number(0);
  scene.clock({.loop = scene.number(1), .interval = scene.number(1e-4), .cycle = cycle});
  add_slow_counter(scene, slow, sent);
  add_slow_counter(scene, quick, scene.number(0));
  scene.route(cycle, slow);
  scene.play({0, 0.5});
  EXPECT_EQ(scene.value(sent), 51) << "5000 events, but work for 50 of them; the last one is cut short";
  EXPECT_EQ(scene.graph().memory[1].script.message,
            "line 2: the script is stopped: the scripts of the scene do more between two frames than may be done");
  scene.play_on({0.6});
  EXPECT_EQ(scene.value(sent), 51);
  scene.send(quick, {1});
  scene.play_on({0.7});
  EXPECT_FALSE(scene.graph().memory[2].script.stopped) << "each frame has the whole work";
}

TEST(EventGraph, AScriptWithoutVariablesStartsOnce) {
  EventScene scene;
  const std::uint32_t in = scene.number(0);
  PackedScriptT& script = scene.script({in}, {kNoSlot});
  script.values = {0};  // an empty list need not be aligned
  script.steps = {{0, 1, PackedScriptOp::random}, {0, 1, PackedScriptOp::drop}};
  script.functions.emplace_back(-1, kNoSlot, kNoSlot, 0, 2);
  script.functions.emplace_back(0, kNoSlot, kNoSlot, 1, 1);
  scene.play({0});
  scene.send(in, {1});
  scene.play_on({1});
  EXPECT_EQ(scene.graph().script_work_left, kMaxFrameScriptWork) << "`initialize` does not run again";
}

double seconds_of_this_process() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Processor time of one event that reaches as many fields of a Script and nodes of a stack.
double seconds_of_one_event(std::uint32_t fields_count) {
  EventScene scene;
  const std::uint32_t active = scene.number(0), now = scene.number(-1);
  scene.clock({.loop = scene.number(1), .active = active});
  std::vector<std::uint32_t> fields, nodes;
  for (std::uint32_t i = 0; i < fields_count; ++i) fields.push_back(scene.number(0));
  for (std::uint32_t i = 0; i < fields_count; ++i) nodes.push_back(scene.number(0));
  PackedScriptT& script = scene.script(fields, std::vector<std::uint32_t>(fields_count, kNoSlot));
  script.values.assign(fields_count, 0.0);
  for (std::uint32_t i = 0; i < fields_count; ++i) script.variables.emplace_back(i, 1, static_cast<std::int32_t>(i));
  scene.node(PackedEventKind::bind_stack, nodes, std::vector<std::uint32_t>(1 + 2 * fields_count, kNoSlot));
  scene.scene().event_nodes.back()->outputs[0] = now;
  for (const std::uint32_t to : fields) scene.scene().routes.emplace_back(active, to);
  for (const std::uint32_t to : nodes) scene.scene().routes.emplace_back(active, to);
  const double begin = seconds_of_this_process();
  scene.play({0, 1});
  const double taken = seconds_of_this_process() - begin;
  EXPECT_EQ(scene.value(now), fields_count - 1);
  EXPECT_EQ(scene.graph().memory[1].script.variables.back(), ScriptValue{1});
  return taken;
}

TEST(EventGraph, ManyEventsAtOnceCostWhatHangsOnThem) {
  const double few = seconds_of_one_event(25'000), many = seconds_of_one_event(200'000);
  EXPECT_LT(many, 30 * few) << "eight times as many: 8 where each costs the same, 64 where each looks at all";
}

TEST(EventGraph, TheOrderOfNodesDecidesWhatIsBoundOnTop) {
  EventScene scene;
  const std::uint32_t now = scene.number(-1), a = scene.number(0), b = scene.number(0), c = scene.number(0);
  scene.node(PackedEventKind::bind_stack, {a, b, c}, {now, kNoSlot, kNoSlot, kNoSlot, kNoSlot, kNoSlot, kNoSlot});
  const auto bind = [&](double time, const std::vector<std::pair<std::uint32_t, double>>& events) {
    for (const auto& [slot, value] : events) scene.send(slot, {value});
    scene.play_on({time});
    return scene.value(now);
  };
  scene.play({0});
  EXPECT_EQ(bind(1, {{c, 1}, {a, 1}}), 2);
  EXPECT_EQ(bind(2, {{b, 1}, {a, 0}}), 1);
  EXPECT_EQ(bind(3, {{b, 0}}), 2);
  EXPECT_EQ(bind(4, {{c, 0}}), -1) << "a was taken out before";
}

TEST(Slots, TellsChangesOfWhatWasWatched) {
  EventScene scene;
  const std::uint32_t place = scene.number(1), color = scene.number(2);
  const LoadedPackage loaded = scene.pack();
  Slots slots(*loaded.package->scenes()->Get(0));
  slots.set_watching(true);
  EXPECT_EQ(slots.number(place, 0), 1);
  slots.set_watching(false);
  EXPECT_EQ(slots.number(color, 0), 2);
  const std::uint64_t before = slots.watched_revision();
  EXPECT_TRUE(slots.set(color, std::vector<double>{5}));
  EXPECT_EQ(slots.watched_revision(), before);
  EXPECT_TRUE(slots.set(place, std::vector<double>{1}));
  EXPECT_EQ(slots.watched_revision(), before);
  EXPECT_TRUE(slots.set(place, std::vector<double>{3}));
  EXPECT_GT(slots.watched_revision(), before);
}

TEST(EventGraph, KeepsWhatAHostHasWrittenWhenItStartsAnew) {
  Slide slide;
  EventScene& scene = slide.scene;
  const std::uint32_t free = scene.number(0), behind = scene.number(0);
  scene.route(free, behind);
  scene.play({2});
  scene.send(free, {5});
  scene.play_on({3, 1});
  EXPECT_EQ(scene.value(behind), 5);
  EXPECT_EQ(scene.value(slide.arrived), 10);
}

/// Nodes, routes and numbers by chance, as a package may have them that means harm.
class RandomGraph {
 public:
  explicit RandomGraph(unsigned seed) : random_(seed) {
    for (int i = 0; i < 24; ++i) {
      const std::size_t size = std::array<std::size_t, 4>{1, 1, 3, 4}[pick(4)];
      std::vector<double> values;
      for (std::size_t n = 0; n < size; ++n) values.push_back(number());
      by_size_[size].push_back(scene.slot(PackedValueType::float_, values));
    }
    for (const std::size_t size : {1, 3, 4})
      by_size_[size].push_back(scene.slot(PackedValueType::float_, std::vector<double>(size)));
    for (int i = 0; i < 12; ++i) add_node();
    for (int i = 0; i < 30; ++i) {
      const std::vector<std::uint32_t>& slots = by_size_[std::array<std::size_t, 3>{1, 3, 4}[pick(3)]];
      scene.route(slots[pick(slots.size())], slots[pick(slots.size())]);
    }
  }

  double number() {
    static const std::array<double, 10> odd = {
        0, 1, -1, 0.5, 1e-12, 1e300, std::nan(""), std::numeric_limits<double>::infinity(), 2, 3};
    return odd[pick(odd.size())];
  }

  EventScene scene;

 private:
  std::size_t pick(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  std::uint32_t any_slot(std::size_t size) {
    const std::vector<std::uint32_t>& slots = by_size_[size];
    return pick(5) == 0 ? kNoSlot : slots[pick(slots.size())];
  }
  void add_node() {
    struct Kind {
      PackedEventKind kind;
      std::size_t inputs, outputs, width;
    };
    static const std::array<Kind, 12> kinds = {{{PackedEventKind::time_sensor, 7, 6, 1},
                                                {PackedEventKind::time_sensor, 7, 6, 1},
                                                {PackedEventKind::interpolate, 3, 1, 3},
                                                {PackedEventKind::interpolate_color, 3, 1, 3},
                                                {PackedEventKind::interpolate_normal, 3, 1, 3},
                                                {PackedEventKind::interpolate_rotation, 3, 1, 4},
                                                {PackedEventKind::spline, 6, 1, 1},
                                                {PackedEventKind::squad, 3, 1, 4},
                                                {PackedEventKind::ease, 3, 1, 1},
                                                {PackedEventKind::sequence, 5, 1, 1},
                                                {PackedEventKind::boolean_toggle, 2, 1, 1},
                                                {PackedEventKind::time_trigger, 1, 1, 1}}};
    const Kind& kind = kinds[pick(kinds.size())];
    std::vector<std::uint32_t> inputs, outputs;
    for (std::size_t i = 0; i < kind.inputs; ++i) inputs.push_back(any_slot(std::array<std::size_t, 3>{1, 3, 4}[pick(3)]));
    for (std::size_t i = 0; i < kind.outputs; ++i) outputs.push_back(any_slot(kind.width));
    scene.node(kind.kind, std::move(inputs), std::move(outputs));
  }

  std::mt19937 random_;
  std::map<std::size_t, std::vector<std::uint32_t>> by_size_;
};

TEST(EventGraph, AnyGraphComesToRestAndGivesTheSameAgain) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const std::vector<double> times = {0, 0.25, 0.5, 3, 2, 1e9};
    RandomGraph first(seed), second(seed);
    first.scene.play(times);
    second.scene.play(times);
    for (std::uint32_t slot = 0; slot < first.scene.scene().slots.size(); ++slot) {
      const double a = first.scene.value(slot), b = second.scene.value(slot);
      EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << "seed " << seed << ", slot " << slot;
    }
  }
}

}  // namespace
}  // namespace plugc::test
