using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>The questions that ROTATE and SCALE have in common: an amount, or <c>[Copy/Reference]</c> as in AutoCAD.</summary>
internal static class AmountPrompts
{
    /// <returns>The amount; with a reference, the new value and what it is new to. Copy: the source stays.</returns>
    public static async Task<(double Value, double? Reference, bool Copy)> AskAsync(CommandContext context, NumberPrompt amount, NumberPrompt reference, NumberPrompt changed)
    {
        var asked = amount with { Options = Keyword.List("Copy", "Reference") };
        var copy = false;
        while (true)
        {
            switch (await context.AskAsync(asked).ConfigureAwait(false))
            {
                case Answer<double>.Value { Of: var value }:
                    return (value, null, copy);
                case Answer<double>.Chosen { Option: "Reference" }:
                    var from = await context.ValueAsync(reference).ConfigureAwait(false);
                    return (await context.ValueAsync(changed).ConfigureAwait(false), from, copy);
                default:
                    copy = true;
                    break;
            }
        }
    }
}
