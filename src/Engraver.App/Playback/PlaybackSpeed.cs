using Engraver.App.Binding;

namespace Engraver.App.Playback;

/// <summary>A speed of the playback to choose.</summary>
public sealed class PlaybackSpeed(string name, double factor, PlaybackModel playback) : Observable
{
    public string Name => name;

    /// <summary>Times the machine's own; infinite is to the end at once.</summary>
    public double Factor => factor;

    public bool IsChosen => playback.Speed == factor;

    public Act Choose { get; } = new(() => playback.Speed = factor);

    public void Look() => Tell(nameof(IsChosen));
}
