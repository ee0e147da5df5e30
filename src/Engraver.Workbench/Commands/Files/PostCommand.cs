using Engraver.Core.Diagnostics;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Files;

/// <summary>POST: Writes the job as a program for the controller.</summary>
internal sealed class PostCommand : ICommand
{
    public CommandInfo Info { get; } = new("POST", CommandGroup.Output);

    private static readonly IReadOnlyList<Keyword> s_targets = Keyword.List([.. PostTable.Choices.Select(choice => choice.Keyword)]);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var target = await context.ChoiceAsync(Wording.Get("Post.EnterTarget"), s_targets, context.LastValue("POST", PostTable.All[0].Keyword)).ConfigureAwait(false);
        context.Remember("POST", target);
        var choice = PostTable.Choices.First(one => one.Keyword == target);
        await WriteAsync(context, choice.Entry, choice.Options).ConfigureAwait(false);
    }

    /// <summary>Writes the job of the open drawing and adds it to the history.</summary>
    /// <param name="options">All options of the post.</param>
    /// <exception cref="CommandException">The machine can cut no part of the drawing.</exception>
    public static async Task WriteAsync(CommandContext context, PostEntry entry, IReadOnlyDictionary<string, string> options)
    {
        var (drawing, settings, post) = (context.Drawing, context.Document.Current.Settings, entry.Post);
        var posted = PostedProgram.Create(drawing, settings, post, options, context.PlateValues);
        FindingMessages.Write(context, drawing.FileName, posted.Diagnostics, Severity.Warning);
        if (posted.Text is not { } text) throw new CommandException(CommandFailure.Drawing, $"{posted.NoProgramReason}.");
        var name = await ResultFile.WriteAsync(context, "program", post.FileExtension, output => output.Write(text)).ConfigureAwait(false);
        if (name is not null) ProgramStart.Save(context.ResolveOutputPath(name), posted.Forecast);
        if (name is not null && entry.Reader is not null) context.Remember(VerifyCommand.Name, name);
        context.Remember(HistoryEntry.OfPost(drawing, settings, post.Name, options, name is null ? null : context.ResolveOutputPath(name), context.Time.GetUtcNow()));
    }
}
