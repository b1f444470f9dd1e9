// Whether an XML-RPC body is one that XmlRpcpp reads in a time that grows with its length; knows no ROS.
#pragma once

#include <cstddef>
#include <string>

namespace rubber_suspension::roscpp_fixes {

constexpr int kDeepestValue = 64;                         ///< values within values
constexpr std::size_t kLongestRequest = 1U << 20U;        ///< bytes of a call to a slave API
constexpr std::size_t kLongestReply = 16U * (1U << 20U);  ///< bytes of an answer: the parameters of a robot are fewer

/// Why a body must not reach XmlRpcpp's parser, which recurses for each value within a value, copies what lies within
/// as often as it lies deep, and begins again where something is missing. Empty where the body may: it is no longer
/// than `longest` [bytes], its values lie no deeper than kDeepestValue, their depths add up to no more than `longest` /
/// 4, and each is complete. Takes time in proportion to the length.
std::string requestRefusal(const std::string& body, std::size_t longest = kLongestRequest);
std::string replyRefusal(const std::string& body, std::size_t longest = kLongestReply);

}  // namespace rubber_suspension::roscpp_fixes
