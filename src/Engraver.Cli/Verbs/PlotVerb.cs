using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Verbs.Plates;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Languages;
using Engraver.Core.Plots;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver plot</c>: the drawing, optionally with the path, as SVG.</summary>
internal static class PlotVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var output = new Option<string>("-o", "--output") { Required = true, HelpName = "OUT.svg", Description = Wording.Get("Plot.Output") };
        var what = new Option<string>("--what") { Description = Wording.Get("Plot.What"), DefaultValueFactory = _ => "path" };
        what.AcceptOnlyFromAmong("drawing", "path", "deviation", "following", "speed", "trajectory");
        var journal = new Option<string?>("--journal") { HelpName = "FILE", Description = Wording.Get("Plot.Journal") };
        var series = new SeriesOptions();
        var command = new Command("plot", Wording.Get("Plot.Summary"));
        drawing.AddTo(command);
        series.AddTo(command, withFixtures: false);
        command.Options.Add(output);
        command.Options.Add(what);
        command.Options.Add(journal);
        command.SetAction(async (parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            VerbHost.RejectSameFile(drawing.File(parsed), parsed.GetValue(output));
            OutputFormat.Check(parsed.GetValue(output), ".svg");
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            var findings = DrawingFile.IsUnreadable(read) ? [] : JobPreparation.To<LetteredJob>(read, settings).Findings;
            if (settings.Operations is not null && JobPreparation.To<OrderedJob>(read, settings) is { OperationFaults: { Count: > 0 } faults } refused) return host.Report(parsed, read.FileName, [.. read.Diagnostics, .. refused.Findings, .. faults]);
            if (settings.Operations is not null && !DrawingFile.IsUnreadable(read)) findings = JobPreparation.To<OrderedJob>(read, settings).Findings;
            var plates = series.Requested(parsed) is null || DrawingFile.IsUnreadable(read) ? [] : await PlatesAsync(host, parsed, series, read, settings, stop).ConfigureAwait(false);
            if (plates is null) return ExitCode.DrawingError;
            var plot = parsed.GetValue(what) switch
            {
                "path" or "drawing" when plates.Count > 0 => DrawingPlot.OfPlates(read, settings, parsed.GetValue(what) == "drawing", plates),
                "trajectory" => Trajectories(DrawingPlot.OfTrajectories(read, settings, null)),
                "deviation" => OfRun(read, settings, RunMeasure.Deviation, parsed.GetValue(journal)),
                "following" => OfRun(read, settings, RunMeasure.Following, parsed.GetValue(journal)),
                "speed" => OfRun(read, settings, RunMeasure.Speed, parsed.GetValue(journal)),
                var chosen => DrawingPlot.Create(read, settings, chosen == "drawing"),
            };
            if (!DrawingFile.IsUnreadable(read)) host.Write(parsed.GetValue(output), writer => SvgPlotWriter.Write(plot, writer));
            return host.Report(parsed, read.FileName, [.. read.Diagnostics, .. findings]);

            PlotModel Trajectories((PlotModel Plot, IReadOnlyList<Diagnostic> Findings) made)
            {
                findings = [.. findings, .. made.Findings];
                return made.Plot;
            }
        });
        return command;
    }

    /// <returns>The plates of the series; null if a finding about their values is an error.</returns>
    /// <exception cref="UsageException">Options that cannot be used together, or counters that give no number.</exception>
    private static async Task<IReadOnlyList<Plate>?> PlatesAsync(VerbHost host, ParseResult parsed, SeriesOptions options, Drawing drawing, DrawingSettings settings, CancellationToken stop)
    {
        try
        {
            var (plan, findings) = await SeriesPlan.ReadAsync(parsed, options, drawing, JobPreparation.FieldsOf(drawing, settings), isDryRun: true, null, stop).ConfigureAwait(false);
            var code = host.Report(parsed, options.CsvFile(parsed) ?? drawing.FileName, [.. findings, .. plan?.Findings ?? []]);
            return code == ExitCode.Done ? plan?.Plates : null;
        }
        catch (CounterException refused) when (refused.Finding is { } finding)
        {
            host.Report(parsed, drawing.FileName, [finding]);
            return null;
        }
    }

    /// <summary>From the trace saved beside a journal; by default beside that of the last run of the drawing.</summary>
    private static PlotModel OfRun(Drawing drawing, DrawingSettings settings, RunMeasure measure, string? journal)
    {
        var kept = journal ?? TraceFile.LastOf(drawing.FileName) ?? throw new UsageException(Wording.Get("Plot.NoRun", Path.GetFileName(drawing.FileName)));
        try
        {
            return DrawingPlot.OfRun(drawing, settings, TraceFile.Read(kept), measure);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or FormatException)
        {
            throw new UsageException(Wording.Get("Plot.Unreadable", TraceFile.PathOf(kept), SystemErrorText.FromException(unreadable)), unreadable);
        }
    }
}
