#include "param_reader.h"

#include <cmath>
#include <sstream>

namespace ping_pong_sim
{
double ParamReader::number(const std::string& name, double fallback, bool (*valid)(double), const std::string& expected)
{
  XmlRpc::XmlRpcValue value;
  if (!get(name, value)) return fallback;
  double number = std::nan("");
  if (value.getType() == XmlRpc::XmlRpcValue::TypeDouble) number = static_cast<double>(value);
  if (value.getType() == XmlRpc::XmlRpcValue::TypeInt) number = static_cast<int>(value);
  if (std::isnan(number) || !valid(number)) fail(name, value, expected);
  return number;
}

bool ParamReader::flag(const std::string& name, bool fallback)
{
  XmlRpc::XmlRpcValue value;
  if (!get(name, value)) return fallback;
  if (value.getType() != XmlRpc::XmlRpcValue::TypeBoolean) fail(name, value, "true or false");
  return static_cast<bool>(value);
}

std::string ParamReader::text(const std::string& name, const std::string& fallback)
{
  XmlRpc::XmlRpcValue value;
  if (!get(name, value)) return fallback;
  if (value.getType() != XmlRpc::XmlRpcValue::TypeString) fail(name, value, "a text");
  return static_cast<std::string>(value);
}

namespace
{
// Empty if it is no list of finite numbers.
std::vector<double> toNumbers(XmlRpc::XmlRpcValue value)
{
  std::vector<double> numbers;
  if (value.getType() != XmlRpc::XmlRpcValue::TypeArray) return {};
  for (int i = 0; i < value.size(); ++i)
  {
    if (value[i].getType() == XmlRpc::XmlRpcValue::TypeDouble)
      numbers.push_back(static_cast<double>(value[i]));
    else if (value[i].getType() == XmlRpc::XmlRpcValue::TypeInt)
      numbers.push_back(static_cast<int>(value[i]));
    else
      return {};
    if (!std::isfinite(numbers.back())) return {};
  }
  return numbers;
}
}  // namespace

ParamReader::Rows ParamReader::rows(const std::string& name, const Rows& fallback, std::size_t length,
                                    const std::string& expected)
{
  XmlRpc::XmlRpcValue value;
  if (!get(name, value)) return fallback;
  if (value.getType() != XmlRpc::XmlRpcValue::TypeStruct) fail(name, value, expected);
  Rows rows;
  for (auto& entry : value)
  {
    known_.insert(name + "/" + entry.first);
    const std::vector<double> numbers = toNumbers(entry.second);
    if (numbers.size() != length) fail(name + "/" + entry.first, entry.second, expected);
    rows[entry.first] = numbers;
  }
  return rows;
}

std::vector<std::string> ParamReader::unread() const
{
  std::vector<std::string> all;
  std::vector<std::string> unread;
  nh_.getParamNames(all);
  const std::string prefix = nh_.getNamespace() + "/";
  for (const std::string& name : all)
  {
    if (name.compare(0, prefix.size(), prefix) != 0) continue;
    if (known_.count(name.substr(prefix.size())) == 0) unread.push_back(name);
  }
  return unread;
}

bool ParamReader::get(const std::string& name, XmlRpc::XmlRpcValue& value)
{
  known_.insert(name);
  return nh_.getParam(name, value);
}

void ParamReader::fail(const std::string& name, XmlRpc::XmlRpcValue value, const std::string& expected) const
{
  std::ostringstream text;
  text << "parameter " << nh_.resolveName(name) << ": ";
  value.write(text);
  text << ": expected " << expected;
  throw ParamError(text.str());
}
}  // namespace ping_pong_sim
