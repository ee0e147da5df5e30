using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>The two senses of a motor or an encoder.</summary>
internal static class SensePrompt
{
    private static readonly IReadOnlyList<Keyword> s_senses = Keyword.List("Normal", "Reversed");

    public static async Task<bool> AskAsync(CommandContext context, string instruction, bool isReversed) =>
        await context.ChoiceAsync(instruction, s_senses, isReversed ? "Reversed" : "Normal").ConfigureAwait(false) == "Reversed";
}
