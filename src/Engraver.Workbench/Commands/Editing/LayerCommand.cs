using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>LAYER: Makes and renames layers, sets the current one, switches them on, off, frozen, thawed, locked or plotted and colours them; only visible, thawed, plottable layers are cut.</summary>
internal sealed class LayerCommand : ICommand
{
    public CommandInfo Info { get; } = new("LAYER", CommandGroup.Ask);

    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("?", "Make", "Set", "Rename", "ON", "OFF", "Freeze", "Thaw", "LOck", "Unlock", "Plot", "Noplot", "Color");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var edit = new LayerEdit(context);
        while (await context.AskAsync(new ChoicePrompt(Wording.Get("Common.EnterOption")) { Options = s_options, EnterEnds = true }).ConfigureAwait(false) is Answer<string>.Chosen { Option: var option })
        {
            if (option == "?") context.SayResult(output => Write(edit, output));
            else if (option is "Make" or "Set" or "Rename") await NameAsync(context, edit, option).ConfigureAwait(false);
            else await SwitchAsync(context, edit.Layers, option).ConfigureAwait(false);
        }

        edit.Take(context);
    }

    private static async Task NameAsync(CommandContext context, LayerEdit edit, string option)
    {
        var instruction = option switch { "Make" => "Layer.NameToMake", "Set" => "Layer.NameToSet", _ => "Layer.OldName" };
        var name = await context.ValueAsync(new TextPrompt(Wording.Get(instruction)) { Default = edit.Current }).ConfigureAwait(false);
        if (option == "Make") edit.Make(name);
        else if (option == "Set") edit.Set(name);
        else edit.Rename(name, await context.ValueAsync(new TextPrompt(Wording.Get("Layer.NewName"))).ConfigureAwait(false));
        context.Say(Wording.Get("Layer.Current", edit.Current));
    }

    private static async Task SwitchAsync(CommandContext context, List<Layer> layers, string option)
    {
        DrawingColour? colour = option == "Color" ? await ColourAsync(context).ConfigureAwait(false) : null;
        var names = (await context.ValueAsync(new TextPrompt(Wording.Get("Layer.EnterLayerNamesSeparated"))).ConfigureAwait(false)).Split(',', StringSplitOptions.TrimEntries);
        var unknown = names.Where(name => name != "*" && !layers.Any(layer => Is(layer, name))).ToList();
        if (unknown.Count > 0) throw new CommandException(CommandFailure.Usage, Wording.Get("Layer.DrawingHasNoLayer", string.Join(", ", unknown.Select(name => $"'{name}'"))));
        for (var index = 0; index < layers.Count; index++)
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
        "LOck" => layer with { Locked = true },
        "Unlock" => layer with { Locked = false },
        "Plot" => layer with { Plot = true },
        _ => layer with { Plot = false },
    };

    private static void Write(LayerEdit edit, TextWriter output)
    {
        output.WriteLine(Wording.Get("Layer.Current", edit.Current));
        foreach (var layer in edit.Layers) output.WriteLine(Wording.Get("Layer.Row", Word("Cut", layer.CutByDefault), Word("On", layer.On), Word("Frozen", layer.Frozen), Word("Plotted", layer.Plot), Word("Locked", layer.Locked), ColourName.Format(layer.Colour), layer.Name));

        static string Word(string state, bool holds) => Wording.Get($"LayerState.{state}.{(holds ? "Yes" : "No")}");
    }
}
