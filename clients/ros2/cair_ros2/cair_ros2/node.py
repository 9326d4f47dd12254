"""The node: parameters, topics and services around a Talk."""

import os
import sys

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Empty, String
from std_srvs.srv import Trigger

from cair_interfaces.msg import Action, Reply
from cair_interfaces.srv import Say, Start
from cair_ros2.cair_client import CairError, Conversation
from cair_ros2.talk import Talk

#: What may be set, with the types of ROS 2: a whole number is no double there.
PARAMETERS = {
    "server": "",
    "language": "",
    "culture": "",
    "state_file": "~/.ros/{name}_talk.json",
    "key": "",
    "person": "",
    "gender": "",
    "capabilities": "",
    "greet": True,
    "step_seconds": 0.0,
    "timeout": 10.0,
    "patience": 10.0,
    "ca_file": "",
    "seed": 0,
}


class CairNode(Node):
    """A talk as topics and services below the node's name."""

    def __init__(self):
        super().__init__("cair")
        set_to = {name: self._parameter(name) for name in PARAMETERS}
        self._reply = self.create_publisher(Reply, "~/reply", 10)
        self._speech = self.create_publisher(String, "~/speech", 50)
        self._plan = self.create_publisher(Action, "~/plan", 50)
        talk = conversation(set_to, self.get_name())
        self.talk = Talk(talk, self, self.get_logger(), set_to["step_seconds"])
        # A service waits for the server; meanwhile sentences and done must come in.
        side_by_side = {"callback_group": ReentrantCallbackGroup()}
        self.create_service(Say, "~/say", self._on_say, **side_by_side)
        self.create_service(Start, "~/start", self._on_start, **side_by_side)
        self.create_service(Trigger, "~/stop", self._on_stop, **side_by_side)
        self.create_subscription(Empty, "~/done", self._on_done, 10, **side_by_side)
        self.create_subscription(String, "~/heard", self._on_heard, 10, **side_by_side)
        if set_to["greet"]:
            self.talk.begin(self._somebody_listens)

    def reply(self, heard, reply):
        """Publish a whole reply."""
        self._reply.publish(reply_message(heard, reply))

    def failure(self, heard, error):
        """Publish that there is no answer."""
        self._reply.publish(error_message(heard, error))

    def speech(self, text):
        """Publish a sentence to be spoken."""
        self._speech.publish(String(data=text))

    def action(self, action):
        """Publish an action to be done."""
        self._plan.publish(action_message(action))

    def _parameter(self, name):
        self.declare_parameter(name, PARAMETERS[name])
        return self.get_parameter(name).value

    def _somebody_listens(self):
        return self._speech.get_subscription_count() or self._reply.get_subscription_count()

    def _on_heard(self, message):
        self.talk.hear(message.data)

    def _on_done(self, _):
        self.talk.done()

    def _on_say(self, request, response):
        wanted = request.sentence, request.quiet
        response.reply = self._answered(request.sentence, lambda: self.talk.say(*wanted))
        return response

    def _on_start(self, request, response):
        wanted = request.afresh, request.language, request.culture, request.person
        response.reply = self._answered("", lambda: self.talk.start(*wanted))
        return response

    def _on_stop(self, _, response):
        self.talk.stop()
        response.success = True
        return response

    def _answered(self, heard, call):
        try:
            return reply_message(heard, call())
        except CairError as error:
            self.get_logger().warning(str(error))
            return error_message(heard, error)


def conversation(set_to, name):
    """Return the talk that the parameters ask for. Raises CairError."""
    capabilities = [one.strip() for one in set_to["capabilities"].split(",") if one.strip()]
    return Conversation(
        set_to["server"] or os.environ.get("CAIR_SERVER", "http://127.0.0.1:8000"),
        language=set_to["language"] or None,
        culture=set_to["culture"] or None,
        state_file=set_to["state_file"].replace("{name}", name) or None,
        person=set_to["person"] or None,
        gender=set_to["gender"] or None,
        key=set_to["key"] or os.environ.get("CAIR_KEY"),
        capabilities=capabilities or None,
        seed=set_to["seed"] or None,
        timeout=set_to["timeout"],
        patience=set_to["patience"],
        ca_file=set_to["ca_file"] or None,
    )


def action_message(action):
    """Return the message of an Action."""
    pairs = list(action.parameters.items())
    keys, values = [key for key, _ in pairs], [value or "" for _, value in pairs]
    return Action(name=action.name, keys=keys, values=values)


def reply_message(heard, reply):
    """Return the message of a Reply."""
    return Reply(
        heard=heard,
        plan_sentence=reply.plan_sentence,
        actions=[action_message(action) for action in reply.actions],
        dialogue_sentence=reply.dialogue_sentence,
        plan=reply.plan,
        topic=reply.topic,
        sentence_type=reply.sentence_type,
        restarted=reply.restarted,
    )


def error_message(heard, error):
    """Return the message of a CairError."""
    told = " ".join(part for part in (error.message, error.hint) if part)
    return Reply(heard=heard, error=error.code, error_message=told)


def main():
    """Run the node until ROS ends."""
    rclpy.init()
    try:
        node = CairNode()
    except CairError as error:
        sys.exit(str(error))
    try:
        rclpy.spin(node, MultiThreadedExecutor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.talk.end()
        node.destroy_node()
        rclpy.try_shutdown()
