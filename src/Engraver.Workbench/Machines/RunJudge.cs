using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;
using Engraver.Galil.Jobs;
using Engraver.Galil.Profiles;
using Engraver.Galil.Programs;
using Engraver.Simulator;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines;

/// <summary>Holds what the motors did against the drawing. It never looks at our own plan of the motion, only at what the controller or the simulator's record says.</summary>
public static class RunJudge
{
    /// <summary>Judges by the record of a simulated controller: every motor sample counts.</summary>
    /// <param name="frameX">Counts of the controller at the drawing's zero, axis A.</param>
    /// <param name="frameY">The same, axis B.</param>
    public static RunJudgement ByRecord(PreparedJob job, IReadOnlyList<MotionSample> record, long frameX, long frameY)
    {
        var found = Compare(job, record, frameX, frameY);
        return new RunJudgement(found.CuttingSamples == 0 ? null : found.MaxDeviation, found.MissingLength, "record") { DeviationAt = found.DeviationAt?.Place, MissingAt = found.MissingAt };
    }

    /// <summary>Holds a record against the drawing, both ways.</summary>
    /// <param name="frameX">Counts of the controller at the drawing's zero, axis A.</param>
    /// <param name="frameY">The same, axis B.</param>
    /// <param name="bridges">Lines that may be cut besides; what is missing is then not to be asked of the verdict.</param>
    public static TraceVerdict Compare(PreparedJob job, IReadOnlyList<MotionSample> record, long frameX, long frameY, IReadOnlyList<ToolpathMove>? bridges = null)
    {
        var profile = job.Settings.Machine;
        var toolBit = 1 << (profile.ToolOutput - 1);
        var trace = new TraceSample[record.Count];
        for (var i = 0; i < trace.Length; i++)
        {
            var sample = record[i];
            trace[i] = Sample(profile, sample.Seconds, sample.A - frameX, sample.B - frameY, (sample.Outputs & toolBit) != 0);
        }

        return TraceComparison.Compare([.. job.Analysed.ToSegments(), .. (bridges ?? []).Select(bridge => bridge.Segment)], trace, Tolerances(job));
    }

    /// <summary>Judges by positions polled during a run on a real link, and by the segments that the controller counted as executed; the one under way counts up to the last position known on it.</summary>
    public static RunJudgement ByPolling(PreparedJob job, MotionProgram program, JobResult result)
    {
        var profile = job.Settings.Machine;
        var trace = result.PolledTrace.Select(point => Sample(profile, point.Seconds, point.X, point.Y, point.ToolOn)).ToArray();
        if (!trace.Any(sample => sample.Cutting)) return RunJudgement.Unknown;
        var found = TraceComparison.Compare(job.Analysed.ToSegments(), trace, Tolerances(job));
        var planned = program.Strokes.Sum(stroke => stroke.Sequences.Sum(sequence => sequence.Length));
        var tolerances = Tolerances(job);
        var cut = result.LengthByStroke.Sum() + UnfinishedSegment.CutLength(program, result, tolerances.Deviation / tolerances.Count);
        var missing = Math.Max(0.0, planned - cut) / Math.Max(Math.Abs(profile.CountsPerMillimetreX), Math.Abs(profile.CountsPerMillimetreY));
        return new RunJudgement(found.MaxDeviation, missing, "polled") { DeviationAt = found.DeviationAt?.Place };
    }

    /// <summary>What a faithful run of the job may differ by.</summary>
    public static TraceTolerances Tolerances(PreparedJob job) => TraceTolerances.Default with
    {
        Count = 1.0 / Math.Min(Math.Abs(job.Settings.Machine.CountsPerMillimetreX), Math.Abs(job.Settings.Machine.CountsPerMillimetreY)),
        MaxError = job.Settings.MaxErrorMm,
    };

    private static TraceSample Sample(MachineProfile profile, double seconds, long x, long y, bool cutting) =>
        new(seconds, x / profile.CountsPerMillimetreX, y / profile.CountsPerMillimetreY, cutting);
}
