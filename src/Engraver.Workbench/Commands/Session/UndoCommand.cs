using Engraver.Core.Languages;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Session;

/// <summary>UNDO: Undoes a number of steps.</summary>
internal sealed class UndoCommand : ICommand
{
    public CommandInfo Info { get; } = new("UNDO", CommandGroup.File);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var count = await context.ValueAsync(new NumberPrompt(Wording.Get("Undo.EnterNumber")) { Default = "1", Least = 1, Most = 32767, Whole = true }).ConfigureAwait(false);
        for (var step = 0; step < count; step++)
        {
            if (context.Document.Undo() is not { } name)
            {
                context.Say(Wording.Get("Undo.EverythingHasBeenUndone"));
                return;
            }

            context.Say(TextCatalogue.Fact(name));
        }
    }
}

/// <summary>REDO: Repeats the step that was undone last.</summary>
internal sealed class RedoCommand : ICommand
{
    public CommandInfo Info { get; } = new("REDO", CommandGroup.File);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.Say(context.Document.Redo() is { } name ? TextCatalogue.Fact(name) : Wording.Get("Undo.EverythingHasBeenRedone"));
        return Task.CompletedTask;
    }
}

/// <summary>U: Undoes the last step.</summary>
internal sealed class UCommand : ICommand
{
    public CommandInfo Info { get; } = new("U", CommandGroup.File);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        context.Say(context.Document.Undo() is { } name ? TextCatalogue.Fact(name) : Wording.Get("Undo.EverythingHasBeenUndone"));
        return Task.CompletedTask;
    }
}
