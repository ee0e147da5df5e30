namespace Engraver.Galil.Jobs.Watching;

/// <summary>The speeds of the sequences that may be in progress when a poll is read, counts/s, without the feed override.</summary>
/// <param name="Lowest">VS of its slowest sequence.</param>
/// <param name="Highest">VS of its fastest sequence.</param>
internal readonly record struct PlannedSpeed(int Lowest, int Highest)
{
    public static PlannedSpeed Of(int speed) => new(speed, speed);
}
