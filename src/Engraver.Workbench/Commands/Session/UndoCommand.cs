using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Session;

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

/// <summary>REDO: Takes the step again that was undone last.</summary>
internal sealed class RedoCommand : ICommand
{
    public CommandInfo Info { get; } = new("REDO", CommandGroup.File, "Takes the step again that was undone last.");

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.Say(context.Document.Redo() ?? "Everything has been redone.");
        return Task.CompletedTask;
    }
}

/// <summary>U: Takes back the last step.</summary>
internal sealed class UCommand : ICommand
{
    public CommandInfo Info { get; } = new("U", CommandGroup.File, "Takes back the last step.");

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.Say(context.Document.Undo() ?? "Everything has been undone.");
        return Task.CompletedTask;
    }
}
