using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands.View;

/// <summary>SHOW: Switches the overlays of the drawing on and off: contours, order, rapids, findings and the others.</summary>
internal sealed class ShowCommand : ICommand
{
    private static readonly IReadOnlyList<CanvasLayers> s_layers = [.. Enum.GetValues<CanvasLayers>().Where(layer => layer is not (CanvasLayers.None or CanvasLayers.All))];

    /// <summary>The capital letters are the abbreviations and must be unique.</summary>
    private static readonly IReadOnlyList<Keyword> s_options =
        Keyword.List("?", "Drawing", "Contours", "OrderNumbers", "StartPoints", "Rapids", "cutPath", "Findings", "Machine", "Engraved", "RECorded", "WorkOrigin", "Trajectories", "OPerations", "All", "None");

    public CommandInfo Info { get; } = new("SHOW", CommandGroup.View) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var option = await context.ChoiceAsync(Wording.Get("Show.EnterDisplayItem"), s_options, "?").ConfigureAwait(false);
        if (option == "?")
        {
            context.WriteResult(output => Write(context.View.Current.Shown, output));
            return;
        }

        if (option is "All" or "None")
        {
            Change(context, option == "All" ? CanvasLayers.All : CanvasLayers.Drawing);
            return;
        }

        var layer = Enum.Parse<CanvasLayers>(option, ignoreCase: true);
        var shown = context.View.Current.Shown;
        var mode = await context.ChoiceAsync(Wording.Get("Common.EnterMode"), Keyword.List("ON", "OFF"), shown.HasFlag(layer) ? "OFF" : "ON").ConfigureAwait(false);
        Change(context, mode == "ON" ? shown | layer : shown & ~layer);
    }

    private static void Change(CommandContext context, CanvasLayers shown) => context.View.Change(view => view with { Shown = shown });

    private static void Write(CanvasLayers shown, TextWriter output)
    {
        foreach (var layer in s_layers) output.WriteLine(Wording.Get(shown.HasFlag(layer) ? "Show.On" : "Show.Off", layer));
    }
}
