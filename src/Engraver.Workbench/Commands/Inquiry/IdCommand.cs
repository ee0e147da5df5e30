using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Inquiry;

/// <summary>ID: Shows the coordinates of a point and makes it the last point (@).</summary>
internal sealed class IdCommand : ICommand
{
    public CommandInfo Info { get; } = new("ID", CommandGroup.Ask) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var point = await context.ValueAsync(new PointPrompt(Wording.Get("Dist.SpecifyPoint"))).ConfigureAwait(false);
        context.WriteMessage(Wording.Get("Dist.Coordinates", context.Precision.FormatLength(point.X), context.Precision.FormatLength(point.Y)), MessageKind.Result);
    }
}
