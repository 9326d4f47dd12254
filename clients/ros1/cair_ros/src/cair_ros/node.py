"""The node: parameters, topics and services around a Talk."""

from __future__ import absolute_import

import logging
import os
import sys

import rospkg
import rospy
from std_msgs.msg import Empty, String
from std_srvs.srv import Trigger, TriggerResponse

from cair_ros.cair_client import CairError, Conversation
from cair_ros.msg import Action, Reply
from cair_ros.srv import Say, SayResponse, Start, StartResponse
from cair_ros.talk import Talk


class CairNode(object):
    """A talk as topics and services below the node's name."""

    def __init__(self):
        self._reply = rospy.Publisher("~reply", Reply, queue_size=10)
        self._speech = rospy.Publisher("~speech", String, queue_size=50)
        self._plan = rospy.Publisher("~plan", Action, queue_size=50)
        log = logging.getLogger("rosout.cair")
        self._talk = Talk(conversation(), self, log, _number("step_seconds", 0))
        rospy.on_shutdown(self._talk.end)
        rospy.Service("~say", Say, self._on_say)
        rospy.Service("~start", Start, self._on_start)
        rospy.Service("~stop", Trigger, self._on_stop)
        rospy.Subscriber("~done", Empty, lambda _: self._talk.done(), queue_size=10)
        rospy.Subscriber("~heard", String, lambda heard: self._talk.hear(heard.data), queue_size=10)
        if rospy.get_param("~greet", True):
            self._talk.begin(self._somebody_listens)

    def reply(self, heard, reply):
        """Publish a whole reply."""
        self._reply.publish(reply_message(heard, reply))

    def failure(self, heard, error):
        """Publish that there is no answer."""
        self._reply.publish(error_message(heard, error))

    def speech(self, text):
        """Publish a sentence to be spoken."""
        self._speech.publish(String(text))

    def action(self, action):
        """Publish an action to be done."""
        self._plan.publish(action_message(action))

    def _somebody_listens(self):
        return self._speech.get_num_connections() or self._reply.get_num_connections()

    def _on_say(self, request):
        return SayResponse(_answered(request.sentence, lambda: self._say(request)))

    def _say(self, request):
        return self._talk.say(request.sentence, request.quiet)

    def _on_start(self, request):
        wanted = request.afresh, request.language, request.culture, request.person
        return StartResponse(_answered("", lambda: self._talk.start(*wanted)))

    def _on_stop(self, _):
        self._talk.stop()
        return TriggerResponse(True, "")


def conversation():
    """Return the talk that the parameters ask for. Raises CairError."""
    home = rospkg.get_ros_home()
    name = rospy.get_name().strip("/").replace("/", "_")
    kept = rospy.get_param("~state_file", os.path.join(home, name + "_talk.json"))
    return Conversation(
        _text("server") or os.environ.get("CAIR_SERVER", "http://127.0.0.1:8000"),
        language=_text("language") or None,
        culture=_text("culture") or None,
        state_file=kept or None,
        person=_text("person") or None,
        gender=_text("gender") or None,
        key=_text("key") or os.environ.get("CAIR_KEY"),
        capabilities=_names("capabilities"),
        seed=int(_number("seed", 0)) or None,
        timeout=_number("timeout", 10),
        patience=_number("patience", 10),
        ca_file=_text("ca_file") or None,
    )


def action_message(action):
    """Return the message of an Action."""
    pairs = list(action.parameters.items())
    return Action(action.name, [key for key, _ in pairs], [value or "" for _, value in pairs])


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
    rospy.init_node("cair_node")
    try:
        CairNode()
    except (CairError, ValueError) as error:
        rospy.logfatal("%r", error)
        sys.exit(1)
    rospy.spin()


def _answered(heard, call):
    try:
        return reply_message(heard, call())
    except CairError as error:
        rospy.logwarn("%s: %s", error.code, error.message)
        return error_message(heard, error)


def _text(name):
    value = rospy.get_param("~" + name, "")
    return value if isinstance(value, type("")) else str(value)


def _number(name, default):
    return float(rospy.get_param("~" + name, default))


def _names(name):
    """Return a list of names, which may be given as "hug,playsong"; None where it is empty."""
    value = rospy.get_param("~" + name, "")
    names = value if isinstance(value, list) else str(value).split(",")
    return [str(one).strip() for one in names if str(one).strip()] or None
