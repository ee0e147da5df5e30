using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Core.Drawings;
using Engraver.Core.Plots;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver plot</c>: the drawing, or the path over it, as SVG.</summary>
internal static class PlotVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var output = new Option<string>("-o", "--output") { Required = true, HelpName = "OUT.svg", Description = "File to write." };
        var what = new Option<string>("--what") { Description = "drawing: as drawn; path: strokes in cutting order, directions, rapids.", DefaultValueFactory = _ => "path" };
        what.AcceptOnlyFromAmong("drawing", "path");
        var command = new Command("plot", "Draws a picture of the drawing and its path.");
        drawing.AddTo(command);
        command.Options.Add(output);
        command.Options.Add(what);
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var read = DrawingFile.Open(drawing.File(parsed), settings.Unit, stop);
            var plot = Model(read, settings, parsed.GetValue(what) == "drawing");
            host.Write(parsed.GetValue(output), writer => SvgPlotWriter.Write(plot, writer));
            return Task.FromResult(host.Report(parsed, read.FileName, read.Diagnostics));
        });
        return command;
    }

    private static PlotModel Model(Drawing read, DrawingSettings settings, bool asDrawn)
    {
        var title = Path.GetFileName(read.FileName);
        var analysed = JobPreparation.Analyse(read, settings);
        return asDrawn
            ? PlotModel.OfDrawing(analysed, title)
            : PlotModel.OfPath(ToolpathPlanner.Plan(JobPreparation.Sequence(read, analysed, settings), settings.Start, settings.MaxErrorMm), title);
    }
}
