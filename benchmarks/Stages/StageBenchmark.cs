using System.Globalization;
using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Posts;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;
using Engraver.Workbench.Verification;

namespace Engraver.Benchmarks.Stages;

/// <summary>Measures the stages of the main job on a seeded drawing of shuffled, randomly reversed lines that form closed polygons.</summary>
public static class StageBenchmark
{
    private const int Repetitions = 5;
    private const ulong Seed = 1;

    /// <summary>The measured run ends with the last stroke.</summary>
    private static readonly DrawingSettings s_settings = new() { Finish = FinishPlace.Stay };

    /// <summary>Runs everything once on a small drawing, so that the first row does not include the just-in-time compiler.</summary>
    public static Task WarmUpAsync(CancellationToken stop) => RunAsync(500, stop);

    /// <summary>One row for each stage.</summary>
    /// <param name="entities">Lines in the drawing, at least 1.</param>
    /// <exception cref="OperationCanceledException">Stopped by the operator.</exception>
    public static Task<IReadOnlyList<StageFigure>> RunAsync(int entities, CancellationToken stop) => MeasureAsync(entities, Drawing(entities), stop);

    /// <summary>The seeded drawing as DXF with six decimals, as CAD programs write it.</summary>
    private static byte[] Drawing(int entities)
    {
        var sheet = SeededPolygons.Lines(entities, shuffled: true, Seed)
            .Select(line => new DxfSheetEntity(Segment.FromLine(Place(line.FromX, line.FromY), Place(line.ToX, line.ToY)), SeededPolygons.Layers[line.Layer], null, 0, 0));
        using var bytes = new MemoryStream();
        using (var writer = new StreamWriter(bytes, Encoding.ASCII, leaveOpen: true))
        {
            DxfWriter.Write(new DxfSheet([.. SeededPolygons.Layers.Select((name, i) => new DxfSheetLayer(name, i + 1))], [.. sheet]), writer);
        }

        return bytes.ToArray();
    }

    private static Point2D Place(double x, double y) => new(Math.Round(x, 6), Math.Round(y, 6));

    private static async Task<IReadOnlyList<StageFigure>> MeasureAsync(int entities, byte[] bytes, CancellationToken stop)
    {
        var (read, drawing) = await StageClock.MeasureAsync(
            entities, "read", Repetitions, () => DxfReader.Read(bytes, "bench.dxf", new DxfReadOptions(), stop), _ => $"{bytes.Length / 1e6:0.0} MB").ConfigureAwait(false);
        var (stages, job) = await StagesAsync(entities, new DrawnJob(drawing, s_settings), stop).ConfigureAwait(false);
        var simulate = await SimulateAsync(entities, job, job.Motion.Program!, stop).ConfigureAwait(false);
        var verify = await VerifyAsync(entities, drawing, job, stop).ConfigureAwait(false);
        return [read, .. stages, simulate, verify];
    }

    /// <summary>Executes the stages up to the checked program and measures those that have a row.</summary>
    private static async Task<(IReadOnlyList<StageFigure> Rows, PreparedJob Job)> StagesAsync(int entities, DrawnJob job, CancellationToken stop)
    {
        var rows = new List<StageFigure>();
        foreach (var stage in JobStages.To<CheckedJob>())
        {
            var input = job;
            if (!stage.IsMeasured)
            {
                job = stage.Run(input, stop);
                continue;
            }

            (var figure, job) = await StageClock.MeasureAsync(entities, stage.Work, Repetitions, () => stage.Run(input, stop), stage.Figure).ConfigureAwait(false);
            rows.Add(figure);
        }

        return (rows, PreparedJob.From((CheckedJob)job));
    }

    /// <summary>Runs the job once on the simulated controller: it is by far the longest stage, and its result is also verified.</summary>
    private static async Task<StageFigure> SimulateAsync(int entities, PreparedJob job, MotionProgram program, CancellationToken stop)
    {
        var journal = Path.GetTempFileName();
        var options = new MachineRunOptions(new SimulatedAddress(double.PositiveInfinity), MachineFamilies.Default.DefaultStrategy) { JournalPath = journal };
        try
        {
            var (figure, report) = await StageClock.MeasureAsync(
                entities, "simulate and judge", 1, () => MachineRun.RunAsync(job, program, options, TimeProvider.System, progress: null, stop), (MachineRunReport _) => "").ConfigureAwait(false);
            return Judged(figure, report.Result.Seconds, report.Judgement.MaxDeviationMm, report.Judgement.MissingLengthMm);
        }
        finally
        {
            File.Delete(journal);
        }
    }

    /// <summary>Reads the posted program back in the simulator, without a host, and judges every sample; once, as the run.</summary>
    private static async Task<StageFigure> VerifyAsync(int entities, Drawing drawing, PreparedJob job, CancellationToken stop)
    {
        var entry = PostTable.ForMotion(MachineFamilies.Default, MotionStyle.Continuous)!;
        var program = ReadBackFile.FromText(PostedProgram.FromJob(job, entry.Post, PostedProgram.NoOptions).Text!);
        var replay = new LastReport();
        var (figure, report) = await StageClock.MeasureAsync(
            entities, "verify", 1, () => ProgramVerification.VerifyAsync(program, entry.Reader!, drawing, s_settings, replay, stop), (VerificationReport _) => "").ConfigureAwait(false);
        return Judged(figure, replay.Value.MachineTime.TotalSeconds, report.MaxDeviationMm, report.MissingLengthMm);
    }

    /// <param name="seconds">Machine time; divided by the processor time it is how many times faster than the machine the stage was.</param>
    private static StageFigure Judged(StageFigure figure, double seconds, double? worst, double? missing) => figure with
    {
        Note = string.Create(
            CultureInfo.InvariantCulture, $"{seconds:0} s of machine time, {seconds / figure.CpuSeconds:0} times real time, worst {worst:0.0000} mm, missing {missing:0.###} mm"),
    };

    /// <summary>Keeps the last progress of the replay. It is reported on the thread of the replay, so that it is complete when the replay has
    /// ended.</summary>
    private sealed class LastReport : IProgress<ReplayProgress>
    {
        public ReplayProgress Value { get; private set; }

        public void Report(ReplayProgress value) => Value = value;
    }
}
