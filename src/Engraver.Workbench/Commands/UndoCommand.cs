using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>UNDO: Takes back a number of steps.</summary>
internal sealed class UndoCommand : ICommand
{
    public CommandInfo Info { get; } = new("UNDO", CommandGroup.File, "Takes back a number of steps.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var count = await context.ValueAsync(new NumberPrompt("Enter the number of operations to undo") { Default = "1", Least = 1, Most = 32767, Whole = true }).ConfigureAwait(false);
        for (var step = 0; step < count; step++)
        {
            if (context.Document.Undo() is not { } name)
            {
                context.Say("Everything has been undone.");
                return;
            }

            context.Say(name);
        }
    }
}
