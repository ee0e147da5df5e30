using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Files;
using Engraver.Workbench.Plots;

namespace Engraver.Workbench.Commands.Files;

/// <summary>PLOTEXPORT: Writes the plots of the planned motion and of runs in the format given by the extension: .png or .svg picture, .csv values.</summary>
internal sealed class PlotExportCommand : ICommand
{
    private const int Width = 1600;

    /// <summary>Height of each of the stacked plots, pixels.</summary>
    private const int PanelHeight = 320;

    private static readonly IReadOnlyList<string> s_extensions = [".png", ".svg", ".csv"];

    public CommandInfo Info { get; } = new("PLOTEXPORT", CommandGroup.Output);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        await context.Derivation.ForCurrentAsync(cancellation).ConfigureAwait(false);
        var content = context.Plots.Content(context.Settings.Current, cancellation);
        if (content.Series.Count == 0) throw new CommandException(CommandFailure.Drawing, Wording.Get("PlotExport.Nothing"));
        var usual = context.PlotRenderer is null ? ".csv" : s_extensions[0];
        var request = new FileRequest("plot", true, s_extensions) { Suggested = context.PathBesideDrawing(".plot" + usual) };
        var name = await ReplacePrompt.AskAsync(context, Wording.Get("PlotExport.EnterFileName", string.Join(' ', s_extensions)), request).ConfigureAwait(false);
        Write(context, content, context.ResolveOutputPath(name), Path.GetExtension(name).ToLowerInvariant(), name);
        context.WriteMessage(Wording.Get("PlotExport.Written", name, content.Series.Count, content.Series.Sum(series => series.Motion.Count)), MessageKind.Result);
    }

    private static void Write(CommandContext context, PlotContent content, string path, string extension, string name)
    {
        switch (extension)
        {
            case ".csv":
                OutputFile.Write(path, output => PlotCsv.Write(content.Series, output));
                break;
            case ".png":
                OutputFile.WriteBytes(path, output => RendererOf(context, content, name).WritePng(content, Width, content.Panels.Count * PanelHeight, output));
                break;
            case ".svg":
                OutputFile.Write(path, output => RendererOf(context, content, name).WriteSvg(content, Width, content.Panels.Count * PanelHeight, output));
                break;
            default: throw new CommandException(CommandFailure.Usage, Wording.Get("PlotExport.UnknownExtension", name, string.Join(", ", s_extensions)));
        }
    }

    /// <exception cref="CommandException">No picture can be drawn here, or no plot is visible.</exception>
    private static IPlotRenderer RendererOf(CommandContext context, PlotContent content, string name)
    {
        if (context.PlotRenderer is not { } renderer) throw new CommandException(CommandFailure.Usage, Wording.Get("PlotExport.OnlyDesktop", name));
        return content.Panels.Count > 0 ? renderer : throw new CommandException(CommandFailure.Usage, Wording.Get("PlotExport.NoPanel", SystemVariables.PlotPanels));
    }
}
