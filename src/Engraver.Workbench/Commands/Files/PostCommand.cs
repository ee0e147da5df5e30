using Engraver.Core.Diagnostics;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;

namespace Engraver.Workbench.Commands.Files;

/// <summary>POST: Writes the job as a program for the controller.</summary>
internal sealed class PostCommand : ICommand
{
    public CommandInfo Info { get; } = new("POST", CommandGroup.Output);

    private static readonly IReadOnlyList<Keyword> s_targets = Keyword.List([.. PostTable.All.Select(entry => entry.Keyword)]);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var target = await context.ChoiceAsync(Wording.Get("Post.EnterTarget"), s_targets, context.Remembered("POST", PostTable.All[0].Keyword)).ConfigureAwait(false);
        context.Remember("POST", target);
        var (post, _, reader) = PostTable.Find(target);
        var posted = PostedProgram.Create(drawing, context.Document.Current.Settings, post, PostedProgram.NoOptions);
        FindingMessages.Say(context, drawing.FileName, posted.Diagnostics, Severity.Warning);
        if (posted.Text is not { } text) throw new CommandException(CommandFailure.Drawing, $"{posted.WithoutProgram}.");
        var name = await ResultFile.WriteAsync(context, "program", post.Ending, output => output.Write(text)).ConfigureAwait(false);
        if (name is not null && reader is not null) context.Remember(VerifyCommand.Name, name);
        context.Remember(HistoryEntry.OfPost(drawing.FileName, context.Document.Current.Settings, post.Name, name is null ? null : context.FileToWrite(name), context.Time.GetUtcNow()));
    }
}
