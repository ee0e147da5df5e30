namespace Engraver.Core.Machines;

/// <summary>VM ... VE: segments that are cut without a stop. It begins at the present position of the machine.</summary>
/// <param name="Start">Where the sequence begins, job frame.</param>
/// <param name="Speed">VS for this sequence, even counts/s: the highest speed of its segments.</param>
/// <param name="Segments">At least one.</param>
public sealed record VectorSequence(CountsPoint Start, int Speed, IReadOnlyList<VectorSegment> Segments)
{
    /// <summary>Lines that rise or fall: the sequence is run in three axes (LM) instead of two (VM). It has no arcs.</summary>
    public bool ChangesHeight { get; init; }

    /// <summary>VA and VD, counts/s2; null: the acceleration of the machine profile.</summary>
    public int? Acceleration { get; init; }

    /// <summary>The feed that is asked, counts/s: its speeds are planned for it, and an override is a factor of it. Null where heights change or it is not
    /// known.</summary>
    public int? Feed { get; init; }

    /// <summary>Segments have speeds of their own; false where every one is run at <see cref="Speed"/>.</summary>
    public bool HasOwnSpeeds => Segments is SequenceSegments columns ? columns.HaveOwnSpeeds : Segments.Any(segment => segment.Speed != 0);

    public CountsPoint End => Segments[^1].End;

    /// <summary>The speed that is commanded from the start of a segment, counts/s.</summary>
    public int SpeedOf(in VectorSegment segment) => segment.Speed == 0 ? Speed : segment.Speed;

    /// <summary>VA and VD on a machine, counts/s2.</summary>
    public int AccelerationOn(MachineProfile profile) => Acceleration ?? profile.AccelerationCounts;

    /// <summary>The same sequence, in no segment faster than a speed.</summary>
    /// <param name="speed">Even counts/s.</param>
    public VectorSequence LimitedTo(int speed) => speed >= Speed ? this : this with
    {
        Speed = speed,
        Segments = HasOwnSpeeds ? [.. Segments.Select(segment => segment.Speed > speed ? segment with { Speed = speed } : segment)] : Segments,
    };

    public double Length => Segments is SequenceSegments columns ? columns.Length : Segments.Sum(segment => segment.Length);
}
