using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines;

/// <summary>How a job ended, as the controller reported it and not as it was planned.</summary>
public sealed record JobResult
{
    public required JobOutcome Outcome { get; init; }

    /// <summary>What caused the loss; null unless the job ended with <see cref="JobOutcome.LinkLost"/>.</summary>
    public LinkLoss? Loss { get; init; }

    /// <summary>One sentence for the operator: what happened, where, and what to do.</summary>
    public required string Sentence { get; init; }

    public required int SegmentsSent { get; init; }

    /// <summary>Executed segments as the controller counted them: _CS, or seq.</summary>
    public required int SegmentsExecuted { get; init; }

    /// <summary>Executed segments during which the tool was reported off although it should have been on: they are not part of
    /// <see cref="LengthByStroke"/>.</summary>
    public int SegmentsUncut { get; init; }

    /// <summary>Controller time in seconds of nominal samples (TM).</summary>
    public required double Seconds { get; init; }

    /// <summary>Number of times the segment buffer ran dry before the end of a sequence was sent.</summary>
    public required int Underruns { get; init; }

    /// <summary>Number of <c>?</c> replies, without "buffer full" (TC 32).</summary>
    public required int Rejected { get; init; }

    /// <summary>_RP of every axis of the job, the controller's own absolute counts; the last known position when the link was lost, null when none was ever
    /// read.</summary>
    public required CountsPoint? FinalPosition { get; init; }

    /// <summary>Controller counts at the drawing's zero: what was added to the job frame. Null when the job ended before the frame was taken.</summary>
    public required CountsPoint? FrameOrigin { get; init; }

    /// <summary>False when the link was lost before the controller reported where it came to rest: it continued with its stored segments until the watchdog
    /// tripped, and may have cut more than is counted here.</summary>
    public bool IsEndKnown { get; init; } = true;

    /// <summary>Everything before it was certainly cut, by the last position that was polled with the tool on: another job continues from here.</summary>
    public JobPlace Place { get; init; }

    /// <summary>How often the operator held the job.</summary>
    public int Holds { get; init; }

    /// <summary>Why the machine's position cannot be trusted from here on ("an axis could not follow"); empty while it can.</summary>
    public string PositionDoubt { get; init; } = "";

    /// <summary>The refused command that ended the job; null when none did.</summary>
    public MachineRefusal? Refusal { get; init; }

    /// <summary>The last position polled with the tool on and the last one with the tool off, in order, job frame. All of them are reported while the job runs
    /// (<see cref="JobOptions.Polled"/>).</summary>
    public required IReadOnlyList<TracePoint> PolledTrace { get; init; }

    /// <summary>Drawing entities with at least one executed segment, in order of cutting.</summary>
    public required IReadOnlyList<int> ExecutedEntityIndices { get; init; }

    /// <summary>Executed segments of each stroke of the motion program.</summary>
    public required IReadOnlyList<int> ExecutedByStroke { get; init; }

    /// <summary>Cut length of each stroke in counts, of whole segments only; the journal's unfinished segment contains the rest.</summary>
    public required IReadOnlyList<double> LengthByStroke { get; init; }

    /// <summary>Findings about how the job was run: strokes that were divided because of the controller's memory.</summary>
    public IReadOnlyList<Diagnostic> Diagnostics { get; init; } = [];

    /// <summary>Settings that could not be restored, one sentence each.</summary>
    public IReadOnlyList<string> NotRestored { get; init; } = [];

    /// <summary>The result of a job that ended before anything was sent to the controller.</summary>
    /// <param name="strokes">Number of strokes of the program.</param>
    public static JobResult NotStarted(int strokes, string sentence) => new()
    {
        Outcome = JobOutcome.Refused,
        Sentence = sentence,
        SegmentsSent = 0,
        SegmentsExecuted = 0,
        Seconds = 0,
        Underruns = 0,
        Rejected = 0,
        FinalPosition = null,
        FrameOrigin = null,
        PolledTrace = [],
        ExecutedEntityIndices = [],
        ExecutedByStroke = new int[strokes],
        LengthByStroke = new double[strokes],
    };
}

public enum JobOutcome
{
    Complete,

    /// <summary>Stopped by the operator; the machine is at rest.</summary>
    Stopped,

    /// <summary>The controller refused a command, was busy, or ended a motion that it should have finished.</summary>
    Refused,

    /// <summary>By the controller's positions or the simulator's record, the path left the drawing, or part of the drawing was not cut.</summary>
    Deviated,

    /// <summary>The link failed, or the watchdog in the controller received nothing from this program and stopped the machine.</summary>
    LinkLost,
}

/// <summary>The cause of an end with <see cref="JobOutcome.LinkLost"/>.</summary>
public enum LinkLoss
{
    /// <summary>The link failed, or the controller no longer replied.</summary>
    Link,

    /// <summary>The watchdog in the controller received nothing from this program in time and stopped the machine; the link may still work.</summary>
    Watchdog,
}

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

    /// <summary>Factor of the rapid speed in effect.</summary>
    public double RapidRatio { get; init; } = 1.0;
}

/// <summary>A polled position.</summary>
/// <param name="Seconds">Controller time since the job began.</param>
/// <param name="Place">Counts, job frame.</param>
/// <param name="ToolOn">Whether the tool output was on, as the controller reported.</param>
public readonly record struct TracePoint(double Seconds, CountsPoint Place, bool ToolOn)
{
    public long X => Place.X;

    public long Y => Place.Y;

    /// <summary>Segments known to be done before this poll: the tool is on the next one, or further.</summary>
    public int Executed { get; init; }

    /// <summary>Distance of each motor from its command at the last reading, counts; null before the first reading, and where it is not read.</summary>
    public CountsPoint? Error { get; init; }
}

/// <summary>A command that the controller refused.</summary>
/// <param name="Code">The controller's number for the reason; compare this and not the text.</param>
/// <param name="Text">The controller's text for the reason.</param>
/// <param name="Command">The refused command.</param>
/// <param name="Sentence">For the operator: what was refused, why, and the consequence here.</param>
public sealed record MachineRefusal(int Code, string Text, string Command, string Sentence);
