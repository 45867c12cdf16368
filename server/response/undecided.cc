#include "server/response/undecided.h"

namespace dualarm {

wire::Undecided undecided_message(const Undecided& undecided) {
  wire::Undecided message;
  message.set_explanation(undecided.explanation);
  for (const std::string& line : undecided.tried) message.add_tried(line);
  message.set_spent_s(undecided.seconds_spent);
  message.set_lower_bound_s(undecided.best_lower_bound);
  return message;
}

}  // namespace dualarm
