using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Commands.Files;

/// <summary>Asks for a file to write, and again before an existing file is replaced.</summary>
internal static class ReplacePrompt
{
    /// <param name="adds">The default extension is added to a name without one.</param>
    /// <exception cref="CommandException">The operator declined.</exception>
    public static async Task<string> AskAsync(CommandContext context, string instruction, FileRequest wanted, bool adds = false)
    {
        var typed = await context.ValueAsync(new FilePrompt(instruction, wanted)).ConfigureAwait(false);
        var name = adds ? wanted.WithExtension(typed) : typed;
        await ConfirmAsync(context, context.ResolveOutputPath(name), name).ConfigureAwait(false);
        return name;
    }

    /// <summary>Asks before an existing file is replaced; devices and pipes are written without a question.</summary>
    /// <exception cref="CommandException">The operator declined.</exception>
    public static async Task ConfirmAsync(CommandContext context, string path, string name)
    {
        if (File.Exists(path) && !FileKind.IsStream(path)) await context.ConfirmReplaceAsync(name, Wording.Get("ResultFile.ReplaceExisting", name)).ConfigureAwait(false);
    }
}
