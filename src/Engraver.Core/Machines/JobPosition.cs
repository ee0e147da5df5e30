namespace Engraver.Core.Machines;

/// <summary>A place in a motion program: everything before it is cut.</summary>
/// <param name="Segments">Segments that are cut completely, in the order of cutting.</param>
/// <param name="Along">Counts along the next segment that are also cut.</param>
public readonly record struct JobPosition(int Segments, double Along) : IComparable<JobPosition>
{
    public static bool operator <(JobPosition left, JobPosition right) => left.CompareTo(right) < 0;

    public static bool operator >(JobPosition left, JobPosition right) => left.CompareTo(right) > 0;

    public static bool operator <=(JobPosition left, JobPosition right) => left.CompareTo(right) <= 0;

    public static bool operator >=(JobPosition left, JobPosition right) => left.CompareTo(right) >= 0;

    /// <summary>The later of two places.</summary>
    public static JobPosition Max(JobPosition one, JobPosition other) => one < other ? other : one;

    public int CompareTo(JobPosition other) => Segments != other.Segments ? Segments.CompareTo(other.Segments) : Along.CompareTo(other.Along);
}
