using Engraver.SoftwarePlatform.Input;

namespace Engraver.SoftwarePlatform.X11;

internal static class X11Setup
{
    public static void Bind(SoftwarePlatformOptions options, InputDoor door) =>
        throw new DisplayUnavailableException("The X11 front end is not part of this build.");
}
