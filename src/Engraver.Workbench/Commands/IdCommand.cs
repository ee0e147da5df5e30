using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>ID: Says the coordinates of a point and makes it the last point (@).</summary>
internal sealed class IdCommand : ICommand
{
    public CommandInfo Info { get; } = new("ID", CommandGroup.Ask, "Says the coordinates of a point and makes it the last point (@).") { Transparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var point = await context.ValueAsync(new PointPrompt("Specify point")).ConfigureAwait(false);
        context.Say($"X = {NumberPrompt.Show(point.X)}     Y = {NumberPrompt.Show(point.Y)}", MessageKind.Result);
    }
}
