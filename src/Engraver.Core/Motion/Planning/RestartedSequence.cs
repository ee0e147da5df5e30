using Engraver.Core.Machines;

namespace Engraver.Core.Motion.Planning;

/// <summary>The rest of a planned sequence, begun at rest: its planned speeds stay, but on an arc the speed may not rise above that up to which the total
/// acceleration is kept (<see cref="SpeedPlanner"/>).</summary>
public static class RestartedSequence
{
    /// <summary>The sequence with the segments before <paramref name="first"/> as they are, and the others as they are run from rest.</summary>
    public static VectorSequence After(VectorSequence sequence, int first, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(sequence);
        var rest = Of(sequence with { Segments = [.. sequence.Segments.Skip(first)] }, profile);
        return sequence with { Segments = [.. sequence.Segments.Take(first), .. rest.Segments] };
    }

    /// <summary>The sequence as it is run from rest.</summary>
    public static VectorSequence Of(VectorSequence sequence, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(sequence);
        ArgumentNullException.ThrowIfNull(profile);
        var acceleration = (double)sequence.AccelerationOn(profile);
        var bound = PathLimits.Of(profile).OnArcs;
        var across = Math.Sqrt(Math.Max(0.0, (bound * bound) - (acceleration * acceleration)));
        var (segments, speed, isChanged) = (new List<VectorSegment>(sequence.Segments.Count), 0.0, false);
        foreach (var segment in sequence.Segments)
        {
            var commanded = sequence.SpeedOf(segment);
            if (segment.Kind == VectorSegmentKind.Arc && speed < commanded)
            {
                var most = Math.Max(2, 2 * (int)(Math.Max(speed, Math.Sqrt(across * segment.Radius)) / 2.0));
                (commanded, isChanged) = (Math.Min(commanded, most), isChanged || most < commanded);
            }

            segments.Add(segment with { Speed = commanded });
            speed = commanded > speed ? Math.Min(commanded, Math.Sqrt((speed * speed) + (2.0 * acceleration * segment.Length))) : Math.Max(commanded, Math.Sqrt(Math.Max(0.0, (speed * speed) - (2.0 * acceleration * segment.Length))));
        }

        return isChanged ? sequence with { Segments = segments } : sequence;
    }
}
