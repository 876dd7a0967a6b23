#!/usr/bin/env python3
"""A player of one's own: blocks every ball back to the middle of the other half, from the -x end with paddle_a.

roslaunch ping_pong_sim match.launch a:=other b:=computer
rosrun ping_pong_sim returner.py
"""
import math

import rospy
from ping_pong_sim.msg import BallStates, PaddleCommand

TABLE, RADIUS, G = 0.76, 0.02, 9.81  # height of the playing surface [m], of the ball [m], [m/s^2]
HIT_X = -1.75  # plane in which it waits [m]
TARGET = (0.9, 0.0, TABLE + 0.55)  # above the middle of the other half: what it loses on the way is gravity's [m]


def fly(p, v, t):
    """Place and velocity after a time [s], by a parabola."""
    return (p[0] + v[0] * t, p[1] + v[1] * t, p[2] + v[2] * t - G * t * t / 2), (v[0], v[1], v[2] - G * t)


def meeting(p, v):
    """Place and velocity of the ball in the plane of the hit, after a bounce on this half; None: it does not come."""
    if v[0] > -0.5 or p[0] < HIT_X:
        return None
    height = max(p[2] - TABLE - RADIUS, 0.0)
    fall = (v[2] + math.sqrt(v[2] * v[2] + 2 * G * height)) / G  # until it is down at the table [s]
    if -1.37 < p[0] + v[0] * fall < 0.0:
        p, v = fly(p, v, fall)
        v = (0.85 * v[0], 0.85 * v[1], -0.9 * v[2])
    return fly(p, v, (HIT_X - p[0]) / v[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return [x / length for x in a]


def follow(balls):
    if not balls.balls:
        return
    ball = balls.balls[-1]  # the newest
    p, v = ball.pose.position, ball.twist.linear
    met = meeting((p.x, p.y, p.z), (v.x, v.y, v.z))
    at, coming = met if met else ((HIT_X, 0.0, TABLE + 0.25), (-4.0, 0.0, 0.0))
    away = [4.5 * x for x in unit([TARGET[i] - at[i] for i in range(3)])]  # as the ball shall leave [m/s]
    n = unit([away[i] - coming[i] for i in range(3)])  # a face that mirrors one into the other
    yaw, pitch = math.atan2(n[1], n[0]), -math.asin(n[2])
    command = PaddleCommand(mode=PaddleCommand.POSE)  # x of the paddle, out of its forehand, along n; its tip up
    command.pose.position.x, command.pose.position.y, command.pose.position.z = at
    cy, sy, cp, sp = math.cos(yaw / 2), math.sin(yaw / 2), math.cos(pitch / 2), math.sin(pitch / 2)
    o = command.pose.orientation
    o.w, o.x, o.y, o.z = cy * cp, -sy * sp, cy * sp, sy * cp
    commands.publish(command)


rospy.init_node("returner")
commands = rospy.Publisher("paddle_a/command", PaddleCommand, queue_size=1)
rospy.Subscriber("balls", BallStates, follow, queue_size=1, tcp_nodelay=True)
rospy.spin()
