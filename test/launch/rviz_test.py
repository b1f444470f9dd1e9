#!/usr/bin/python3
"""Shows a bush of six directions in rviz under Xvfb. The wrench is moved to the bush, and its arrows are visible.

Usage: rviz_test.py FOLDER_OF_THE_PACKAGE [PICTURE.png]. Skipped (77) without rviz, Xvfb or their Python modules.
"""
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(sys.argv[1]).resolve()
PICTURE = sys.argv[2] if len(sys.argv) > 2 else ""
sys.path.insert(0, str(ROOT / "test" / "wire"))
RVIZ = shutil.which("rviz")
try:
    import numpy as np
    import rospy
    import tcpros
    from geometry_msgs.msg import PoseStamped, WrenchStamped
    from tf2_msgs.msg import TFMessage
except ImportError:
    RVIZ = None

FORCE = np.array([300.0, 0.0, 150.0])  # on B at the origin of B, in the axes of A [N]
PLACE = np.array([1.1, 0.6, -0.5])     # position of the bush on both bodies, as in config/hung_body.yaml [m]
TURN = 0.05                            # rotation of B about z [rad]
ROTATION = np.array([[np.cos(TURN), -np.sin(TURN), 0], [np.sin(TURN), np.cos(TURN), 0], [0, 0, 1]])
MOMENT = np.cross(ROTATION @ PLACE, FORCE) + [0.0, 20.0, 0.0]  # [N m]; 20 N m of it at the bush


def until(condition, seconds=90):
    end = time.monotonic() + seconds
    while time.monotonic() < end and not condition():
        time.sleep(0.1)
    return condition()


def screen(path):
    """Return red, green and blue of the screen of Xvfb -fbdir, which is a file in xwd format."""
    data = path.read_bytes()
    head = struct.unpack(">25I", data[:100])
    size, width, height, line, colours = head[0], head[4], head[5], head[12], head[19]
    pixels = np.frombuffer(data, np.uint8, line * height, size + 12 * colours).reshape(height, line)[:, :4 * width]
    return pixels.reshape(height, width, 4)[:, :, 2::-1].astype(int)


class Rviz(unittest.TestCase):
    def start(self, *words, **variables):
        process = subprocess.Popen(list(map(str, words)), env={**os.environ, **variables}, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        self.addCleanup(lambda: (process.terminate(), process.wait(20)))
        return process

    def test_bush_is_seen_where_it_is(self):
        scratch = tempfile.TemporaryDirectory(prefix="rviz.")
        self.addCleanup(scratch.cleanup)
        folder = pathlib.Path(scratch.name)
        port = tcpros.free_port()
        os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1", ROS_HOME=str(folder),
                          HOME=str(folder))
        self.start("rosmaster", "--core", "-p", port)
        self.start("Xvfb", "-displayfd", "1", ":97", "-screen", "0", "1024x768x24", "-fbdir", folder)
        import rosgraph  # noqa: PLC0415: after the master is known
        self.assertTrue(until(rosgraph.is_master_online))
        rospy.init_node("rviz_test", disable_signals=True)
        show = (ROOT / "scripts" / "show_bush", "--config", ROOT / "config" / "hung_body.yaml", "--component", "front_left")
        self.start(*show, "--rviz", ROOT / "config" / "six_directions.rviz", DISPLAY=":97", LIBGL_ALWAYS_SOFTWARE="1",
                   XDG_RUNTIME_DIR=str(folder))
        pose = rospy.Publisher("front_left/pose", PoseStamped, queue_size=10)
        wrench = rospy.Publisher("front_left/wrench", WrenchStamped, queue_size=10)
        shown, frames = [], []
        rospy.Subscriber("front_left/wrench_at_bush", WrenchStamped, shown.append)
        rospy.Subscriber("/tf", TFMessage, frames.append)
        timer = rospy.Timer(rospy.Duration(0.1), lambda _: self.publish(pose, wrench))
        self.addCleanup(timer.shutdown)
        self.assertTrue(until(lambda: shown and frames))
        self.check_wrench(shown[-1])
        self.assertEqual({t.child_frame_id for t in frames[-1].transforms}, {"front_left/a", "front_left/b"})
        picture = folder / "Xvfb_screen0"
        self.assertTrue(until(lambda: picture.exists() and self.arrows(screen(picture)), 240), "no arrows on the screen")
        if PICTURE:
            import matplotlib.image  # noqa: PLC0415: only if a picture is wanted
            matplotlib.image.imsave(PICTURE, screen(picture).astype(np.uint8))

    @staticmethod
    def publish(pose, wrench):
        message = PoseStamped()
        message.header.stamp, message.header.frame_id = rospy.Time.now(), "track"
        message.pose.orientation.z, message.pose.orientation.w = np.sin(TURN / 2), np.cos(TURN / 2)
        pose.publish(message)
        answer = WrenchStamped()
        answer.header = message.header
        answer.wrench.force.x, answer.wrench.force.y, answer.wrench.force.z = FORCE
        answer.wrench.torque.x, answer.wrench.torque.y, answer.wrench.torque.z = MOMENT
        wrench.publish(answer)

    # The power of the wrench is the same at the origin of B and at the bush, in the axes of either body.
    def check_wrench(self, message):
        self.assertEqual(message.header.frame_id, "front_left/b")
        turn = ROTATION
        force = turn @ [message.wrench.force.x, message.wrench.force.y, message.wrench.force.z]
        moment = turn @ [message.wrench.torque.x, message.wrench.torque.y, message.wrench.torque.z]
        np.testing.assert_allclose(force, FORCE, atol=1e-9)
        for velocity, spin in (([1, 2, 3], [0, 0, 0]), ([0, 0, 0], [0.3, -1, 2]), ([1, -1, 0.5], [2, 1, -3])):
            at_bush = np.array(velocity) + np.cross(spin, turn @ PLACE)
            self.assertAlmostEqual(force @ at_bush + moment @ spin, FORCE @ velocity + MOMENT @ spin, 8)

    @staticmethod
    def arrows(picture):
        """Return True if enough pixels of the dark ground have the orange of the force and the blue of the moment."""
        red, green, blue = picture[:, :, 0], picture[:, :, 1], picture[:, :, 2]
        orange = (red > blue + 70) & (red > green + 30) & (green > blue)
        azure = (blue > red + 60) & (blue > green + 30) & (green > red)
        ground = (abs(picture - 48) < 4).all(axis=2)
        return orange.sum() > 200 and azure.sum() > 100 and ground.sum() > 50000


if __name__ == "__main__":
    if not (RVIZ and shutil.which("Xvfb")):
        print("skipped: no rviz, Xvfb, python3-rospy or python3-tf2-msgs")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
