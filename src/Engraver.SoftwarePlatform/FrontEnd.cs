using Engraver.SoftwarePlatform.Headless;

namespace Engraver.SoftwarePlatform;

/// <summary>Where windows appear and where input comes from: one of two cases.</summary>
public abstract record FrontEnd
{
    private FrontEnd()
    {
    }

    /// <summary>Real windows on an X server.</summary>
    public sealed record X11 : FrontEnd;

    /// <summary>Windows in memory, controlled through <paramref name="Desktop"/>; one application per desktop.</summary>
    public sealed record Headless(HeadlessDesktop Desktop) : FrontEnd;
}
