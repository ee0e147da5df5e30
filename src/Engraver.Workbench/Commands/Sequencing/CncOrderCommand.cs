using Engraver.Core.Sequencing.Ordering;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Sequencing;

/// <summary>CNCORDER: Chooses the order of strokes: as drawn or nearest first; an inner one always comes before the one around it.</summary>
internal sealed class CncOrderCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCORDER", CommandGroup.Sequence);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var options = Keyword.List([.. Enum.GetNames<StrokeOrder>()]);
        var chosen = await context.ChoiceAsync(Wording.Get("CncOrder.EnterOrder"), options, context.Document.Current.Settings.Order.ToString()).ConfigureAwait(false);
        var state = context.Document.Current;
        context.Take(state with { Settings = state.Settings with { Order = Enum.Parse<StrokeOrder>(chosen) } });
    }
}
