namespace Engraver.SoftwarePlatform.X11;

internal delegate void XEventHandler(ref XEvent received);
