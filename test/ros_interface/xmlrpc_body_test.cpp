// Bodies of XML-RPC: what peers send in earnest is let through, what would cost XmlRpcpp its stack or its time is not.
#include "roscpp_fixes/xmlrpc_body.h"

#include <gmock/gmock.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <random>

namespace rubber_suspension::roscpp_fixes {
namespace {

using ::testing::HasSubstr;

std::string call(const std::string& value, const std::string& method = "getPid") {
  return "<?xml version='1.0'?>\n<methodCall>\n<methodName>" + method + "</methodName>\n<params>\n<param>\n" + value +
         "</param>\n</params>\n</methodCall>\n";
}

std::string reply(const std::string& value) {
  return "<?xml version='1.0'?><methodResponse><params><param>" + value + "</param></params></methodResponse>";
}

std::string nested(int depth, const std::string& inner = "") {
  std::string begin;
  std::string end;
  for (int i = 0; i < depth; ++i) {
    begin += "<value><array><data>";
    end += "</data></array></value>";
  }
  return begin + inner + end;
}

TEST(XmlRpcBody, OfPythonAndRoscppIsLetThrough) {
  XmlRpc::XmlRpcValue value;
  value[0] = "/node";
  value[1]["a"] = 1.5;
  value[1]["b"][0] = true;
  value[1]["b"][1] = -3;
  value[1]["empty"] = std::string();
  const std::string python =
      "<value><array><data>\n<value><int>1</int></value>\n<value><string></string></value>\n<value><struct>\n<member>\n"
      "<name>when</name>\n<value><dateTime.iso8601>20261127T10:00:00</dateTime.iso8601></value>\n</member>\n"
      "</struct></value>\n<value><base64>\nAAEC\n</base64></value>\n<value><boolean>1</boolean></value>\n"
      "<value><double>1e-3</double></value>\n<value> plain &lt;text&gt; </value>\n</data></array></value>\n";
  for (const std::string& each : {value.toXml(), python, std::string("<value></value>"), nested(kDeepestValue)}) {
    EXPECT_EQ(requestRefusal(call(each)), "") << each;
    EXPECT_EQ(replyRefusal(reply(each)), "") << each;
  }
  EXPECT_EQ(requestRefusal("<methodCall><methodName>getPid</methodName></methodCall>"), "");
  EXPECT_EQ(requestRefusal(""), "") << "XmlRpcpp finds nothing there to read";
}

TEST(XmlRpcBody, BeyondItsBoundsIsRefused) {
  EXPECT_THAT(requestRefusal(call(nested(kDeepestValue + 1))), HasSubstr("at most 64 deep"));
  EXPECT_THAT(replyRefusal(reply(nested(55000))), HasSubstr("at most 64 deep"));
  EXPECT_THAT(requestRefusal(call(std::string(kLongestRequest, ' '))), HasSubstr("accepted: at most 1048576"));
  EXPECT_THAT(replyRefusal(std::string(kLongestReply + 1, ' ')), HasSubstr("accepted: at most 16777216"));
  std::string wide;
  for (int i = 0; i < 3000; ++i) {
    wide += "<value></value>";
  }
  EXPECT_THAT(requestRefusal(call(nested(60, wide))), HasSubstr("depths add up to more than 131072"));
  EXPECT_EQ(requestRefusal(call(nested(1, wide))), "");
  EXPECT_THAT(requestRefusal(call(nested(1, "<value>system.multicall</value>"), "system.multicall")),
              HasSubstr("more than once"));
}

// XmlRpcpp would begin again where a part is missing.
TEST(XmlRpcBody, WithAPartMissingIsRefused) {
  for (const char* value :
       {"<value><i4>1", "<value><i4>1</i4>", "<value><i4>x</i4></value>", "<value><boolean>2</boolean></value>",
        "<value><double>x</double></value>", "<value><array><value></value></array></value>",
        "<value><struct><member><value></value></member></struct></value>",
        "<value><struct><member><name>a</name></member></struct></value>", "<value><nil/></value>",
        "<value>a<b></value>", "<value><dateTime.iso8601>now</dateTime.iso8601></value>", "no value"}) {
    EXPECT_NE(requestRefusal(call(value)), "") << value;
    EXPECT_NE(replyRefusal(reply(value)), "") << value;
  }
  // Where XmlRpcpp looks for the method's end is where it goes on.
  EXPECT_NE(requestRefusal("<methodName>a<params><param></methodName><params><param>" + nested(65)), "");
}

// Whatever is cut or changed, what is let through XmlRpcpp reads as a value, and the check itself ends.
TEST(XmlRpcBody, LetThroughIsRead) {
  XmlRpc::XmlRpcValue value;
  value[0] = "/node";
  value[1]["a"][0] = 1.5;
  value[1]["b"] = true;
  const std::string whole = reply(value.toXml());
  std::mt19937 random(3);
  int through = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string text = whole;
    text[random() % text.size()] = "<>/&1a\0 "[random() % 8];
    if (replyRefusal(text).empty() && text.find("<params><param>") != std::string::npos &&
        text.find("<methodResponse>") != std::string::npos) {
      int offset = static_cast<int>(text.find("<value>"));
      XmlRpc::XmlRpcValue read;
      EXPECT_TRUE(read.fromXml(text, &offset)) << text;
      ++through;
    }
  }
  EXPECT_GT(through, 100);
}

}  // namespace
}  // namespace rubber_suspension::roscpp_fixes
