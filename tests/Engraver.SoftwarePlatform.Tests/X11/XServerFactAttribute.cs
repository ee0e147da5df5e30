namespace Engraver.SoftwarePlatform.Tests.X11;

/// <summary>A test with a real window: it needs Xvfb, a window manager, and the X11 tools listed here.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class XServerFactAttribute : FactAttribute
{
    private static readonly string[] s_programs = ["Xvfb", "openbox", "xdotool", "xclip", "setxkbmap", "xprop", "xwininfo"];

    public XServerFactAttribute()
    {
        var missing = s_programs.Where(program => !IsOnPath(program)).ToList();
        if (missing.Count > 0) Skip = $"Not installed: {string.Join(", ", missing)} (apt-get install xvfb openbox xdotool xclip x11-xkb-utils x11-utils).";
    }

    private static bool IsOnPath(string program) =>
        (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Any(folder => File.Exists(Path.Combine(folder, program)));
}
