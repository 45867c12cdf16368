#include "tests/fuzz/message_mutator.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace dualarm {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;
using Engine = std::mt19937_64;

constexpr double kChanceToDescend = 0.8;

std::size_t below(std::size_t count, Engine& engine) { return engine() % count; }
bool chance(double share, Engine& engine) { return std::uniform_real_distribution(0.0, 1.0)(engine) < share; }

double odd_number(double value, Engine& engine) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr std::array<double, 14> kOdd = {
      0.0,  -0.0, 1.0,    -1.0,  1e-12,  1e-6,      1e6,
      1e12, 1e-4, 3.1416, 1e308, 5e-324, kInfinity, std::numeric_limits<double>::quiet_NaN()};
  switch (below(5, engine)) {
    case 0:
      return kOdd[below(kOdd.size(), engine)];
    case 1:
      return -value;
    case 2:
      return value * std::pow(10.0, std::uniform_real_distribution(-3.0, 3.0)(engine));
    case 3:
      return std::nextafter(value, chance(0.5, engine) ? kInfinity : -kInfinity);
    default:
      return value + std::uniform_real_distribution(-0.1, 0.1)(engine) * (1.0 + std::abs(value));
  }
}

std::string odd_text(std::string text, Engine& engine) {
  switch (below(4, engine)) {
    case 0:
      return "";
    case 1:
      return text + text;
    case 2:
      return text + static_cast<char>(engine());
    default:
      return std::string(below(100, engine), 'x');
  }
}

// Any number: an enum's or a flag's too, which need not be one of its own.
std::int64_t odd_count(std::int64_t value, Engine& engine) {
  constexpr std::array<std::int64_t, 6> kOdd = {0, 1, -1, 2, 1000, std::numeric_limits<std::int64_t>::max()};
  return chance(0.5, engine) ? kOdd[below(kOdd.size(), engine)] : value + static_cast<std::int64_t>(engine() % 7) - 3;
}

void spoil_value(Message& message, const FieldDescriptor& field, Engine& engine) {
  const Reflection& reflection = *message.GetReflection();
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return reflection.SetDouble(&message, &field, odd_number(reflection.GetDouble(message, &field), engine));
    case FieldDescriptor::CPPTYPE_STRING:
      return reflection.SetString(&message, &field, odd_text(reflection.GetString(message, &field), engine));
    case FieldDescriptor::CPPTYPE_BOOL:
      return reflection.SetBool(&message, &field, !reflection.GetBool(message, &field));
    case FieldDescriptor::CPPTYPE_ENUM:
      return reflection.SetEnumValue(&message, &field, static_cast<int>(below(6, engine)));
    case FieldDescriptor::CPPTYPE_INT32:
      return reflection.SetInt32(&message, &field,
                                 static_cast<int>(odd_count(reflection.GetInt32(message, &field), engine)));
    case FieldDescriptor::CPPTYPE_INT64:
      return reflection.SetInt64(&message, &field, odd_count(reflection.GetInt64(message, &field), engine));
    case FieldDescriptor::CPPTYPE_UINT64:
      return reflection.SetUInt64(&message, &field, engine());
    case FieldDescriptor::CPPTYPE_MESSAGE:
      reflection.MutableMessage(&message, &field);
      return;
    default:
      return;
  }
}

void grow(Message& message, const FieldDescriptor& field, Engine& engine) {
  const Reflection& reflection = *message.GetReflection();
  const int count = reflection.FieldSize(message, &field);
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE: {
      const double last = count > 0 ? reflection.GetRepeatedDouble(message, &field, count - 1) : 0.0;
      return reflection.AddDouble(&message, &field, odd_number(last, engine));
    }
    case FieldDescriptor::CPPTYPE_ENUM:
      return reflection.AddEnumValue(&message, &field, static_cast<int>(below(6, engine)));
    case FieldDescriptor::CPPTYPE_MESSAGE: {
      Message* added = reflection.AddMessage(&message, &field);
      if (count > 0)
        added->CopyFrom(reflection.GetRepeatedMessage(message, &field, static_cast<int>(below(count, engine))));
      return;
    }
    default:
      return;
  }
}

void spoil_list(Message& message, const FieldDescriptor& field, Engine& engine) {
  const Reflection& reflection = *message.GetReflection();
  const auto count = static_cast<std::size_t>(reflection.FieldSize(message, &field));
  const std::size_t what = below(4, engine);
  if (count == 0 || what == 0) return grow(message, field, engine);
  if (what == 1) return reflection.RemoveLast(&message, &field);
  const int index = static_cast<int>(below(count, engine));
  if (what == 2 || field.cpp_type() != FieldDescriptor::CPPTYPE_DOUBLE) {
    return reflection.SwapElements(&message, &field, index, static_cast<int>(below(count, engine)));
  }
  reflection.SetRepeatedDouble(&message, &field, index,
                               odd_number(reflection.GetRepeatedDouble(message, &field, index), engine));
}

std::vector<Message*> parts_of(Message& message) {
  const Reflection& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  std::vector<Message*> parts;
  for (const FieldDescriptor* field : fields) {
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
    if (!field->is_repeated()) {
      parts.push_back(reflection.MutableMessage(&message, field));
      continue;
    }
    for (int i = 0; i < reflection.FieldSize(message, field); ++i) {
      parts.push_back(reflection.MutableRepeatedMessage(&message, field, i));
    }
  }
  return parts;
}

}  // namespace

void mutate(Message& message, Engine& engine) {
  const std::vector<Message*> parts = parts_of(message);
  if (!parts.empty() && chance(kChanceToDescend, engine)) return mutate(*parts[below(parts.size(), engine)], engine);
  const auto& type = *message.GetDescriptor();
  if (type.field_count() == 0) return;
  const FieldDescriptor& field = *type.field(static_cast<int>(below(type.field_count(), engine)));
  if (field.is_repeated()) return spoil_list(message, field, engine);
  const bool clears = message.GetReflection()->HasField(message, &field) && chance(0.15, engine);
  clears ? message.GetReflection()->ClearField(&message, &field) : spoil_value(message, field, engine);
}

}  // namespace dualarm
