using System.Globalization;
using Engraver.Core.Dxf;
using Engraver.Core.EntityTables;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Jobs;
using Engraver.Galil.Links;
using Engraver.Galil.Programs;
using Engraver.Samples;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Settings;

namespace Engraver.Benchmarks;

/// <summary>The stages of the main job on a seeded drawing of shuffled, randomly reversed lines that form closed polygons.</summary>
internal static class StageBenchmark
{
    private const int Repetitions = 5;
    private static readonly DrawingSettings s_settings = new();

    /// <summary>Runs everything once on a small drawing, so that the first row does not pay for the just-in-time compiler.</summary>
    public static Task WarmUpAsync(CancellationToken stop) => RunAsync(500, stop);

    public static async Task<IReadOnlyList<StageFigure>> RunAsync(int entities, CancellationToken stop)
    {
        var file = Path.Combine(Path.GetTempPath(), string.Create(CultureInfo.InvariantCulture, $"engraver-bench-{Environment.ProcessId}-{entities}.dxf"));
        try
        {
            BenchmarkRequest.From(["--lines", entities.ToString(CultureInfo.InvariantCulture), file, "--shuffle"])!.Write();
            return await MeasureAsync(entities, await File.ReadAllBytesAsync(file, stop).ConfigureAwait(false), stop).ConfigureAwait(false);
        }
        finally
        {
            File.Delete(file);
        }
    }

    private static async Task<IReadOnlyList<StageFigure>> MeasureAsync(int entities, byte[] bytes, CancellationToken stop)
    {
        var (read, drawing) = await StageClock.MeasureAsync(
            entities, "read", Repetitions, () => DxfReader.Read(bytes, "bench.dxf", new DxfReadOptions(), stop), _ => $"{bytes.Length / 1e6:0.0} MB").ConfigureAwait(false);
        var (table, analysed) = await StageClock.MeasureAsync(
            entities, "table and analysis", Repetitions, () => JobPreparation.Analyse(drawing, s_settings), rows => $"{rows.Count} rows").ConfigureAwait(false);
        var options = JobPreparation.SequencingFor(drawing, s_settings);
        var (chain, chained) = await StageClock.MeasureAsync(
            entities, "chain", Repetitions, () => Sequencer.Chain(analysed, drawing, options), found => $"{found.Chain.Contours.Count} contours").ConfigureAwait(false);
        var (order, sequence) = await StageClock.MeasureAsync(
            entities, "order", Repetitions, () => Sequencer.Order(chained, options), found => $"travel {found.Travel / 1000:0.0} m").ConfigureAwait(false);
        var toolpath = ToolpathPlanner.Plan(sequence, s_settings.Start, s_settings.MaxErrorMm);
        var (generate, motion) = await StageClock.MeasureAsync(
            entities, "generate", Repetitions, () => MotionProgramGenerator.Generate(toolpath, s_settings.Machine, s_settings.MaxErrorMm, drawing.SourceOf), made => $"{made.Program!.SegmentCount} segments").ConfigureAwait(false);
        var job = new PreparedJob(drawing, s_settings, analysed, sequence, toolpath, motion);
        var simulate = await SimulateAsync(entities, job, motion.Program!, stop).ConfigureAwait(false);
        return [read, table, chain, order, generate, simulate];
    }

    /// <summary>Once: it is the longest stage by far and its result is a judgement, not only a time.</summary>
    private static async Task<StageFigure> SimulateAsync(int entities, PreparedJob job, MotionProgram program, CancellationToken stop)
    {
        var journal = Path.GetTempFileName();
        var options = new MachineRunOptions(new SimulatedAddress(double.PositiveInfinity), JobMode.Stream) { JournalPath = journal };
        try
        {
            var (figure, _) = await StageClock.MeasureAsync(
                entities, "simulate and judge", 1, () => MachineRun.RunAsync(job, program, options, TimeProvider.System, progress: null, stop), Note).ConfigureAwait(false);
            return figure;
        }
        finally
        {
            File.Delete(journal);
        }
    }

    private static string Note(MachineRunReport report) => string.Create(
        CultureInfo.InvariantCulture,
        $"{report.Result.Seconds:0} s of machine time, worst {report.Judgement.MaxDeviationMm:0.0000} mm, missing {report.Judgement.MissingLengthMm:0.###} mm");
}
