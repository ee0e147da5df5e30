using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Posts;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Verification;

/// <summary>All judges of a program that is read back: positions, feeds, lengths, times and other content.</summary>
internal sealed class ReadBackJudges
{
    /// <summary>Added to the allowed deviation where a place is assigned to the strokes that pass it, mm.</summary>
    private const double NearStroke = 0.001;

    private readonly PreparedJob _job;
    private readonly PostParameters _posted;
    private readonly ITraceJudge[] _cuts;
    private readonly LengthJudge? _length;
    private readonly ScheduleJudge? _pace;
    private readonly OperationJudge? _operations;
    private readonly double _deviation;
    private readonly StrokeRequirements? _strokes;

    /// <param name="tolerances">Tolerances of the reader's format.</param>
    /// <param name="bridges">Lines across gaps within the join tolerance, which may be cut too.</param>
    public ReadBackJudges(PreparedJob job, PostParameters posted, IProgramReader reader, TraceTolerances tolerances, IReadOnlyList<StrokeMove> bridges)
    {
        var (machine, isInSpace) = (job.Settings.CuttingMachine, reader.ReportsHeights && job.Settings.CuttingMachine.Height is not null);
        (_job, _posted, _deviation) = (job, posted, tolerances.Deviation);
        var inSpace = RunJudge.Tolerances(job) with { CornerTolerance = tolerances.CornerTolerance };
        _cuts = [.. bridges.Count == 0 ? [JudgeOf([])] : (ITraceJudge[])[JudgeOf([]), JudgeOf(bridges)]];
        _operations = OperationJudge.Of(job, null, isInSpace ? inSpace : tolerances, isInSpace);
        if (job.Settings.Operations is { } plan && job.Sections is { Count: > 0 } sections) _strokes = new StrokeRequirements(job.Toolpath, new PostOperations(plan, sections), machine.FeedMmPerMinute, (2.0 * tolerances.Deviation) + NearStroke);
        _length = reader.ReportsTimes || (isInSpace && _strokes is null) ? null : new LengthJudge(job.Toolpath, tolerances.Deviation, reader.Rounding > 0.0, isWhole: _strokes is not null);
        _pace = reader.ReportsTimes && machine.Height is null ? new ScheduleJudge() : null;
        Feeds = new FeedJudge(machine.FeedMmPerMinute, reader.ReportsHeights ? machine.Height?.PlungeMmPerMinute : null);
        Terms = new RequirementsJudge(posted.Terms);
        ITraceJudge JudgeOf(IReadOnlyList<StrokeMove> besides) => isInSpace ? RunJudge.JudgeOf(job, besides, inSpace) : RunJudge.PlanJudgeOf(job, besides, tolerances);
    }

    public FeedJudge Feeds { get; }

    public BlendJudge Blends { get; } = new();

    public RequirementsJudge Terms { get; }

    /// <summary>Verdict for the drawing, and for the drawing with bridges if there are any.</summary>
    public TraceVerdict[] Verdicts() => [.. _cuts.Select(judge => judge.Verdict())];

    /// <summary>What was measured of the operations; empty without operations.</summary>
    public IReadOnlyList<MeasuredOperation> Operations() => _operations?.Measured() ?? [];

    /// <summary>Creates the request that reports to all judges.</summary>
    /// <param name="start">Machine position at the start of the program.</param>
    public ReplayRequest Request(CountsPoint start, TimeSpan expected, TimeSpan longest) =>
        new(_job.Settings.CuttingMachine, start, expected, longest, [.. _cuts, .. new ITraceJudge?[] { _length, _pace, _operations?.Judge }.OfType<ITraceJudge>()])
        {
            Entry = _posted.Start ?? (_job.Toolpath.Strokes.Count > 0 ? _job.Toolpath.Strokes[0].Start : null),
            Feeds = Feeds,
            Strokes = _strokes,
            Blends = Blends,
            Requirements = Terms,
            Schedule = _pace,
            LongestJump = BridgedGaps.Widest(_job.Toolpath) + _deviation,
            IsLevel = IsLevel(),
        };

    /// <summary>Differences from the job other than positions, for a program that was read to its end.</summary>
    public IReadOnlyList<Diagnostic> Findings() => [.. new[] { Feeds.Finding, Terms.Finding }.OfType<Diagnostic>()];

    /// <summary>Finding for a program that cuts exactly the drawing, but parts of it twice or at other speeds.</summary>
    public Diagnostic? ResidualFinding(CountsPoint start, CancellationToken cancellation) => _length?.Finding ?? PaceFinding(start, cancellation);

    /// <summary>Compares the times of the program with those of the job limited to the link, or of either motion style, because the program does not contain
    /// its style.</summary>
    private Diagnostic? PaceFinding(CountsPoint start, CancellationToken cancellation)
    {
        if (_pace is null) return null;
        var continuous = JobPreparation.PrepareUnlessCancelled(_job.Drawing, _job.Settings, MotionStyle.Continuous, cancellation).Motion.Program;
        IReadOnlyList<IReadOnlyList<ScheduledMove>> ways = [.. new[] { _posted.FittedProgram, continuous, _job.Motion.Program }.OfType<MotionProgram>().Select(program => JobPlan.Pace(program, start, _pace.Parts))];
        return ways.Count == 0 ? null : _pace.Finding(ways);
    }

    private bool IsLevel()
    {
        var heights = _job.Toolpath.Strokes.SelectMany(stroke => stroke.Moves).SelectMany(move => (double[])[move.StartZ, move.EndZ]).Distinct().Take(2).ToList();
        return heights.Count <= 1 && heights.TrueForAll(double.IsFinite);
    }
}
