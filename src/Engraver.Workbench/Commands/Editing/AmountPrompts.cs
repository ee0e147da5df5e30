using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>The questions that ROTATE and SCALE have in common: an amount, or <c>[Copy/Reference]</c> as in AutoCAD.</summary>
internal static class AmountPrompts
{
    /// <returns>The amount; with a reference, the new value and the value it replaces. Copy is true when the source stays.</returns>
    public static async Task<(double Value, double? Reference, bool Copy)> AskAsync(CommandContext context, AmountPrompt amount, AmountPrompt reference, AmountPrompt changed)
    {
        var asked = amount with { Options = Keyword.List("Copy", "Reference") };
        var copy = false;
        while (true)
        {
            switch (await context.AskAsync(asked).ConfigureAwait(false))
            {
                case Answer<Amount>.Value { Of: Amount.Number { Of: var value } }:
                    return (value, null, copy);
                case Answer<Amount>.Chosen { Option: "Reference" }:
                    var from = await NumberAsync(context, reference).ConfigureAwait(false);
                    return (await NumberAsync(context, changed).ConfigureAwait(false), from, copy);
                default:
                    copy = true;
                    break;
            }
        }
    }

    /// <summary>The amount as a number; of a vector whose first point was given, the second point is asked for.</summary>
    private static async Task<double> NumberAsync(CommandContext context, AmountPrompt prompt)
    {
        while (true)
        {
            switch (await context.ValueAsync(prompt).ConfigureAwait(false))
            {
                case Amount.Number { Of: var value }: return value;
                case Amount.Beginning { At: var place }: prompt = prompt with { Instruction = Wording.Get("Common.SpecifySecondPoint"), Default = null, From = place }; break;
            }
        }
    }
}
