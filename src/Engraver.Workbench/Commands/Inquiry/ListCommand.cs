using Engraver.Workbench.Reports;

namespace Engraver.Workbench.Commands.Inquiry;

/// <summary>LIST: Lists the selected objects with handle, layer, coordinates and length.</summary>
internal sealed class ListCommand : ICommand
{
    public CommandInfo Info { get; } = new("LIST", CommandGroup.Ask) { IsAllowedDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetAsync(context, takesTexts: true).ConfigureAwait(false);
        context.WriteResult(output => EntityText.Write(context.Drawing, selected, context.Precision, output));
    }
}
