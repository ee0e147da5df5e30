using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Properties;

/// <summary>CHPROP: Changes a property of objects: layer, colour, coordinates, radius, angles. The selection is kept.</summary>
internal sealed class ChPropCommand : ICommand
{
    public CommandInfo Info { get; } = new("CHPROP", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetForEditAsync(context, takesTexts: true).ConfigureAwait(false);
        var (drawing, figures) = (context.Drawing, context.Precision);
        var values = ObjectProperties.Of(drawing, selected, figures).Where(value => value.IsEditable).ToList();
        var name = await context.ChoiceAsync(Wording.Get("ChProp.EnterProperty"), Keyword.List([.. values.Select(value => value.Property.Name)]), null).ConfigureAwait(false);
        var (property, shown, _, _) = values.First(value => value.Property.Name == name);
        var typed = await context.ValueAsync(new TextPrompt(Wording.Get("ChProp.EnterValue", property.Title, shown))).ConfigureAwait(false);
        var edited = PropertyEdit.Apply(drawing, selected, property, typed, figures);
        context.Commit(context.Document.Current with { Drawing = edited, Previous = selected });
    }
}
