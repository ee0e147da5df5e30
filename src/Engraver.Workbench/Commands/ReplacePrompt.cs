using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>Asks for a file to write, and before one that is there already is replaced.</summary>
internal static class ReplacePrompt
{
    /// <exception cref="CommandException">The operator does not want it replaced.</exception>
    public static async Task<string> AskAsync(CommandContext context, string instruction)
    {
        var name = await context.ValueAsync(new TextPrompt(instruction)).ConfigureAwait(false);
        if (File.Exists(context.FileToWrite(name)) && !await context.ConfirmAsync($"{name} is there already. Replace it?").ConfigureAwait(false)) throw new CommandException(CommandFailure.Usage, $"{name} was not replaced.");
        return name;
    }
}
