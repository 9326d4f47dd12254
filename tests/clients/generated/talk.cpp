// A talk of three turns with the client that openapi-generator writes (cpp-restsdk).
#include "CppRestOpenAPIClient/api/HubApi.h"
#include <iostream>

using namespace org::openapitools::client;

int main(int count, char** arguments) {
  if (count != 2) return 2;
  auto settings = std::make_shared<api::ApiConfiguration>();
  settings->setBaseUrl(arguments[1]);
  api::HubApi hub(std::make_shared<api::ApiClient>(settings));
  auto turn = std::make_shared<model::Turn>();
  turn->setLanguage("en");
  turn->setCapabilities({"playsong"});
  for (const char* sentence : {"", "Play the song Hey Brother", "Play a song"}) {
    turn->setClientSentence(sentence);
    auto reply = hub.hubCreate(turn).get();
    turn->setDialogueState(reply->getDialogueState());
    std::cout << "plan: " << reply->getPlan() << "\n";
    for (const auto& step : reply->getPlanActions())
      std::cout << "does: " << step->getAction() << "\n";
    std::cout << "robot: " << reply->getDialogueSentence() << "\n";
  }
}
