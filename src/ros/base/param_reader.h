// Private parameters, checked: type, range, and names that nobody reads.
#pragma once

#include <ros/node_handle.h>

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace ping_pong_sim
{
/// Bad parameter: what() is one line "parameter NAME: VALUE: expected ...".
class ParamError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class ParamReader
{
public:
  explicit ParamReader(const ros::NodeHandle& private_nh) : nh_(private_nh) {}

  /// @param valid     says whether a number is acceptable; not-a-number never is
  /// @param expected  what to say when it is not
  double number(const std::string& name, double fallback, bool (*valid)(double), const std::string& expected);
  bool flag(const std::string& name, bool fallback);
  std::string text(const std::string& name, const std::string& fallback);
  using Rows = std::map<std::string, std::vector<double>>;
  /// A dictionary of lists of `length` finite numbers.
  Rows rows(const std::string& name, const Rows& fallback, std::size_t length, const std::string& expected);

  /// Private parameters that are set but were not asked for.
  std::vector<std::string> unread() const;

private:
  bool get(const std::string& name, XmlRpc::XmlRpcValue& value);
  [[noreturn]] void fail(const std::string& name, XmlRpc::XmlRpcValue value, const std::string& expected) const;

  ros::NodeHandle nh_;
  std::set<std::string> known_;
};
}  // namespace ping_pong_sim
