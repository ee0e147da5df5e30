using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>CLAYER: The layer on which new objects are drawn. It goes with the document, so that undoing brings it back.</summary>
internal sealed class CurrentLayerCommand : ISettingCommand
{
    public CommandInfo Info { get; } = new("CLAYER", CommandGroup.Drawing);

    public string ValueText(CommandContext context) => context.Document.Current.CurrentLayer;

    /// <exception cref="CommandException">The drawing has no such layer, or it is frozen.</exception>
    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var name = await context.ValueAsync(new TextPrompt(Wording.Get("Settings.EnterNewValue", Info.Name)) { Default = ValueText(context) }).ConfigureAwait(false);
        var state = context.Document.Current;
        if (CurrentLayer.IndexOf(context.Drawing, name) is not { } index) throw new CommandException(CommandFailure.Usage, Wording.Get("Layer.NotFound", $"'{name}'"));
        var layer = context.Drawing.Layers[index];
        if (layer.Frozen) throw new CommandException(CommandFailure.Usage, Wording.Get("Layer.FrozenNotCurrent", layer.Name));
        context.Commit(state with { CurrentLayer = layer.Name });
    }
}
