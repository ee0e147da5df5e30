using Engraver.Core.Diagnostics;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Language;
using Engraver.Galil.Programs;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs;

/// <summary>How a job ended, in what the controller said and not in what was planned.</summary>
public sealed record JobResult
{
    public required JobOutcome Outcome { get; init; }

    /// <summary>What the job was lost by; null unless it ended with <see cref="JobOutcome.LinkLost"/>.</summary>
    public LinkLoss? Loss { get; init; }

    /// <summary>One sentence for the operator: what happened, where, and what to do.</summary>
    public required string Sentence { get; init; }

    public required int SegmentsSent { get; init; }

    /// <summary>By _CS or seq of the controller.</summary>
    public required int SegmentsExecuted { get; init; }

    /// <summary>Those of them that were counted while the tool was seen off though it should have been on: they have no part in <see cref="LengthByStroke"/>.</summary>
    public int SegmentsUncut { get; init; }

    /// <summary>Controller time, in nominal samples (TM).</summary>
    public required double Seconds { get; init; }

    /// <summary>How often the segment buffer ran dry before the end of a sequence was sent.</summary>
    public required int Underruns { get; init; }

    /// <summary>Number of <c>?</c> replies; buffer full (32) is none.</summary>
    public required int Rejected { get; init; }

    /// <summary>_RPA and _RPB, the controller's own absolute counts; the last known when the link was lost, null when none was ever read.</summary>
    public required CountsPoint? FinalPosition { get; init; }

    /// <summary>Controller counts at the drawing's zero: what was added to the job frame. Null when the job ended before the frame was taken.</summary>
    public required CountsPoint? FrameOrigin { get; init; }

    /// <summary>False when the link was lost before the controller said where it came to rest: it went on with what it had until its watchdog tripped, and may have cut more than is counted here.</summary>
    public bool IsEndKnown { get; init; } = true;

    /// <summary>The refused command that ended the job, when one did.</summary>
    public Rejected? Refusal { get; init; }

    /// <summary>Positions polled during the run, job frame.</summary>
    public required IReadOnlyList<TracePoint> PolledTrace { get; init; }

    /// <summary>Drawing entities with at least one executed segment, in order of cutting.</summary>
    public required IReadOnlyList<int> ExecutedEntityIndices { get; init; }

    /// <summary>Executed segments of each stroke of the motion program.</summary>
    public required IReadOnlyList<int> ExecutedByStroke { get; init; }

    /// <summary>Cut length of each stroke in counts, whole segments only; how far the segment under way was cut is told by <see cref="UnfinishedSegment"/>.</summary>
    public required IReadOnlyList<double> LengthByStroke { get; init; }

    /// <summary>What had to be done to the job to run it this way: strokes cut by the controller's memory.</summary>
    public IReadOnlyList<Diagnostic> Diagnostics { get; init; } = [];

    /// <summary>What could not be left as it was found, a sentence each.</summary>
    public IReadOnlyList<string> NotRestored { get; init; } = [];

    internal static JobResult NotStarted(MotionProgram program, string sentence) => new()
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
        ExecutedByStroke = new int[program.Strokes.Count],
        LengthByStroke = new double[program.Strokes.Count],
    };
}

public enum JobOutcome
{
    Complete,

    /// <summary>By the operator; the machine stands.</summary>
    Stopped,

    /// <summary>The controller refused a command, was busy, or ended a motion that it should have finished.</summary>
    Refused,

    /// <summary>What was cut is not the drawing, by what the controller or the simulator's record says: the path left the drawing, or part of it was never cut.</summary>
    Deviated,

    /// <summary>The link failed, or the watchdog in the controller did not hear from this program and stopped the machine.</summary>
    LinkLost,
}

/// <summary>What a job that ended with <see cref="JobOutcome.LinkLost"/> was lost by.</summary>
public enum LinkLoss
{
    /// <summary>The link failed, or the controller fell silent.</summary>
    Link,

    /// <summary>The watchdog in the controller did not hear from this program in time and stopped the machine; the link may stand.</summary>
    Watchdog,
}
