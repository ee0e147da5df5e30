using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>The planned speeds along one sequence, by the number of segments that the controller has executed.</summary>
internal sealed class PlannedSpeeds
{
    /// <summary>A poll may be older or newer than the counter by this many segments.</summary>
    private const int Around = 2;

    private readonly int[] _lowest = [];
    private readonly int[] _highest = [];
    private readonly PlannedSpeed _anywhere;

    public PlannedSpeeds(VectorSequence sequence, MachineProfile profile)
    {
        _anywhere = PlannedSpeed.Anywhere([sequence], profile);
        if (!sequence.HasOwnSpeeds) return;
        var (planned, at) = (SequenceProfile.Of(sequence, profile), 0.0);
        (_lowest, _highest) = (new int[sequence.Segments.Count], new int[sequence.Segments.Count]);
        for (var i = 0; i < _lowest.Length; i++)
        {
            var (commanded, entry) = (sequence.SpeedOf(sequence.Segments[i]), planned.SpeedAt(at));
            at += sequence.Segments[i].Length;
            var exit = planned.SpeedAt(at);
            (_lowest[i], _highest[i]) = ((int)Math.Min(commanded, Math.Min(entry, exit)), (int)Math.Ceiling(Math.Max(commanded, Math.Max(entry, exit))));
        }
    }

    /// <summary>The speeds near a segment.</summary>
    /// <param name="executed">Number of segments that are done.</param>
    public PlannedSpeed At(int executed)
    {
        if (_lowest.Length == 0) return _anywhere;
        var (from, to) = (Math.Clamp(executed - Around, 0, _lowest.Length - 1), Math.Clamp(executed + Around, 0, _lowest.Length - 1));
        return _anywhere with { Lowest = _lowest[from..(to + 1)].Min(), Highest = _highest[from..(to + 1)].Max() };
    }
}
