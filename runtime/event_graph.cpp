// At one time events run through the graph as far as they go: along routes at once, through nodes in the package's order, so
// that a node sees all that arrives before it sends. A slot sends at most once at a time (X3D 4.1, 4.4.8.3), so routes in a
// circle come to rest.
//
// Between two frames clocks may start and stop, and start others. Each such moment is run at its own time, by the clocks
// alone whose moment it is.

#include "runtime/event_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace plugc {
namespace {

/// Moments between two frames; what would happen in more of them (a cycle of microseconds, say) happens at the frame's time.
constexpr int kMaxMoments = 10000;

flatbuffers::uoffset_t node_count(const PackedScene& scene) {
  return scene.event_nodes() == nullptr ? 0 : scene.event_nodes()->size();
}

/// Everything that happens at one time.
class Cascade {
 public:
  Cascade(EventGraph& graph, const PackedScene& scene, Slots& slots, double time)
      : graph_(graph), scene_(scene), slots_(slots), time_(time) {}

  void wake_node(std::uint32_t node) { pending_.try_emplace(node); }

  /// The slot has its value; whoever listens will hear of it.
  void send(std::uint32_t slot) {
    std::vector<std::uint32_t> work{slot};
    while (!work.empty()) {
      const std::uint32_t from = work.back();
      work.pop_back();
      if (!sent_.insert(from).second) continue;
      hear(from);
      for (const std::uint32_t to : receivers(from)) {
        slots_.set(to, std::vector<double>(slots_.values(from).begin(), slots_.values(from).end()));
        hear(to);
        work.push_back(to);
      }
    }
  }

  void send_all(const PackedEventNode& node, const std::vector<SentEvent>& events) {
    for (const SentEvent& event : events) {
      const std::uint32_t slot = node.outputs()->Get(static_cast<flatbuffers::uoffset_t>(event.output));
      if (slot == kNoSlot || sent_.contains(slot)) continue;
      if (slots_.set(slot, event.value)) send(slot);
    }
  }

  void run() {
    while (!pending_.empty()) {
      const auto woken = pending_.extract(pending_.begin());
      const PackedEventNode& node = *scene_.event_nodes()->Get(woken.key());
      send_all(node, wake({node, slots_, woken.mapped(), time_}, graph_.memory[woken.key()], graph_.script_work_left));
    }
  }

 private:
  void hear(std::uint32_t slot) {
    if (!arrived_.insert(slot).second) return;
    const auto first = std::ranges::lower_bound(graph_.listeners, std::pair{slot, 0U});
    for (auto one = first; one != graph_.listeners.end() && one->first == slot; ++one) pending_[one->second].push_back(slot);
  }

  std::vector<std::uint32_t> receivers(std::uint32_t from) const {
    std::vector<std::uint32_t> found;
    if (scene_.routes() == nullptr) return found;
    const auto before = [&](const PackedRoute* route, std::uint32_t slot) { return route->from() < slot; };
    auto route = std::lower_bound(scene_.routes()->begin(), scene_.routes()->end(), from, before);
    for (; route != scene_.routes()->end() && (*route)->from() == from; ++route) found.push_back((*route)->to());
    return found;
  }

