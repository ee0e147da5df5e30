using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines;

/// <summary>How a job ended, as the controller reported it and not as it was planned.</summary>
public sealed record JobResult
{
    public required JobOutcome Outcome { get; init; }

    /// <summary>What caused the loss; null unless the job ended with <see cref="JobOutcome.LinkLost"/>.</summary>
    public LinkLoss? Loss { get; init; }

    /// <summary>One sentence for the operator: what happened, where, and what to do.</summary>
    public required string Message { get; init; }

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
    public JobPosition Place { get; init; }

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
        Message = sentence,
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
