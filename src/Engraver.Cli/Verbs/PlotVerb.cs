using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Core.Plots;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver plot</c>: the drawing, or the path over it, as SVG.</summary>
internal static class PlotVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var output = new Option<string>("-o", "--output") { Required = true, HelpName = "OUT.svg", Description = Wording.Get("Plot.FileWrite") };
        var what = new Option<string>("--what") { Description = Wording.Get("Plot.DrawingDrawnPathStrokes"), DefaultValueFactory = _ => "path" };
        what.AcceptOnlyFromAmong("drawing", "path");
        var command = new Command("plot", Wording.Get("Plot.DrawsPictureDrawingIts"));
        drawing.AddTo(command);
        command.Options.Add(output);
        command.Options.Add(what);
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            var plot = DrawingPlot.Create(read, settings, parsed.GetValue(what) == "drawing");
            if (!DrawingFile.IsUnreadable(read)) host.Write(parsed.GetValue(output), writer => SvgPlotWriter.Write(plot, writer));
            return Task.FromResult(host.Report(parsed, read.FileName, read.Diagnostics));
        });
        return command;
    }
}
