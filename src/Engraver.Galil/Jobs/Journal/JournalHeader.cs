using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>First line of a job in the journal.</summary>
/// <param name="StartX">_RPA when the job began.</param>
/// <param name="FrameX">Job frame: added to drawing counts to get the controller's counts.</param>
public sealed record JournalHeader(string Drawing, string Controller, JobMode Mode, int SegmentCount, long StartX, long StartY, long FrameX, long FrameY, DateTimeOffset StartedAt)
{
    public string Kind { get; } = "job";

    /// <summary>Letters of the axes of X, Y and, where there is one, Z; empty in journals of an older version.</summary>
    public string Axes { get; init; } = "";

    /// <summary>_RPA of the Z axis when the job began; 0 without one.</summary>
    public int StartZ { get; init; }

    /// <summary>Counts that are added to heights of the drawing; 0 where an output is the tool.</summary>
    public int FrameZ { get; init; }

    /// <summary>Where an output is the tool of a machine with a Z axis: the height at which the job is cut, the controller's own counts; null
    /// elsewhere.</summary>
    public int? HeightOfCut { get; init; }

    /// <summary>Identifies the motion program; empty in journals of an older version.</summary>
    public string Program { get; init; } = "";

    /// <summary>As in <see cref="JobOptions.Settings"/>; null in journals of an older version.</summary>
    public IReadOnlyDictionary<string, string>? Settings { get; init; }

    /// <summary>The number that the job stored in a variable of the controller, which loses it at power-off.</summary>
    public int Mark { get; init; }

    /// <summary>The job was a dry run: nothing was cut.</summary>
    public bool DryRun { get; init; }

    /// <summary>Segments that an earlier job had already cut.</summary>
    public int FromSegments { get; init; }

    /// <summary>Counts along the next segment that the earlier job had also cut.</summary>
    public double FromAlong { get; init; }
}
