namespace Engraver.Core.Machines;

/// <summary>Progress of a job, by the controller's last report.</summary>
/// <param name="Stroke">Index of the present stroke.</param>
/// <param name="Place">Counts, job frame.</param>
/// <param name="Seconds">Controller time since the job began.</param>
/// <param name="Outputs">Outputs 1 to 8 (_OP0), bit 0 is output 1; null where they were not read.</param>
public readonly record struct JobProgress(int Stroke, int SegmentsSent, int SegmentsExecuted, int SegmentCount, CountsPoint Place, bool ToolOn, double Seconds, int? Outputs = null)
{
    /// <summary>A sequence of the path is in progress, with the tool on or off.</summary>
    public bool IsOnPath { get; init; }

    /// <summary>As in <see cref="TracePoint.Error"/>.</summary>
    public CountsPoint? Error { get; init; }

    public long X => Place.X;

    public long Y => Place.Y;

    /// <summary>Whether the job runs, brakes for a hold or is held.</summary>
    public JobPhase Phase { get; init; }

    /// <summary>Factor of the programmed feed in effect.</summary>
    public double FeedRatio { get; init; } = 1.0;

    /// <summary>Part of the time since the report before in which the command handle was busy with an exchange, 0 to 1; null in the first report.</summary>
    public double? LinkLoad { get; init; }

    /// <summary>Factor of the rapid speed in effect.</summary>
    public double RapidRatio { get; init; } = 1.0;
}
