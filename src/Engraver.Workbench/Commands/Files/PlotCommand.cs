using Engraver.Core.Plots;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Trajectories;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Files;

/// <summary>PLOT: Plots the drawing, optionally with the path, as SVG.</summary>
internal sealed class PlotCommand : ICommand
{
    public CommandInfo Info { get; } = new("PLOT", CommandGroup.Output);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var what = await context.ChoiceAsync(Wording.Get("Plot.EnterContent"), Keyword.List("Drawing", "Path", "Trajectory"), context.LastValue("PLOT", "Path")).ConfigureAwait(false);
        context.Remember("PLOT", what);
        var state = context.Document.Current;
        var plot = what == "Trajectory" ? DrawingPlot.OfTrajectories(drawing, state.Settings, TrajectorySelection.All(context)).Plot : DrawingPlot.Create(drawing, state.Settings, asDrawn: what == "Drawing", context.PlateValues);
        await ResultFile.WriteAsync(context, "plot", ".svg", output => SvgPlotWriter.Write(plot, output)).ConfigureAwait(false);
    }
}