  EventGraph& graph_;
  const PackedScene& scene_;
  Slots& slots_;
  double time_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> pending_;  // nodes, by their place in the order: what has reached them
  std::set<std::uint32_t> sent_, arrived_;                       // slots
};

/// The time sensors, each with its inputs.
template <typename Function>
void each_clock(const EventGraph& graph, const PackedScene& scene, const Slots& slots, Function function) {
  for (const std::uint32_t clock : graph.clocks)
    function(clock, EventNodeInputs{*scene.event_nodes()->Get(clock), slots, {}, graph.time});
}

double moment_of(const EventGraph& graph, std::uint32_t index, const EventNodeInputs& inputs) {
  const bool cycles_count = inputs.node.outputs()->Get(5) != kNoSlot;
  return next_moment(time_sensor_fields(inputs), graph.memory[index].clock, graph.time, cycles_count);
}

/// Runs the next moment before `end`; false when there is none.
bool run_moment(EventGraph& graph, const PackedScene& scene, Slots& slots, double end) {
  double next = std::numeric_limits<double>::infinity();
  std::vector<std::uint32_t> clocks;
  each_clock(graph, scene, slots, [&](std::uint32_t index, const EventNodeInputs& inputs) {
    const double moment = moment_of(graph, index, inputs);
    if (moment < next) clocks.clear();
    next = std::min(next, moment);
    if (moment == next) clocks.push_back(index);
  });
  if (!(next < end)) return false;
  Cascade cascade(graph, scene, slots, next);
  for (const std::uint32_t index : clocks) cascade.wake_node(index);
  cascade.run();
  graph.time = next;
  return true;
}

/// What is bound when the scene is loaded, and code that begins by itself then.
void wake_at_start(Cascade& cascade, const PackedScene& scene) {
  for (flatbuffers::uoffset_t i = 0; i < node_count(scene); ++i) {
    const PackedEventKind kind = scene.event_nodes()->Get(i)->kind();
    if (kind == PackedEventKind::bind_stack || kind == PackedEventKind::script) cascade.wake_node(i);
  }
}

/// All clocks, and what came from outside.
void run_frame(EventGraph& graph, const PackedScene& scene, Slots& slots, double time) {
  Cascade cascade(graph, scene, slots, time);
  if (graph.time < 0) wake_at_start(cascade, scene);
  const auto wake_clock = [&](std::uint32_t index, const EventNodeInputs&) { cascade.wake_node(index); };
  if (graph.ticking) each_clock(graph, scene, slots, wake_clock);
  for (const std::uint32_t slot : std::exchange(graph.unheard, {})) cascade.send(slot);
  cascade.run();
  graph.time = time;
}

void start_anew(EventGraph& graph, const PackedScene& scene, Slots& slots) {
  slots.restore(scene);
  std::map<std::uint32_t, std::vector<double>> written = std::move(graph.from_outside);
  graph = make_event_graph(scene);
  for (const auto& [slot, values] : written) send_from_outside(graph, slots, slot, values);
}

}  // namespace

EventGraph make_event_graph(const PackedScene& scene) {
  EventGraph graph;
  graph.memory.resize(node_count(scene));
  for (flatbuffers::uoffset_t i = 0; i < node_count(scene); ++i) {
    const PackedEventNode& node = *scene.event_nodes()->Get(i);
    if (node.kind() == PackedEventKind::time_sensor) graph.clocks.push_back(i);
    if (node.kind() == PackedEventKind::script) graph.memory[i].script_fields = find_script_fields(node);
    for (flatbuffers::uoffset_t input = 0; input < node.inputs()->size(); ++input) {
      const std::uint32_t slot = node.inputs()->Get(input);
      if (slot != kNoSlot && wakes(node, graph.memory[i], input)) graph.listeners.emplace_back(slot, i);
    }
  }
  std::ranges::sort(graph.listeners);
  return graph;
}

bool send_from_outside(EventGraph& graph, Slots& slots, std::uint32_t slot, const std::vector<double>& values) {
  if (!slots.set(slot, values)) return false;
  graph.from_outside[slot] = values;
  if (std::ranges::find(graph.unheard, slot) == graph.unheard.end()) graph.unheard.push_back(slot);
  return true;
}

void advance_events(EventGraph& graph, const PackedScene& scene, Slots& slots, double time) {
  const double end = std::isfinite(time) ? std::max(time, 0.0) : 0.0;
  graph.script_work_left = kMaxFrameScriptWork;
  if (end < graph.time) start_anew(graph, scene, slots);
  if (graph.time < 0) run_frame(graph, scene, slots, 0);
  if (end > 0 && !std::exchange(graph.ticking, true)) run_frame(graph, scene, slots, 0);
  for (int moments = 0; moments < kMaxMoments && run_moment(graph, scene, slots, end);) ++moments;
  if (end > graph.time || !graph.unheard.empty()) run_frame(graph, scene, slots, end);
}

void send_events(EventGraph& graph, const PackedScene& scene, Slots& slots, const std::vector<NodeEvents>& events) {
  if (events.empty()) return;
  Cascade cascade(graph, scene, slots, graph.time);
  for (const NodeEvents& one : events) cascade.send_all(*scene.event_nodes()->Get(one.node), one.sent);
  cascade.run();
}

}  // namespace plugc
