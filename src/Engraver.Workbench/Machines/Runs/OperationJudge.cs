using Engraver.Core.Operations;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Compares the passes of the operations of a job with their nominal paths.</summary>
internal sealed class OperationJudge
{
    /// <summary>A place within this distance of a stroke is on it, mm.</summary>
    private const double Near = 0.02;

    private readonly List<(Operation Operation, int Pass)> _passes = [];
    private readonly PassJudge _judge;
    private readonly bool _hasHeights;

    private OperationJudge(PreparedJob job, (int First, int End) range, TraceTolerances tolerances, bool hasHeights)
    {
        _hasHeights = hasHeights;
        var (moves, indices, strokes, row) = (StrokeMove.AllOf(job.Analysed), new Dictionary<(string Id, int Pass), int>(), new List<JudgedStroke>(), 0);
        for (var stroke = 0; stroke < range.End; stroke++)
        {
            var (pass, from) = (job.Passes[stroke], row);
            row += job.Sequence.Strokes[stroke].Moves.Count;
            if (stroke < range.First) continue;
            if (!indices.TryGetValue((pass.Operation.Id, pass.Pass), out var index))
            {
                indices[(pass.Operation.Id, pass.Pass)] = index = _passes.Count;
                _passes.Add((pass.Operation, pass.Pass));
            }

            strokes.Add(new JudgedStroke(index, moves[from..row]) { Outputs = job.Settings.CuttingMachine.OperationOutputs, OutputsOn = OperationPlan.OutputsOf(pass.Operation, job.Settings.Machine) });
        }

        _judge = new PassJudge(strokes, own => hasHeights ? new HeightJudge(own, 0.0, null, tolerances) : new TraceJudge([.. own.Select(move => move.Segment)], tolerances), Math.Max(Near, 2.0 * tolerances.Coverage));
    }

    public ITraceJudge Judge => _judge;

    /// <param name="section">The strokes of one tool; null for all.</param>
    /// <param name="hasHeights">The samples have the heights of the tool.</param>
    /// <returns>Null for a job without operations.</returns>
    public static OperationJudge? Of(PreparedJob job, ToolSection? section, TraceTolerances tolerances, bool hasHeights)
    {
        var range = section is null ? (First: 0, End: job.Passes.Count) : (First: section.FirstStroke, End: section.EndStroke);
        return range.End == range.First || job.Passes.Count != job.Sequence.Strokes.Count ? null : new OperationJudge(job, range, tolerances, hasHeights);
    }

    /// <summary>The operations of which something was cut, in the order of their first stroke.</summary>
    public IReadOnlyList<MeasuredOperation> Measured() =>
        [.. _passes.Zip(_judge.Measured()).GroupBy(one => one.First.Operation.Id).Select(one => MeasuredOperation.Of(one.First().First.Operation, [.. one.OrderBy(pass => pass.First.Pass).Select(pass => pass.Second)], _hasHeights)).OfType<MeasuredOperation>()];
}
