using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>LAYER: Switches layers on, off, frozen, thawed or plotted and colours them; only visible, thawed, plottable layers are cut.</summary>
internal sealed class LayerCommand : ICommand
{
    public CommandInfo Info { get; } = new("LAYER", CommandGroup.Ask);

    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("?", "ON", "OFF", "Freeze", "Thaw", "Plot", "Noplot", "Color");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var layers = context.Drawing.Layers.ToArray();
        while (await context.AskAsync(new ChoicePrompt(Wording.Get("Common.EnterOption")) { Options = s_options, EnterEnds = true }).ConfigureAwait(false) is Answer<string>.Chosen { Option: var option })
        {
            if (option == "?") context.SayResult(output => Write(layers, output));
            else await SwitchAsync(context, layers, option).ConfigureAwait(false);
        }

        if (layers.SequenceEqual(context.Drawing.Layers)) return;
        var state = context.Document.Current;
        context.Take(state with { Drawing = context.Drawing with { Layers = layers } });
    }

    private static async Task SwitchAsync(CommandContext context, Layer[] layers, string option)
    {
        DrawingColour? colour = option == "Color" ? await ColourAsync(context).ConfigureAwait(false) : null;
        var names = (await context.ValueAsync(new TextPrompt(Wording.Get("Layer.EnterLayerNamesSeparated"))).ConfigureAwait(false)).Split(',', StringSplitOptions.TrimEntries);
        var unknown = names.Where(name => name != "*" && !layers.Any(layer => Is(layer, name))).ToList();
        if (unknown.Count > 0) throw new CommandException(CommandFailure.Usage, Wording.Get("Layer.DrawingHasNoLayer", string.Join(", ", unknown.Select(name => $"'{name}'"))));
        for (var index = 0; index < layers.Length; index++)
        {
            if (names.Any(name => name == "*" || Is(layers[index], name))) layers[index] = colour is { } chosen ? layers[index] with { Colour = chosen } : Switched(layers[index], option);
        }
    }

    private static async Task<DrawingColour> ColourAsync(CommandContext context)
    {
        var typed = await context.ValueAsync(new TextPrompt(Wording.Get("Layer.NewColorNameOr"))).ConfigureAwait(false);
        return ColourName.Parse(typed) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("Layer.NoColorNameOne", typed, string.Join(", ", ColourName.Known)));
    }

    private static bool Is(Layer layer, string name) => layer.Name.Equals(name, StringComparison.OrdinalIgnoreCase);

    private static Layer Switched(Layer layer, string option) => option switch
    {
        "ON" => layer with { On = true },
        "OFF" => layer with { On = false },
        "Freeze" => layer with { Frozen = true },
        "Thaw" => layer with { Frozen = false },
        "Plot" => layer with { Plot = true },
        _ => layer with { Plot = false },
    };

    private static void Write(IEnumerable<Layer> layers, TextWriter output)
    {
        foreach (var layer in layers) output.WriteLine(Wording.Get("Layer.Row", Word("Cut", layer.CutByDefault), Word("On", layer.On), Word("Frozen", layer.Frozen), Word("Plotted", layer.Plot), ColourName.Format(layer.Colour), layer.Name));

        static string Word(string state, bool holds) => Wording.Get($"LayerState.{state}.{(holds ? "Yes" : "No")}");
    }
}
