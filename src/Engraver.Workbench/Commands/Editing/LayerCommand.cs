using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>LAYER: Creates and renames layers, sets the current one, switches them on, off, frozen, thawed, locked or plotted and colours them; only visible,
/// thawed, plottable layers are cut.</summary>
internal sealed class LayerCommand : ICommand
{
    /// <summary>Wildcard for all layers.</summary>
    private const string AllLayers = "*";

    public CommandInfo Info { get; } = new("LAYER", CommandGroup.Ask);

    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("?", "Make", "Set", "Rename", "ON", "OFF", "Freeze", "Thaw", "LOck", "Unlock", "Plot", "Noplot", "Color");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var edit = new LayerEdit(context);
        while (await context.AskAsync(new ChoicePrompt(Wording.Get("Common.EnterOption")) { Options = s_options, EnterEnds = true }).ConfigureAwait(false) is Answer<string>.SelectedOption { Option: var option })
        {
            if (option == "?") context.WriteResult(output => Write(edit, output));
            else if (option is "Make" or "Set" or "Rename") await NameAsync(context, edit, option).ConfigureAwait(false);
            else await SwitchAsync(context, edit, option).ConfigureAwait(false);
        }

        edit.Commit(context);
    }

    private static async Task NameAsync(CommandContext context, LayerEdit edit, string option)
    {
        switch (option)
        {
            case "Make":
                edit.Create(await AskAsync("Layer.NameToMake", edit.CreateError, edit.Current).ConfigureAwait(false));
                break;
            case "Set":
                edit.SetCurrent(await AskAsync("Layer.NameToSet", edit.SetCurrentError, edit.Current).ConfigureAwait(false));
                break;
            case var _ when edit.Layers.All(layer => edit.RenameSourceError(layer.Name) is not null):
                context.WriteMessage(edit.RenameSourceError(edit.Current)!, MessageKind.Warning);
                break;
            default:
                var name = await AskAsync("Layer.OldName", edit.RenameSourceError, edit.RenameSourceError(edit.Current) is null ? edit.Current : null).ConfigureAwait(false);
                edit.Rename(name, await AskAsync("Layer.NewName", to => edit.RenameTargetError(name, to)).ConfigureAwait(false));
                break;
        }

        context.WriteMessage(Wording.Get("Layer.Current", edit.Current));

        Task<string> AskAsync(string instruction, Func<string, string?> refusal, string? standard = null) =>
            context.ValueAsync(new TextPrompt(Wording.Get(instruction)) { Default = standard, Validate = refusal });
    }

    private static async Task SwitchAsync(CommandContext context, LayerEdit edit, string option)
    {
        DrawingColour? colour = option == "Color" ? await ColourAsync(context).ConfigureAwait(false) : null;
        var prompt = new TextPrompt(Wording.Get("Layer.EnterNames")) { Validate = typed => edit.UnknownLayerError(NamesIn(edit, typed).Where(name => name != AllLayers)) };
        var names = NamesIn(edit, await context.ValueAsync(prompt).ConfigureAwait(false));
        edit.Change(layer => names.Any(name => name == AllLayers || LayerEdit.IsNamed(layer, name)), layer => colour is { } chosen ? layer with { Colour = chosen } : Switched(layer, option));
    }

    /// <summary>Splits the names at commas, unless the whole text is the name of an existing layer (other programs allow commas).</summary>
    private static string[] NamesIn(LayerEdit edit, string typed) => edit.Layers.Any(layer => LayerEdit.IsNamed(layer, typed)) ? [typed] : typed.Split(',', StringSplitOptions.TrimEntries);

    private static async Task<DrawingColour> ColourAsync(CommandContext context)
    {
        var prompt = new TextPrompt(Wording.Get("Layer.EnterColor"))
        {
            Validate = typed => ColourName.Parse(typed) is null ? Wording.Get("Layer.NotAColour", typed, string.Join(", ", ColourName.Known)) : null,
        };
        return ColourName.Parse(await context.ValueAsync(prompt).ConfigureAwait(false))!.Value;
    }

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
