using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Commands.Files;

/// <summary>Writes a result to a file, or to the command window when Enter alone is typed.</summary>
internal static class ResultFile
{
    /// <remarks>A script overwrites its results without a question.</remarks>
    /// <param name="kind">Kind of file, an internal key.</param>
    /// <param name="ending">File extension with its dot.</param>
    /// <returns>The file name as typed; null for the command window.</returns>
    /// <exception cref="CommandException">The operator declined to replace an existing file.</exception>
    public static async Task<string?> WriteAsync(CommandContext context, string kind, string ending, Action<TextWriter> write)
    {
        var wanted = new FileRequest(kind, true, ending) { Suggested = context.PathBesideDrawing(ending), CanDisplayInstead = true };
        var answer = await context.AskAsync(new FilePrompt(Wording.Get("ResultFile.EnterFileName"), wanted) { EnterEnds = true }).ConfigureAwait(false);
        if (answer is Answer<string>.Value { Result: var name })
        {
            if (!context.IsScripted) await ReplacePrompt.ConfirmAsync(context, context.ResolveOutputPath(name), name).ConfigureAwait(false);
            OutputFile.Write(context.ResolveOutputPath(name), write);
            context.WriteMessage(Wording.Get("ResultFile.Written", name));
            return name;
        }

        context.WriteResult(write);
        return null;
    }
}
