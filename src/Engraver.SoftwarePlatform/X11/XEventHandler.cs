using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11;

internal delegate void XEventHandler(ref XEvent received);
