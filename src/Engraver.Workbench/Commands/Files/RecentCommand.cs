using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Files;

/// <summary>RECENT: Lists the recently opened drawings, and opens one of them.</summary>
internal sealed class RecentCommand : ICommand
{
    public CommandInfo Info { get; } = new("RECENT", CommandGroup.File) { ReplacesDrawing = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var files = context.Settings.Current.RecentFiles;
        if (files.Count == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("Recent.Empty"));
        context.WriteResult(output => Write(files, output));
        var prompt = new NumberPrompt(Wording.Get("Recent.EnterNumber")) { EnterEnds = true, Min = 1, Max = files.Count, IsInteger = true };
        if (await context.AskAsync(prompt).ConfigureAwait(false) is Answer<double>.Value { Result: var number }) DrawingOpening.Open(context, files[(int)number - 1], files[(int)number - 1], cancellation);
    }

    private static void Write(IReadOnlyList<string> files, TextWriter output)
    {
        for (var i = 0; i < files.Count; i++) output.WriteLine(Wording.Get("Recent.Row", i + 1, files[i]));
    }
}
