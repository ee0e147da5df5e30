using Engraver.Core.Machines;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>Checks a run by the record of the simulator.</summary>
internal static class CutRecord
{
    /// <summary>Every sample with the tool on is within a count of the drawing, and the whole path was passed with the tool on.</summary>
    public static void AssertWholePathWasCut(SimulatedBench bench, MotionProgram program)
    {
        var cutting = AssertNothingElseWasCut(bench, program);
        var length = cutting.Zip(cutting.Skip(1)).Where(pair => pair.Second.Sample == pair.First.Sample + 1)
            .Sum(pair => Math.Sqrt(Math.Pow(pair.Second.A - pair.First.A, 2) + Math.Pow(pair.Second.B - pair.First.B, 2)));
        Assert.InRange(length, 0.99 * program.Strokes.Sum(stroke => stroke.Sequences.Sum(sequence => sequence.Length)), double.MaxValue);
    }

    public static IReadOnlyList<MotionSample> AssertNothingElseWasCut(SimulatedBench bench, MotionProgram program)
    {
        var path = new EngravedPath(program);
        var cutting = bench.Controller.Record.Snapshot().Where(sample => sample.Outputs != 0).ToList();
        Assert.All(cutting, sample => Assert.InRange(path.DistanceTo(sample.A, sample.B), 0, 1.0));
        return cutting;
    }

    /// <summary>After <paramref name="sample"/> the tool is off within <paramref name="toolSeconds"/> and the machine is at rest within
    /// <paramref name="restSeconds"/>, controller time.</summary>
    public static void AssertSafeAfter(SimulatedBench bench, long sample, double toolSeconds, double restSeconds)
    {
        var record = bench.Controller.Record.Snapshot();
        Assert.Equal(0, record[^1].Outputs);
        Assert.InRange(record.LastOrDefault(row => row.Outputs != 0).Sample, 0, sample + (toolSeconds * 1000));
        var lastMove = record.Zip(record.Skip(1)).LastOrDefault(pair => pair.First.A != pair.Second.A || pair.First.B != pair.Second.B).Second;
        Assert.InRange(lastMove.Sample, 0, sample + (restSeconds * 1000));
        Assert.False(bench.Controller.Status.IsMoving);
    }
}
