namespace Engraver.SoftwarePlatform;

/// <summary>Options of <see cref="AppBuilderExtensions.UseSoftwarePlatform"/>. All have usable defaults.</summary>
public sealed record SoftwarePlatformOptions
{
    public FrontEnd FrontEnd { get; init; } = new FrontEnd.X11();

    /// <summary>Pixels for each device independent unit. 0 reads the display's setting (<c>Xft.dpi</c> / 96), or 1 when there is none.</summary>
    public double Scale { get; init; } = 1.0;

    /// <summary>The X display, such as ":1"; null is the environment's DISPLAY.</summary>
    public string? DisplayName { get; init; }

    /// <summary>Receives every key before the window does, on the input thread.</summary>
    public KeyFilter? Filter { get; init; }

    /// <summary>Rectangles that handle a press on the input thread.</summary>
    public InputRegions Regions { get; init; } = new();

    /// <summary>WM_CLASS of the windows: how a window manager groups them.</summary>
    public string ApplicationName { get; init; } = "avalonia";

    /// <summary>Called once, on the input thread, when the display is gone. The application's lifetime is shut down right after it, with exit code 1.</summary>
    public Action<DisplayUnavailableException>? DisplayLost { get; init; }
}
