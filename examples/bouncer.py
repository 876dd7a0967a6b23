#!/usr/bin/env python3
"""A controller node: keeps the first ball bouncing on a paddle that lies flat at z = 1 m, half a metre high.

roslaunch ping_pong_sim sim.launch scene:=$(rospack find ping_pong_sim)/examples/bouncer.yaml
rosrun ping_pong_sim bouncer.py
"""
import math

import rospy
from ping_pong_sim.msg import BallStates, PaddleCommand


def follow(balls):
    if not balls.balls:
        return
    ball = balls.balls[0]
    # Mirror law (Buehler, Koditschek, Kindlmann 1994): the paddle mirrors the ball's height, scaled down, and so meets it
    # with gain times its speed. (1 - e) / (1 + e) = 0.11 makes up for the loss at e = 0.8; more of it while too low.
    speed = ball.twist.linear.z  # [m/s]
    top = ball.pose.position.z + speed * speed / (2.0 * 9.81)  # [m], where it will be highest
    gain = min(max(0.11 + 0.1 * (1.5 - top), 0.0), 0.2)
    command = PaddleCommand(mode=PaddleCommand.POSE)
    command.header.frame_id = "world"
    command.pose.position.x = ball.pose.position.x  # stay below the ball [m]
    command.pose.position.y = ball.pose.position.y
    command.pose.position.z = 1.0 - gain * (ball.pose.position.z - 1.0)
    command.pose.orientation.y = -math.sqrt(0.5)  # forehand up
    command.pose.orientation.w = math.sqrt(0.5)
    command.twist.linear.x = ball.twist.linear.x
    command.twist.linear.y = ball.twist.linear.y
    command.twist.linear.z = -gain * speed
    commands.publish(command)


rospy.init_node("bouncer")
commands = rospy.Publisher("paddle/command", PaddleCommand, queue_size=1)
rospy.Subscriber("balls", BallStates, follow, queue_size=1, tcp_nodelay=True)
rospy.spin()
