"""Presses a key as a keyboard would, and waits until the paddle's pixels change. Part of scripts/key_latency."""
import ctypes
import statistics
import sys
import time

X, Y, WIDTH, HEIGHT = 290, 380, 70, 110  # of the paddle at rest in the view Corner
PATIENCE = 20.0  # [s]
KEYS = 'sdwa'  # in turn: what comes towards the viewer shows later than what goes sideways
ALL_PLANES, Z_PIXMAP = ctypes.c_ulong(-1), 2

x11 = ctypes.CDLL('libX11.so.6')
xtst = ctypes.CDLL('libXtst.so.6')
for function, result in ((x11.XOpenDisplay, ctypes.c_void_p), (x11.XDefaultRootWindow, ctypes.c_ulong),
                         (x11.XGetImage, ctypes.c_void_p), (x11.XStringToKeysym, ctypes.c_ulong)):
    function.restype = result
display = ctypes.c_void_p(x11.XOpenDisplay(None))
root = ctypes.c_ulong(x11.XDefaultRootWindow(display))


class Image(ctypes.Structure):
    """The beginning of Xlib's XImage."""
    _fields_ = [('width', ctypes.c_int), ('height', ctypes.c_int), ('xoffset', ctypes.c_int), ('format', ctypes.c_int),
                ('data', ctypes.c_void_p), ('byte_order', ctypes.c_int), ('bitmap_unit', ctypes.c_int),
                ('bitmap_bit_order', ctypes.c_int), ('bitmap_pad', ctypes.c_int), ('depth', ctypes.c_int),
                ('bytes_per_line', ctypes.c_int)]


def pixels():
    image = x11.XGetImage(display, root, X, Y, WIDTH, HEIGHT, ALL_PLANES, Z_PIXMAP)
    head = ctypes.cast(image, ctypes.POINTER(Image)).contents
    data = ctypes.string_at(head.data, head.bytes_per_line * head.height)
    x11.XDestroyImage(ctypes.c_void_p(image))
    return data


def key(name, down):
    code = x11.XKeysymToKeycode(display, ctypes.c_ulong(x11.XStringToKeysym(name.encode())))
    xtst.XTestFakeKeyEvent(display, code, int(down), ctypes.c_ulong(0))
    x11.XFlush(display)


def tap(name):
    key(name, True)
    key(name, False)


def wait_until(condition, what):
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            sys.exit(f'key_to_pixel: {what} within {PATIENCE:.0f} s')
        time.sleep(0.002)  # the machine shall draw, not look


def at_rest(seconds=0.4):
    """The pixels, once they have been the same for a while."""
    last, since = pixels(), time.monotonic()
    end = since + PATIENCE
    while time.monotonic() - since < seconds:
        time.sleep(0.02)
        now = pixels()
        if now != last:
            last, since = now, time.monotonic()
        if since > end:
            sys.exit('key_to_pixel: the picture does not come to rest')
    return last


def main():
    times = int(sys.argv[1])
    xtst.XTestFakeMotionEvent(display, -1, 640, 600, ctypes.c_ulong(0))  # keys go where the mouse is
    before = at_rest()

    def swung():
        key('s', True)
        time.sleep(0.2)
        key('s', False)
        return pixels() != before
    wait_until(swung, 'RViz answers no key')
    delays = []
    while len(delays) < times:
        moved = at_rest()
        tap('BackSpace')
        wait_until(lambda: pixels() != moved, 'no reset')
        start = at_rest(0.8)  # a paddle that comes to rest goes on for longer than pixels show
        time.sleep(0.037 * (len(delays) % 5))  # not in step with the frames
        pressed = KEYS[len(delays) % len(KEYS)]
        begun = time.perf_counter()
        key(pressed, True)
        wait_until(lambda: pixels() != start, 'no motion')
        delays.append(1e3 * (time.perf_counter() - begun))
        time.sleep(0.1)
        key(pressed, False)
    delays.sort()
    print(f'key to pixel, {times} times: median {statistics.median(delays):.0f} ms, '
          f'nine in ten within {delays[int(0.9 * (times - 1))]:.0f} ms, most {delays[-1]:.0f} ms')


if __name__ == '__main__':
    main()
