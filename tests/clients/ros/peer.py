"""Another ROS 1 node, as a robot has: it listens, and does what lines of JSON tell it."""

import json
import sys
import threading

import rospy
from cair_ros.msg import Action, Reply
from cair_ros.srv import Say, Start
from std_msgs.msg import Empty, String
from std_srvs.srv import Trigger

_LOCK = threading.Lock()


def tell(kind, **fields):
    """Write a line: what came by a topic, or the answer of a service."""
    with _LOCK:
        sys.stdout.write(json.dumps(dict(fields, kind=kind)) + "\n")
        sys.stdout.flush()


def plain_action(action):
    """Return an Action as JSON has it."""
    return [action.name, dict(zip(action.keys, action.values, strict=True))]


def plain_reply(reply):
    """Return a Reply as JSON has it."""
    plain = {name: getattr(reply, name) for name in reply.__slots__}
    return dict(plain, actions=[plain_action(one) for one in reply.actions])


def call(name, kind, *arguments):
    """Call a service of the node."""
    rospy.wait_for_service("/cair/" + name, 20)
    return rospy.ServiceProxy("/cair/" + name, kind)(*arguments)


def main():
    """Listen, and read commands until there are no more."""
    rospy.init_node("peer", disable_signals=True)
    heard = rospy.Publisher("/cair/heard", String, queue_size=10)
    done = rospy.Publisher("/cair/done", Empty, queue_size=10)
    rospy.Subscriber("/cair/reply", Reply, lambda reply: tell("reply", **plain_reply(reply)))
    rospy.Subscriber("/cair/speech", String, lambda speech: tell("speech", text=speech.data))
    rospy.Subscriber("/cair/plan", Action, lambda action: tell("plan", action=plain_action(action)))
    commands = {
        "hear": lambda text: heard.publish(String(text)),
        "done": lambda: done.publish(Empty()),
        "say": lambda *these: tell("said", **plain_reply(call("say", Say, *these).reply)),
        "start": lambda *these: tell("started", **plain_reply(call("start", Start, *these).reply)),
        "stop": lambda: tell("stopped", success=call("stop", Trigger).success),
        "connected": lambda: tell("connected", yes=heard.get_num_connections() > 0),
    }
    for line in sys.stdin:
        name, *arguments = json.loads(line)
        commands[name](*arguments)


main()
