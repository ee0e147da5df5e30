using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Motion.Planning;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>A sequence as it is sent: as in the program or, for an override above the programmed feed, with speeds that are planned for it with the same
/// limits.</summary>
/// <remarks>The path is the program's; a segment of it may be sent in two where its speed changes. Ledger and journal count the segments of the
/// program.</remarks>
/// <param name="Sequence">What is sent.</param>
/// <param name="Ratio">The override for which its speeds are planned.</param>
internal sealed record CutSequence(VectorSequence Sequence, double Ratio)
{
    /// <summary>A plan that saves less than this part of the time is not used.</summary>
    private const double LeastGain = 0.01;

    /// <summary>As it is in the program.</summary>
    private VectorSequence Program { get; init; } = Sequence;

    /// <summary>Segments that are sent after which the same segment of the program continues, in order.</summary>
    public IReadOnlyList<int> Divided { get; private init; } = [];

    /// <summary>As it is in the program.</summary>
    public static CutSequence AsPlanned(VectorSequence sequence) => new(sequence, 1.0);

    /// <summary>Planned for an override above 1.</summary>
    /// <param name="sequence">Of the program.</param>
    /// <param name="profile">The machine.</param>
    /// <param name="ratio">Factor of the feed.</param>
    /// <param name="least">VA and VD are not smaller, counts/s2.</param>
    /// <param name="carried">The highest speed at which the link carries the segments while they are cut, counts/s; null for no such limit.</param>
    /// <returns>As it is in the program where no feed is known or a higher one saves no time.</returns>
    public static CutSequence Planned(VectorSequence sequence, MachineProfile profile, double ratio, int least, Func<VectorSequence, int>? carried)
    {
        if (sequence.Feed is not { } feed || sequence.ChangesHeight) return AsPlanned(sequence);
        var planner = new SpeedPlanner(PathLimits.Of(profile), DmcLimits.AccelerationStep);
        Add(sequence, planner, Math.Min(DmcLimits.FastestSpeed, Math.Floor(feed * ratio / 2.0) * 2.0));
        if (FeedLimit.IsNeeded(sequence.Segments.Count) && FeedLimit.Of([.. sequence.Segments.Select(segment => segment.Length)]) is { } sent) planner.LimitTo(sent);
        planner.Plan(least);
        var division = new SpeedDivision(planner, new AngleQuantum(profile.AngleQuantumDegrees));
        var (segments, divided) = (new List<VectorSegment>(sequence.Segments.Count), new List<int>());
        division.Divide(sequence.Segments, sequence.Start, (segment, goesOn) =>
        {
            if (goesOn) divided.Add(segments.Count);
            segments.Add(segment);
        });
        var planned = sequence with { Speed = division.Fastest, Acceleration = planner.Acceleration, Segments = division.IsUniform ? [.. segments.Select(segment => segment with { Speed = 0 })] : segments };
        if (carried is not null) planned = planned.LimitedTo(carried(planned));
        return SequenceProfile.SecondsOf(planned, profile) > (1.0 - LeastGain) * SequenceProfile.SecondsOf(sequence, profile)
            ? AsPlanned(sequence)
            : new CutSequence(planned, ratio) { Program = sequence, Divided = divided };
    }

    /// <summary>Segments of the program among the first ones that are sent.</summary>
    /// <param name="sent">Number of segments as they are sent.</param>
    public int WholeAmong(int sent) => WholeAmong(Divided, sent);

    /// <summary>The same.</summary>
    /// <param name="divided">As <see cref="Divided"/>.</param>
    /// <param name="sent">As for <see cref="WholeAmong(int)"/>.</param>
    public static int WholeAmong(IReadOnlyList<int> divided, int sent)
    {
        var (low, high) = (0, divided.Count);
        while (low < high)
        {
            var middle = (low + high) / 2;
            if (divided[middle] < sent) low = middle + 1;
            else high = middle;
        }

        return sent - low;
    }

    /// <summary>The segment of the program that a segment ends; null where it continues with the next one.</summary>
    /// <param name="index">Of the segment as it is sent.</param>
    public VectorSegment? Ended(int index) => WholeAmong(index + 1) is var whole && whole > WholeAmong(index) ? Program.Segments[whole - 1] : null;

    /// <summary>Appends the segments to a planner.</summary>
    private static void Add(VectorSequence sequence, SpeedPlanner planner, double feed)
    {
        var (from, last, length) = (sequence.Start, default(PathDirection?), 0.0);
        foreach (var segment in sequence.Segments)
        {
            var (first, end) = PathDirection.AtEnds(from, segment);
            if (last is { } before && IsRounding(before, first, Math.Min(length, segment.Length))) first = before;
            planner.Add(segment.Length, segment.Kind == VectorSegmentKind.Line ? double.PositiveInfinity : segment.Radius, feed, first, end);
            (from, last, length) = (segment.End, end, segment.Length);
        }
    }

    /// <summary>A turn by less than a count over the shorter of two segments is that of ends in whole counts, and not of the drawing.</summary>
    private static bool IsRounding(PathDirection before, PathDirection after, double shorter) => double.Hypot(after.X - before.X, after.Y - before.Y) * shorter <= 1.0;
}
