using Avalonia.Rendering;

namespace Engraver.SoftwarePlatform.Headless;

/// <summary>Frames come when they are asked for.</summary>
internal sealed class HandFiredTimer(TimeProvider time) : IRenderTimer
{
    private readonly long _start = time.GetTimestamp();

    public Action<TimeSpan>? Tick { get; set; }

    public bool RunsInBackground => false;

    /// <summary>False while nothing waits to be drawn.</summary>
    public bool IsWanted => Tick is not null;

    public void Fire() => Tick?.Invoke(time.GetElapsedTime(_start));
}
