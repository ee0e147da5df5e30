using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Posts;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Verification;

/// <summary>Everybody who listens while a program is read back: where it cuts, how fast, how much, when, and what it says beside.</summary>
internal sealed class ReadBackJudges
{
    private readonly PreparedJob _job;
    private readonly PostedWith _posted;
    private readonly ITraceJudge[] _cuts;
    private readonly LengthJudge? _length;
    private readonly PaceJudge? _pace;
    private readonly double _deviation;

    /// <param name="tolerances">Of the reader's form.</param>
    /// <param name="bridges">Lines over gaps within the join tolerance, which may be cut besides.</param>
    public ReadBackJudges(PreparedJob job, PostedWith posted, IProgramReader reader, TraceTolerances tolerances, IReadOnlyList<StrokeMove> bridges)
    {
        var (machine, isInSpace) = (job.Settings.Machine, reader.TellsHeights && job.Settings.Machine.Height is not null);
        (_job, _posted, _deviation) = (job, posted, tolerances.Deviation);
        _cuts = [.. bridges.Count == 0 ? [JudgeOf([])] : (ITraceJudge[])[JudgeOf([]), JudgeOf(bridges)]];
        _length = reader.TellsTimes || isInSpace ? null : new LengthJudge(job.Toolpath, tolerances.Deviation, reader.Rounding > 0.0);
        _pace = reader.TellsTimes && machine.Height is null ? new PaceJudge() : null;
        Feeds = new FeedJudge(machine.FeedMmPerMinute, reader.TellsHeights ? machine.Height?.PlungeMmPerMinute : null);
        Terms = new TermsJudge(posted.Terms);
        ITraceJudge JudgeOf(IReadOnlyList<StrokeMove> besides) => isInSpace ? RunJudge.JudgeOf(job, besides) : RunJudge.PlanJudgeOf(job, besides, tolerances);
    }

    public FeedJudge Feeds { get; }

    public BlendJudge Blends { get; } = new();

    public TermsJudge Terms { get; }

    /// <summary>On the drawing, and where there are bridges on the drawing with them.</summary>
    public TraceVerdict[] Verdicts() => [.. _cuts.Select(judge => judge.Verdict())];

    /// <summary>What a reader needs to tell all of them.</summary>
    /// <param name="start">Where the machine stands when the program starts.</param>
    public ReplayRequest Request(CountsPoint start, TimeSpan expected, TimeSpan longest) =>
        new(_job.Settings.Machine, start, expected, longest, [.. _cuts, .. new ITraceJudge?[] { _length, _pace }.OfType<ITraceJudge>()])
        {
            Entry = _posted.Start ?? (_job.Toolpath.Strokes.Count > 0 ? _job.Toolpath.Strokes[0].Start : null),
            Feeds = Feeds,
            Blends = Blends,
            Terms = Terms,
            Pace = _pace,
            LongestJump = BridgedGaps.Widest(_job.Toolpath) + _deviation,
            IsLevel = IsLevel(),
        };

    /// <summary>What a program that was read to its end does otherwise than the job asks, wherever it cuts.</summary>
    public IReadOnlyList<Diagnostic> Findings() => [.. new[] { Feeds.Finding, Terms.Finding }.OfType<Diagnostic>()];

    /// <summary>What is wrong with a program that cuts the drawing and nothing else: some of it twice, or at other speeds.</summary>
    public Diagnostic? Behind(CountsPoint start, CancellationToken cancellation) => _length?.Finding ?? PaceFinding(start, cancellation);

    /// <summary>The times of the program are those of the job as the link can carry it, or as it is in one of its two styles: which of them it was posted
    /// in, its language does not say.</summary>
    private Diagnostic? PaceFinding(CountsPoint start, CancellationToken cancellation)
    {
        if (_pace is null) return null;
        var continuous = JobPreparation.PrepareUnlessCancelled(_job.Drawing, _job.Settings, MotionStyle.Continuous, cancellation).Motion.Program;
        IReadOnlyList<IReadOnlyList<PaceMove>> ways = [.. new[] { _posted.Fitted, continuous, _job.Motion.Program }.OfType<MotionProgram>().Select(program => JobPlan.Pace(program, start, _pace.Parts))];
        return ways.Count == 0 ? null : _pace.Finding(ways);
    }

    private bool IsLevel()
    {
        var heights = _job.Toolpath.Strokes.SelectMany(stroke => stroke.Moves).SelectMany(move => (double[])[move.StartZ, move.EndZ]).Distinct().Take(2).ToList();
        return heights.Count <= 1 && heights.TrueForAll(double.IsFinite);
    }
}
