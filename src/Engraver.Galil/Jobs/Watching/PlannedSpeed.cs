using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>The speeds and accelerations that the path may have when a poll is read, counts/s and counts/s2, without the feed override.</summary>
/// <param name="Lowest">Slowest speed that is commanded there, or reached at a joint.</param>
/// <param name="Highest">Fastest speed that is commanded there, or reached at a joint.</param>
/// <param name="LowestSetting">The smallest value that VS may have.</param>
/// <param name="HighestSetting">The largest.</param>
/// <param name="LowestAcceleration">The smallest value of VA and VD.</param>
/// <param name="HighestAcceleration">The largest.</param>
internal readonly record struct PlannedSpeed(int Lowest, int Highest, int LowestSetting, int HighestSetting, int LowestAcceleration, int HighestAcceleration)
{
    /// <summary>Of a move that has one speed.</summary>
    public static PlannedSpeed Of(int speed, int acceleration) => new(speed, speed, speed, speed, acceleration, acceleration);

    /// <summary>Anywhere on some sequences.</summary>
    public static PlannedSpeed Anywhere(IReadOnlyList<VectorSequence> sequences, MachineProfile profile) => new(
        sequences.Min(Slowest), sequences.Max(sequence => sequence.Speed), sequences.Min(Slowest), sequences.Max(sequence => sequence.Speed),
        sequences.Min(sequence => sequence.AccelerationOn(profile)), sequences.Max(sequence => sequence.AccelerationOn(profile)));

    private static int Slowest(VectorSequence sequence) => sequence.HasOwnSpeeds ? sequence.Segments.Min(segment => sequence.SpeedOf(segment)) : sequence.Speed;
}
